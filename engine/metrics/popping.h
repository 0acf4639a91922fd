// Popping: how differently pictures change along a path of the camera from how the truth does; too little change is as
// wrong as too much. It is the appearance (appearance.h) of changes:
//   For each step from one picture to the next, each block of 4 pixels, and each channel: the change of the block's
//   mean and that of its deviation, in image and in truth. In each cell of 16 pixels, over its blocks by their weight:
//   mean m and deviation s of either change;
//     distance = sqrt of the sum, over both changes, of (m_image - m_truth)^2 + (s_image - s_truth)^2,
//   averaged over channels and over cells by their share of grass. That, or the difference of how much image and truth
//   change in all (root mean square over blocks and channels of both changes), whichever is more, is a step's popping.
// Which blade moves where is not compared, only by how much blocks change, together and apart. So a constant error of
// colour or contrast counts nothing, equal sequences have 0, other blades of the same field little (the floor to hold a
// technique against), and a picture that stands still all that the truth changes. What rays scatter is no change: it is
// taken off s^2 and off both squares of the distance where it is known (Picture::noise; of rays that differ from
// picture to picture). Source: ours. Does not: follow blades from picture to picture.
#pragma once
#include <functional>

#include "metrics/picture.h"

namespace sward {

inline constexpr int kPoppingBlock = 4, kPoppingCell = 16;  // pixels a side

struct Popping {
    double mean = 0;     // over the steps
    double worst = 0;    // of one step
    int worstStep = -1;  // from picture worstStep to the next
    std::vector<double> steps;
    // How much the pictures change as a share of what the truth does, root mean square over blocks and steps: 1 as
    // much, 0 not at all; not-a-number where the truth does not change.
    double change = 0;
};
// Pictures 0 to n-1 of one path, asked for in order, at least two, of one size; two are held at a time. A pixel counts
// by the smaller of its weights before and after a step; a step in which none counts has 0. Failed if there are fewer
// than two, or their sizes differ; else what a picture fails with.
Result<Popping> popping(size_t pictures, const std::function<Result<PicturePair>(size_t)>& picture);

}  // namespace sward
