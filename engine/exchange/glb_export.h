// A scene as one .glb file for other programs: the ground in chunks, objects, lights (KHR_lights_punctual), cameras,
// and what grows as instances (EXT_mesh_gpu_instancing: Khronos, 2022), one node for each species in each cell. Blades
// are those that the ray-traced truth has at scene time 0, every one: a blade's instance puts root, tip and width where
// they are; between them it has its species' mean curve and colours, and the outline of its image. A flower is a stem
// and a head that faces up its stem. Does not: sky, fog, wind, water, images of the ground (its colours are the
// vertices'), a blade's own hue, paths of cameras. Cost: 40 bytes and about 1 us a blade.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/jobs.h"
#include "scene/project.h"

namespace sward {

inline constexpr size_t kMaxGlbBlades = 2'000'000;  // blades and flowers of one file; 80 MB
inline constexpr int kGroundQuads = 1024;           // a side at most, of the whole ground
inline constexpr int kChunkQuads = 128;             // a side at most, of one mesh of it

struct GlbOptions {
    std::optional<double> bladesWithin;  // metres from the camera, seen from above; none: all that grow
    std::string camera;                  // by whose eye they are measured; empty: the first by name
    size_t mostBlades = kMaxGlbBlades;
};
// What a file holds; scattered: objects that Scatters put there, and trees of Forests. Growth counts single blades and
// flowers, cells the nodes that instance them.
struct GlbCounts {
    size_t blades = 0, flowers = 0, cells = 0;
    size_t chunks = 0, objects = 0, scattered = 0, lights = 0, cameras = 0;
    size_t bytes = 0;
    bool operator==(const GlbCounts&) const = default;
};
// Each number with its name.
std::vector<std::pair<const char*, size_t>> namedCounts(const GlbCounts& counts);
// "12 blades in 3 cells, 0 flowers, ..." in one line.
std::string countsText(const GlbCounts& counts);

struct Glb {
    std::string bytes;
    GlbCounts counts;
};
// The file's bytes, of a project as it is drawn (world/drawn_project.h), checked as checkGlb (glb_check.h) does.
// Errors: Usage: no such camera, or a distance that is none; Failed: more than mostBlades (names the remedy), without
// memory, cancelled; Unsound: a file of the project.
Result<Glb> encodeScene(const Project& p, const GlbOptions& options, JobControl& control);
// What encodeScene refuses that needs no blade to be made, with the same message: in a moment.
Status checkExport(const Project& p, const GlbOptions& options);
// The same into a file, at one instant (writeFileAtomic). The folder must be there. Usage error if `file` does not end
// in .glb; nothing is written then or at any other error.
Result<GlbCounts> exportScene(const Project& p, const GlbOptions& options, const std::filesystem::path& file,
                              JobControl& control);

}  // namespace sward
