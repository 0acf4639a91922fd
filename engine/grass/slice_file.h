// Slices in a file of the bake cache.
// A file is named by the hash of all that its slices were made from, and ends with the hash of its bytes: one that is
// truncated, damaged or of another version is made anew, and said.
// Does not: make slices (slice_bake.h), nor know textures (slice_textures.h).
#pragma once
#include <filesystem>
#include <optional>

#include "grass/slice_bake.h"

namespace sward {

// Where the slices of this key are kept in a cache folder.
std::filesystem::path sliceFile(const std::filesystem::path& folder, uint64_t key);
// The cached slices, or nothing if there are none. What is wrong with a file that is there is logged; it is removed.
std::optional<SliceImages> loadCachedSlices(const std::filesystem::path& folder, uint64_t key);
// Failing to write (a full disk, a read-only home) is logged, and otherwise ignored: it costs time, not work.
void cacheSlices(const std::filesystem::path& folder, uint64_t key, const SliceImages& images);

}  // namespace sward
