// The images of a species' slices, drawn from its patch: half-open slabs of the patch and its eight neighbours, seen
// orthographically. Source: Boulanger, Pattanaik and Bouatouch 2006, section 3.3; B-13, B-14, B-25, B-26.
// Drawn on the CPU, on all its threads: the same on every machine, beside whatever else runs, and it can be cancelled.
// Does not: touch GL or files. Cost: the paper's 20 slices of 512 x 64 and one of 512 x 512 over 22,000 blades take
// about 2 s on two cores, in which it fills 30 million samples.
//
// What is stored ("factored"): the paper keeps an image of reflected colour for each of 5 lights and 2 views. Lambert's
// colour is reflectance times a number that depends on the light, so reflectance is kept once, and a number for each
// light and view. Seen along an axis, a blade never reflects light that comes from straight behind it: 4 numbers a view
// are left. The numbers of the other view at the same texel are those of the light that shines through the blade; the
// difference of the numbers of opposite lights is a component of the normal. Shadows of blades on blades are in these
// numbers (section 3.5). Light from the side is let in as at 35 degrees: on the horizon, where the images' lights
// stand, dense grass would let none in, and no weighting could bring it back.
#pragma once
#include <cstdint>
#include <vector>

#include "core/error.h"
#include "core/jobs.h"
#include "frame/color_image.h"
#include "grass/slice_settings.h"
#include "scene/population.h"

namespace sward {

struct SliceSpec {
    Species species;  // its maps are not read
    float cellSize = 0.5f;
    uint32_t seed = 1;
    int slices = 10;               // along x, and as many along z
    int width = 256, height = 64;  // texels of a vertical slice; made powers of two
    int farSize = 256;             // texels of the horizontal slice; likewise
    Rgba8 blade;                   // shape and veins of a blade
    int shadowMask = 0;            // width of the mask by which blades shade blades; 0: none
};
// Hash over all that bakeSlices reads.
uint64_t sliceKey(const SliceSpec& spec);

// One mip level of all layers, layer after layer, rows from the ground up (vertical) or from z = 0 (horizontal).
struct SliceLevel {
    int width = 0, height = 0;
    std::vector<uint8_t>
        reflectance;  // RGBA: reflectance / reflectScale, not premultiplied; share of ambient light that reaches it
    std::vector<uint8_t> threshold;  // RGBA: threshold * opacity (of blades that cover each other, the least), opacity,
                                     // light from above on the front and on the back
    std::vector<uint8_t>
        front;  // RGBA: vertical: light that faces it, 0, from the side's + and -; horizontal: x+, x-, z+, z-
    std::vector<uint8_t> back;  // light for the view from the other side, as front
    // Light's numbers hold what is left of it: by the blades' shadow mask if there is one, else by the depth below the
    // tips.
};
struct SliceImages {
    int slices = 0;
    float top = 0;  // metres: height of the vertical slices
    float reflectScale = 1;
    std::vector<SliceLevel> vertical;  // layers 0..slices-1 cut x, the others z; level 0 first
    std::vector<SliceLevel> far;       // one layer
    // Bytes of all images, levels included.
    size_t bytes() const {
        size_t n = 0;
        for (const auto* levels : {&vertical, &far})
            for (const SliceLevel& l : *levels)
                n += l.reflectance.size() + l.threshold.size() + l.front.size() + l.back.size();
        return n;
    }
};

// Failed only if cancelled. A species without blades gives slices of opacity 0.
Result<SliceImages> bakeSlices(const SliceSpec& spec, JobControl& control);

}  // namespace sward
