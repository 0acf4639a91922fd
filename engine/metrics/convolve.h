// Separable filters over one plane of values, shared by FLIP and SSIM. Edges repeat the outermost pixel.
// A value that is not a number makes all that its window reaches so. Does not: normalise.
#pragma once
#include <vector>

namespace sward {

template <class T>
struct PlaneOf {
    int width = 0, height = 0;
    std::vector<T> values;
};
using Plane = PlaneOf<float>;
// Weights at -r to r.
using Taps = std::vector<double>;
// e^(-x^2 / (2 sigma^2)) at -r to r, scaled to a sum of 1. sigma in pixels.
Taps gaussianTaps(double sigma, int radius);
// T: float or double.
template <class T>
PlaneOf<T> convolve(const PlaneOf<T>& plane, const Taps& across, const Taps& down);

}  // namespace sward
