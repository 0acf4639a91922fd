// The viewport's parts: what it looks at, what the hand does there, the picture on the screen, and what it counts.
// Does not: draw or take input (panels/viewport_scene.h, panels/viewport_input.h).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/layout.h"
#include "app/long_frame.h"
#include "app/resolution.h"
#include "cost/frame_stats.h"
#include "frame/renderer.h"
#include "scene/components.h"
#include "tools/camera_control.h"
#include "world/view_camera.h"

namespace sward {

class Document;

struct ViewState {
    FlyCamera camera;
    float pathSecond = 0;  // where the inspector last moved it along a path
    ViewMode mode = ViewMode::Final;
};

// What the left, right or middle button is doing in the viewport since it went down there.
enum class Gesture { None, Look, Orbit, Pan, Paint, Ring, Split, Choose, Gizmo, Path };
struct ViewportHand {
    Rect rect;  // of the image, window coordinates
    bool hovered = false;
    std::optional<glm::dvec3> ground;  // under the pointer
    Gesture gesture = Gesture::None;
    // World points of the ground: where the present or last stroke began, and where the last one got to.
    std::optional<glm::dvec3> strokeBegin, strokeEnd;
    std::optional<Terrain> groundBefore;  // the ground that a stroke under way began on
    bool flying = false;                  // keys move the camera in this frame
    double lastX = -1, lastY = -1;        // pointer at the last step of the gesture
    double way = 0;                       // pixels that it has gone since the gesture began
};

inline constexpr uint64_t kNeverDrawn = ~uint64_t(0);

struct ViewportPicture {
    Resolution resolution;
    LongFrame longFrame;                           // live, on a software renderer
    unsigned texture = 0, target = 0, source = 0;  // GL texture on the screen, and how it is written
    int width = 0, height = 0;
    int skipped = 0;       // frames that showed an old image because input was waiting
    bool refined = false;  // in this frame pieces of the full picture were drawn
    // What the image on the screen shows.
    uint64_t drawnRevision = kNeverDrawn;
    uint64_t begunRevision = kNeverDrawn;  // of what frames that add up show
    ViewCamera drawnCamera;
    ViewSettings drawnSettings;
    bool hasImage = false;
};

struct ViewCounts {
    bool measure = false;        // the profiler's: passes are timed and their work is counted
    double lastMs = 0;           // of the last drawing, all its parts together
    FrameStats stats;            // of the same
    double bladesVirtual = 0;    // the population, counted at rest
    uint64_t bladesVisible = 0;  // counted at rest while measuring
    uint64_t populationRevision = kNeverDrawn, countedRevision = kNeverDrawn;
    // By species, counted at rest while they are in sight.
    std::vector<SpeciesBlades> species;
    bool wantsSpecies = false;  // the profiler's list was drawn in the last frame
    uint64_t speciesRevision = kNeverDrawn;
    ViewCamera speciesCamera;  // that they were counted for
};

// Moves the view to a camera of the project. False if there is none of this name.
bool goToCamera(const Document& document, const std::string& name, FlyCamera& view);

}  // namespace sward
