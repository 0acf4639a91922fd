// Popping: how much more, or less, pictures change along a path of the camera than the truth does.
// For each step from one picture to the next, and each block of 4, 8 and 16 pixels as in appearance.h: the change of
// the block's mean and of its deviation, in image and in truth, per channel;
//   distance = sqrt((change of mean, image - truth)^2 + (change of deviation, image - truth)^2),
// averaged as the appearance is: over channels, blocks by their share of grass, sizes, and then over the steps.
// A constant error of colour or contrast does not pop and counts nothing; equal sequences have 0. Other blades of the
// same field flicker elsewhere: that sequence's popping is the floor to hold a technique's against. Source: ours. Does
// not: follow blades from picture to picture.
#pragma once
#include <functional>

#include "metrics/picture.h"

namespace sward {

struct Popping {
    double mean = 0;     // over the steps
    double worst = 0;    // of one step
    int worstStep = -1;  // from picture worstStep to the next
    std::vector<double> steps;
};
// Pictures 0 to n-1 of one path, asked for in order, at least two, of one size; two are held at a time. A pixel counts
// by the smaller of its weights before and after a step; a step in which none counts has 0. Failed if there are fewer
// than two, or their sizes differ; else what a picture fails with.
Result<Popping> popping(size_t pictures, const std::function<Result<PicturePair>(size_t)>& picture);

}  // namespace sward
