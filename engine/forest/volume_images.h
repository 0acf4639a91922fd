// A forest's volume as the GPU and the disk keep it: bytes of all slabs with their mips, and all that light needs of
// the air. Kept in the cache folder under a hash of all that it was made from: a file that is truncated, damaged or of
// another version is made anew, and said.
// Does not: fill the volume (volume_bake.h), touch GL (volume.h). Cost: of the 44 MB of 256 x 256 x 64 texels 1 s, and
// 2 s more to compress them.
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/jobs.h"
#include "forest/shade_map.h"
#include "forest/volume_bake.h"

namespace sward {

// What a volume is made from.
struct VolumeSpec {
    ForestTiles tiles;
    std::shared_ptr<const std::vector<Mesh>> meshes;  // by species
    double voxel = 0.25;                              // metres
    bool compressed = false;                          // as blocks (gpu/bc7.h)
};
// Hash over all that bakeVolume reads.
uint64_t volumeKey(const VolumeSpec& spec);

struct VolumeImages {
    int side = 0, layers = 0, cells = 0;  // as ForestVolume
    double edge = 0, height = 0;
    bool compressed = false;
    // By level of the pyramid, then by mip: all its slabs' images, one after the other, sRGB and alpha or blocks.
    std::vector<std::vector<std::vector<uint8_t>>> levels;
    std::vector<uint8_t> slots;
    ForestAir air;
    std::array<std::vector<float>, 2> sky;  // skyThrough(air)
    std::vector<TreeAir> trees;             // by species
    size_t bytes() const;                   // of all levels
};
// Interrupted if cancelled; no other errors.
Result<VolumeImages> bakeVolume(const VolumeSpec& spec, JobControl& control);
// What may be shown until that is there: of fewer, larger leaves, four times as coarse.
VolumeImages draftVolume(const VolumeSpec& spec);

// Where the volume of this key is kept in a cache folder.
std::filesystem::path volumeFile(const std::filesystem::path& folder, uint64_t key);
// The cached volume, or nothing if there is none. What is wrong with a file that is there is logged; it is removed.
std::optional<VolumeImages> loadCachedVolume(const std::filesystem::path& folder, uint64_t key);
// Failing to write (a full disk, a read-only home) is logged, and otherwise ignored: it costs time, not work.
void cacheVolume(const std::filesystem::path& folder, uint64_t key, const VolumeImages& images);
// The cached volume, or else one that is baked and cached.
Result<VolumeImages> volumeOf(const std::filesystem::path& folder, const VolumeSpec& spec, JobControl& control);

}  // namespace sward
