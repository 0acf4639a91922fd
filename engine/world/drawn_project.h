// The project as it is drawn, traced and counted: its maps as painted, with their layers (world/map_stacks.h)
// and then the scene's paths laid over them. What is painted stays as it is in the project itself. Each path acts in
// the order of entities' names: on the densities of grass and flowers, and on the terrain's colours.
// A map keeps its size in texels, and a path is as fine as they are. Where there is none, and where one repeats, the
// copy has one that lies on the terrain once, of at most 4096 texels a side.
// Cost: without layers and paths none; with them a copy of all components each time, and about 0.7 us a texel that a
// path reaches, paid anew only for tiles where the painted map or a path has changed.
#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "scene/ground_path.h"
#include "scene/project.h"
#include "scene/tiling.h"
#include "world/map_stacks.h"

namespace sward {

// A path as it acts on one map.
struct PathOver {
    GroundPath path;
    GroundCurve curve;
};

// A map and the paths over it.
struct LaidMap {
    Map painted;                  // as the project has it
    Tiling tiling;                // of that
    glm::dvec2 extent{0};         // metres that base and drawn cover
    Map base;                     // as painted, at the size that is drawn
    std::vector<PathOver> paths;  // that were laid over it
    Map drawn;
};

// Keeps what it made, so that the next time costs what has changed. Thread-safe: no.
class DrawnProject {
  public:
    // `p` itself where no layer and no path changes anything; else a copy, valid until the next call, whose maps lie
    // under the same PATHs.
    const Project& of(const Project& p, std::span<const ComponentRow> rows);
    // What there is to know of the layers of the last call.
    const std::vector<LayerNote>& layerNotes() const { return stacks_.notes(); }

  private:
    MapStacks stacks_;
    std::map<std::string, LaidMap> maps_;  // by PATH
    Project drawn_;
};

// PATHs of maps on which paths would act, but whose repeats take more than 4096 texels a side over the terrain: paths
// leave them alone.
std::vector<std::string> mapsBeyondPaths(const Project& p, std::span<const ComponentRow> rows);
// What to say of one of these.
std::string beyondPaths(const std::string& map);

}  // namespace sward
