// Appearance: how far apart two pictures of grass look, whichever blade stands where. The metric that Sward ranks by.
// Grass is texture. A metric of pixels (RMSE, and in part SSIM and FLIP) calls other blades of the same field a larger
// error than flat green, and so rewards blur. This one compares what a block of pixels looks like: its mean and its
// contrast.
//   Blocks: squares of 4, 8 and 16 pixels from the top left corner; those at the right and lower edge are cut off.
//   In a block, per sRGB channel, over pixels by their weight w (share of grass):
//     mean m = sum w v / sum w, deviation s = sqrt(sum w (v - m)^2 / sum w), in image and in truth;
//     distance d = sqrt((m_image - m_truth)^2 + (s_image - s_truth)^2).
//   The scatter of a traced picture's rays is no contrast of its scene: where it is known (Picture::noise, variance n a
//   pixel), s^2 is less by what it adds in the mean, sum w n / sum w - sum w^2 n / (sum w)^2, but not below 0, and more
//   by the variance that s itself has by it, so that the mean of s is right; and squared differences are less by the
//   variances that scatter gives them, but not below 0, since it would set equal pictures apart.
//   Appearance is the mean of d over channels, over blocks by their weight, and over the three sizes: 0 to about 1.
//   bias is the same mean of |m_image - m_truth|, contrast that of |s_image - s_truth|. Neither exceeds the appearance,
//   which does not exceed their sum.
// Source: ours; means and deviations of blocks as in Wang et al. 2004 (luminance and contrast, without structure).
// Does not: see what is smaller than a block in where it lies, which is the point. Cost: 10 ms at 1024x768.
#pragma once
#include "metrics/picture.h"

namespace sward {

inline constexpr int kAppearanceBlocks[] = {4, 8, 16};

struct Appearance {
    double distance = 0, bias = 0, contrast = 0;
    // Standard error of the distance, by a jackknife that leaves out one block of 16 pixels at a time: how far it would
    // move if the picture held other ground of the same kind. Not-a-number with fewer than two blocks.
    double sigma = 0;
};
// Over all pixels that count; distance 0 for equal pictures.
Appearance appearance(const PicturePair& pair);
// The distance at each pixel: of the blocks of the three sizes that it lies in.
ErrorMap appearanceMap(const PicturePair& pair);

// Deviation of values which rays scatter, beside that scatter.
struct Deviation {
    glm::dvec3 variance;   // without it
    glm::dvec3 deviation;  // no less than what of the scatter is left in it
    glm::dvec3 noise;      // variance of `deviation` by the scatter
};
// squares: mean square of the values about their mean; scatter: mean of their variances by rays; meanNoise: variance of
// their mean by rays. The noise is that of normal scatter, by the derivative of the root.
Deviation deviationBeside(const glm::dvec3& squares, const glm::dvec3& scatter, const glm::dvec3& meanNoise);
// How far apart two numbers are whose difference has a variance of `noise` by rays.
glm::dvec3 apart(const glm::dvec3& difference, const glm::dvec3& noise);

// Mean and deviation by channel of the pixels of one block, by their weight, the deviation without the scatter of rays.
// Channels in [0,1].
struct BlockMoments {
    double weight = 0;
    glm::dvec3 mean{0}, deviation{0};
    glm::dvec3 meanNoise{0}, deviationNoise{0};  // their variances by the scatter of rays
};
// Of the square with its first pixel at (x0, y0), cut at the picture's edges. Weight 0: no pixel of it counts.
BlockMoments blockMoments(const Picture& picture, const std::vector<float>& weight, int x0, int y0, int side);

}  // namespace sward
