// Files into the open project, each as one undo step: an image into a whole map, heights into a rectangle of the
// ground, objects and images into its folder. Does not: ask a person (panels/image_dialog.cpp,
// panels/height_placing.cpp), nor read packed maps.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>

#include "model/document.h"
#include "project/import.h"

namespace sward {

class JobControl;

// Reads an image into a map (findMap), and where its integers span a range that into the field beside it; remembered as
// imports are. `flipX`: columns the other way round. Errors of readImport; then nothing has changed.
Status importIntoMap(Document& document, const std::string& mapPath, const std::filesystem::path& file,
                     const ImportOptions& options = {}, bool flipX = false);
// Sets a field that names an image or an object to this file. One that lies elsewhere is copied into the project's
// folder: objects to models/, images to images/. Errors of importAsset and checkImage; then nothing has changed.
Status chooseFile(Document& document, const std::string& fieldPath, const std::filesystem::path& file);

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
// lay beyond the range of 16 bits and took its end. `control`: told how far it is, and ends it early. Usage if the
// rectangle is empty or beside the terrain, a number is not finite, or the heights repeat.
Status placeHeights(Document& document, const Map& source, const HeightPlace& place, size_t* beyond = nullptr,
                    JobControl* control = nullptr);

}  // namespace sward
