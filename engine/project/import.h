// Maps in from files and out to files, for the command line, scripts and the editor. Flip and range are explicit, and
// remembered in the project (Project::imports), so that a second import or an export of the same map need not be told.
// Does not: undo; the editor takes readImport and gives the map to its document.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/error.h"
#include "scene/project.h"

namespace sward {

struct ImportOptions {
    std::optional<bool> flip;  // first row is z = max; absent: as remembered, else false
    // What 0 and full scale of integers stand for, lo < hi; absent: as remembered, else by an R16's sidecar, else none.
    // Heights: integers stay integers and heightRange becomes the range, if the component has one; floats are metres.
    // Other maps: floats from lo to hi become 0 to full scale.
    std::optional<std::pair<double, double>> range;
};

// Reads FILE as the texels of a map field: converted to the field's own type, except heights, which keep theirs.
// `used`: what was applied. Errors of readMap; Usage if the range is empty or not finite.
Result<Map> readImport(const Project& p, const ConstFieldRef& map, const std::filesystem::path& file,
                       const ImportOptions& options, MapImport* used = nullptr,
                       std::vector<std::string>* repaired = nullptr);

// Reads FILE into the map called `mapName` (findMap), in memory; save the project to keep it. A map that had no file
// gets one by mapFileFor. On failure nothing changes.
Status importMap(Project& p, std::span<const ComponentRow> rows, const std::string& mapName,
                 const std::filesystem::path& file, const ImportOptions& options = {},
                 std::vector<std::string>* repaired = nullptr);

// Writes a map as its layers leave it (world/map_stacks.h) to FILE, its format by extension (writeMap). Usage error if
// there is neither a map nor a layer.
Status exportMap(const Project& p, std::span<const ComponentRow> rows, const std::string& mapName,
                 const std::filesystem::path& file, const ImportOptions& options = {});

}  // namespace sward
