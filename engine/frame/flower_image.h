// What a kind of flowers looks like: its image, and how many stand in a cell. Read by grass/flowers and by the
// reference.
#pragma once
#include "frame/color_image.h"
#include "scene/project.h"

namespace sward {

// A daisy: its top square the head, below it the stem with two leaves. Red: share of petal; green: share of centre;
// blue: half of how light it is; linear values, encoded as sRGB.
Rgba8 makeFlowerImage(int width, int height);

struct FlowerImage {
    Rgba8 pixels;
    bool made = true;     // by makeFlowerImage
    float headShare = 1;  // of its height, from the top
};
// The component's own, or the made one, which stands in (with a warning) for a file that cannot be read.
FlowerImage flowerImage(const Project& p, const Flowers& f);

// A grid's cell, which holds 16 flowers of density 1, or so many as fit 0.25 to 64 m.
struct FlowerGrid {
    double side;     // metres
    float expected;  // flowers in a cell at density 1
    uint32_t most;   // numbers that may exist
};
// The grid of flowers of this density: the same for all who draw or trace them.
FlowerGrid flowerGrid(const Flowers& f);

// The entity whose field of grass the flowers of an entity stand among, which bends, lowers and shades them: their own
// entity's, else the first by name. Empty: no grass grows.
std::string grassAmong(const Project& p, const std::string& flowers);

// Every entity's that has any, in the order of their names.
std::vector<std::pair<std::string, const Flowers*>> flowersOf(const Project& p);

}  // namespace sward
