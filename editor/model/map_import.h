// Images into the open project's maps, each one undo step: a whole map, or heights into a rectangle of the ground.
// Does not: ask a person (panels/image_dialog.cpp, panels/height_placing.cpp), nor read packed maps.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>

#include "model/document.h"

namespace sward {

struct ImageWay {
    bool flipX = false, flipZ = false;               // columns, rows the other way round
    std::optional<std::pair<double, double>> range;  // as ImportOptions has it (project/import.h)
};
// The file as the texels of a map, as `sward import` takes it; heights' range goes with it. Errors as readImport.
Status importImage(Document& document, const std::string& mapPath, const std::string& file, const ImageWay& way);

// A picture of heights over a rectangle of the terrain.
struct HeightPlace {
    glm::dvec2 at{0}, size{1};  // metres: the corner of least x and z, and how far it goes
    double low = 0, high = 10;  // metres of 0 and full scale of integers; floats are metres
    bool flipX = false, flipZ = false;
    float falloff = 0.2f;  // [0,1]: over how much of the way to its middle the picture fades in
};
// What the ground at a place on the terrain (metres) becomes where it was `before` metres high; `texel`: metres
// between two samples of the ground, over which a finer picture is averaged.
double placedHeight(const Map& source, const HeightPlace& place, double x, double z, double before, double texel);
// Reads a picture of heights: one channel, 16 bit or floats. Unsound errors as readMap.
Result<Map> readHeights(const std::string& file);
// Sets the ground below the rectangle, resampled; makes heights where there are none. `beyond`: gets how many texels
// lay beyond the range of 16 bits and took its end. Usage if the rectangle is empty or beside the terrain, a number is
// not finite, or the heights repeat.
Status placeHeights(Document& document, const Map& source, const HeightPlace& place, size_t* beyond = nullptr);

}  // namespace sward
