// The packed density map of Jahrmann and Wimmer 2013, section 4.1.1: one image whose red is how densely blades grow,
// green which of them coarse views draw (reflections), and blue the blades' height there. Sward keeps density with a
// species and height with the field, as two maps. Its coarse versions are even choices of the blades that grow
// (scene/unique.h), not painted: green is written as their density, and read over. Does not: flip or scale by itself;
// ImportOptions say so, as of other maps (project/import.h).
#pragma once
#include "project/import.h"

namespace sward {

struct PackedMaps {
    Map density;             // red, 16 bits
    Map bladeHeight;         // blue, 8 bits
    bool ownCoarse = false;  // green is not kCoarseShare of red: it said more than is kept (kGreenNotKept)
};
inline constexpr const char* kGreenNotKept =
    "its green channel is not kept: coarse views (reflections) draw an even choice of the blades everywhere";
// Green as it is written, as a share of red: every fourth blade.
inline constexpr float kCoarseShare = 0.25f;

// Takes apart an image with red, green and blue; alpha is read over. Errors of readMap; Unsound: another number of
// channels.
Result<PackedMaps> readPacked(const std::filesystem::path& file, bool flip,
                              std::vector<std::string>* repaired = nullptr);

// Where the packed map of a density map goes to and comes from: that map, and its field's bladeHeight.
// Usage error if `density` is no species' density map.
Result<ConstFieldRef> bladeHeightBeside(const Project& p, std::span<const ComponentRow> rows,
                                        const ConstFieldRef& density);

// Reads FILE into the density map called `mapName` and into its field's blade heights, which then repeat as the density
// does. In memory; on failure nothing changes.
Status importPacked(Project& p, std::span<const ComponentRow> rows, const std::string& mapName,
                    const std::filesystem::path& file, const ImportOptions& options = {},
                    std::vector<std::string>* repaired = nullptr);

// Writes both as one image of 16 bits in the density's size (PNG, TIFF) or of floats (EXR); what is absent is 1. Usage
// error if both are absent, or repeat differently.
Status exportPacked(const Project& p, std::span<const ComponentRow> rows, const std::string& mapName,
                    const std::filesystem::path& file, const ImportOptions& options = {});

}  // namespace sward
