// What a glTF file says of itself, held against what can be read before the library sees it: version, counts, lengths.
// A few bytes there may ask for any memory, and numbers below 0 would be taken as huge ones.
// Does not: read what the file holds (mesh_io.h), nor hold offsets against the bytes that there are (there, too).
// Source: The Khronos Group, glTF 2.0 Specification, 3.2 (asset), 3.6 (buffers, accessors), 4.4 (.glb).
#pragma once
#include <string>

#include "core/error.h"

namespace sward {

// Most materials, nodes and so on of a file: each takes the reader up to 3 KB, however short its text is.
inline constexpr size_t kMaxGltfBuffers = 16, kMaxGltfImages = 64, kMaxGltfElements = 65'536;

// Whether the bytes are those of a .glb.
bool isGlb(const std::string& bytes);
// Unsound error with a remedy: no JSON, another version than 2, more of something than the limits, an offset, length,
// stride or count that is no whole number from 0, an extension that is required and not read. `file` names the file.
Status checkGltfHead(const std::string& bytes, const std::string& file);

}  // namespace sward
