// One machine's share of a reference image as a file, and the whole that shares make, bit for bit as one machine's.
// A part: one line of JSON (what it is a part of, and a hash of this and of what follows), then float32, little-endian:
// color, error and grass of its rows from the top.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "reference/reference.h"

namespace sward {

struct ReferencePart {
    std::string camera;
    uint64_t of = 0;  // names project, camera, time and settings but for the shard: parts of one image share it
    ReferenceSettings settings;
    Truth truth;  // other shards' rows are 0
};
// The bytes of the part's file.
std::string encodePart(const ReferencePart& part);
// Unsound error naming the file: unreadable, no part, truncated, any byte another than was written.
Result<ReferencePart> readPart(const std::filesystem::path& file);
// Whether a file begins as a part of a reference does.
bool isReferencePart(const std::filesystem::path& file);
// Failed: parts of different images, one that is there twice, a shard that is missing (each named).
Result<Truth> mergeParts(const std::vector<std::filesystem::path>& files);

}  // namespace sward
