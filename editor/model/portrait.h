// Small pictures of what a person chooses among: objects, image files, painted maps, kinds of grass. Objects and grass
// are traced as the truth is (reference/reference.h), on plain ground in the light of a clear day. Pure: from any
// thread. Does not: hold textures, or say when a picture is made (app/thumbnails.h). Cost: an object or a kind of grass
// 0.3 to 1 s on two cores; an image as long as it takes to read; a map under 1 ms.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/error.h"
#include "core/jobs.h"
#include "frame/color_image.h"
#include "maps/map.h"
#include "scene/map_row.h"
#include "scene/rows.h"

namespace sward {

struct Species;

inline constexpr int kPortraitSide = 128;  // pixels; those of images and maps are as long on their longer side

// An object of a glTF file, `file` relative to `root`. Kept in the cache folder under a hash of what it shows, so that
// the same object is traced once. Errors of readMesh; Failed when cancelled.
Result<Rgba8> portraitOfModel(const std::filesystem::path& root, const std::string& file, const Tables& tables,
                              JobControl& control);
// Blades of one species, as dense as it grows at density 1; its own density map is not asked. Kept likewise. `root`:
// where its texture lies. Failed when cancelled.
Result<Rgba8> portraitOfSpecies(const Species& species, const std::filesystem::path& root, const Tables& tables,
                                JobControl& control);
// Names what portraitOfSpecies would show, but for its texture's bytes; cheap enough for every frame.
uint64_t portraitKey(const Species& species, const Tables& tables);
// A PNG, EXR or TIFF, made small row by row: its size costs time, not memory. Floats go from their least to their most.
// Errors of ImageReader::open.
Result<Rgba8> portraitOfImage(const std::filesystem::path& file, const JobControl& control);
// Amounts in grey; heights in grey from the lowest to the highest; colours as opaque as they are; directions and forces
// as the map holds them. The map is not empty.
Rgba8 portraitOfMap(const Map& map, MapKind kind);

}  // namespace sward
