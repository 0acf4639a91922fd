// Draws a project's views: plan, effect state, passes, statistics. One per open project and GL context.
// Does not: own the context, nor change the project.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/enum_names.h"
#include "core/error.h"
#include "core/jobs.h"
#include "gpu/gpu.h"
#include "gpu/program.h"
#include "scene/project.h"
#include "scene/rows.h"
#include "world/view_camera.h"

namespace sward {

enum class ViewMode { Final, Tiers, Overdraw, Density, Depth, Normals };
inline constexpr auto kViewModes = enumNames<ViewMode>("final", "tiers", "overdraw", "density", "depth", "normals");

// The brush's decal on the terrain; radius 0: none.
struct BrushDecal {
    double x = 0, z = 0;
    float radius = 0;
    float falloff = 0.5f;
};

// A painted map to show as a translucent colour (post/map_overlay.h); no PATH: none.
struct MapOverlay {
    std::string map;    // its PATH
    double tiling = 1;  // its tiling factor (scene/tiling.h)
    bool operator==(const MapOverlay&) const = default;
};

// The part of a larger picture that one draw makes, so that a slow renderer's full picture may be drawn in pieces with
// input taken between; pieces side by side equal the whole. wholeWidth 0: no part, all of it.
struct ViewPart {
    int x = 0, y = 0;  // of the part's lower left corner, in pixels of the whole
    int wholeWidth = 0, wholeHeight = 0;
};

inline constexpr float kLeastDetail = 1.0f / 4096;  // share of the blades that is always drawn

struct ViewSettings {
    int width = 1024, height = 768;
    int msaa = 4;  // or the next that the driver has (Gpu::samplesFor)
    ViewMode mode = ViewMode::Final;
    double time = 0;  // scene seconds
    BrushDecal decal;
    MapOverlay overlay;
    float detail = 1;     // share of the blades drawn, [kLeastDetail, 1]; each wider by so much, at most 6 times: for
                          // views that must be quick
    ViewPart part;        // width and height are then the part's
    bool coarse = false;  // grass by its cheapest tiers, as in water: vertical slices from the eye on, else blades
    glm::vec2 jitter{
        0};  // pixels by which the picture is moved right and up; fractions move samples, so that frames add up
    bool begin = false;  // nothing of earlier pictures goes into this one: the project is another one since
    bool background =
        false;  // what must be made first is made beside, with a draft shown until it is there; else it is waited for
    bool measure = false;  // per-pass ms and counts (slower: a finish after each pass on a software renderer)
    bool counted = false;  // counts of cells and blades are this frame's where the GPU chooses them, too, as they are
                           // if it is measured; else they may be those of up to 16 frames before, and 0 at first
};

struct PassStats {
    std::string name;
    double ms = 0;  // valid if measured
    uint64_t draws = 0, instances = 0, vertices = 0, fragments = 0;
};
struct FrameStats {
    std::vector<PassStats> passes;
    double bladesVirtual = 0;     // the population: density summed over the terrain
    uint64_t bladesGeometry = 0;  // submitted: of the density range, or of the list of those that can be seen
    uint64_t bladesVisible = 0;   // filled by who counts them (cost/frame_stats.h)
    std::vector<std::string> features, programs, systems;  // what ran, if measured
    uint64_t sliceQuads = 0;                               // vertical slices submitted
    uint64_t macroCells = 0;                               // quadtree nodes drawn with the horizontal slice
    uint64_t cells = 0;                                    // drawn this frame
    uint64_t gpuBytes = 0;
    double cpuCullMs = 0;
    bool addsUp = false;  // another draw of the same view would add samples to the picture
    double frameMs = 0;   // wall, with one finish at the end if measured
};

struct LayerNote;

class Renderer {
  public:
    Renderer(Gpu& gpu, const Tables& tables);
    ~Renderer();
    // Draws into a texture of settings' size; resolved, tone-mapped, sRGB-encoded RGBA8, first row at the bottom.
    // Fails if a program does not compile and no earlier version of it did (the message is the compiler's), or, without
    // `background`, if OpenGL refuses a call, after which the picture may be black.
    Status draw(const Project& project, const ViewCamera& camera, const ViewSettings& settings);
    unsigned image() const;                  // GL texture of the last draw
    std::vector<uint8_t> readImage() const;  // RGB8, first row on top
    std::vector<float> readLinear() const;   // RGB floats before tone mapping, first row on top
    const FrameStats& stats() const;
    // Whether another draw of the same view would add samples to the picture (post/antialias.h).
    bool addsUp() const;
    // The project with what changes its maps where it is drawn (world/drawn_project.h), made anew only where it changed
    // since the last draw; valid until the next call or draw.
    const Project& asDrawn(const Project& project);
    // What is made beside the pictures since a draw with `background`; the next draw shows what is finished.
    std::vector<JobNews> jobs() const;
    // What there is to know of the layers over maps (world/map_stacks.h) that the last draw showed.
    const std::vector<LayerNote>& layerNotes() const;
    // Waits for the GPU; for measuring.
    void finish();
    // Recompiles programs whose sources changed; keeps the last good ones. Failures are logged too.
    Reload reloadPrograms();
    // What runs for the project now, and why: the plan as JSON text (explain --json) or for people.
    std::string explain(const Project& project, bool json);
    std::vector<std::string> programNames() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// One settled picture, begun anew: Renderer::draw, and as often again as that adds samples.
Status drawSettled(Renderer& renderer, const Project& project, const ViewCamera& camera, const ViewSettings& settings);

// Eye-relative world to clip: reversed depth, far plane at infinity.
glm::mat4 viewProjection(const ViewCamera& camera, int width, int height);
// Height of the picture that the settings are for or a part of.
int wholeHeight(const ViewSettings& s);
// Pixels that a metre across the view takes at a distance of one metre.
float pixelsPerMetre(const ViewCamera& camera, int height);

}  // namespace sward
