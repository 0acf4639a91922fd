#include "metrics/ssim.h"

#include "metrics/convolve.h"

namespace sward {
namespace {

constexpr int kRadius = 5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

// Variances are differences of nearly equal means: float would round them to more than what SSIM adds to them.
using Means = PlaneOf<double>;

// f(luma of the image, luma of the truth) at each pixel, averaged over windows.
template <class F>
Means windowMeans(const PicturePair& p, F&& f) {
    Means plane{p.truth.width, p.truth.height, std::vector<double>(p.truth.pixels.size())};
    const glm::dvec3 luma(0.2126, 0.7152, 0.0722);
    for (size_t i = 0; i < plane.values.size(); ++i)
        plane.values[i] =
            f(glm::dot(glm::dvec3(p.image.pixels[i]), luma), glm::dot(glm::dvec3(p.truth.pixels[i]), luma));
    const Taps window = gaussianTaps(1.5, kRadius);
    return convolve(plane, window, window);
}

}  // namespace

ErrorMap ssimMap(const PicturePair& pair) {
    const Means a = windowMeans(pair, [](double x, double) { return x; }),
                b = windowMeans(pair, [](double, double y) { return y; });
    const Means aa = windowMeans(pair, [](double x, double) { return x * x; }),
                bb = windowMeans(pair, [](double, double y) { return y * y; });
    const Means ab = windowMeans(pair, [](double x, double y) { return x * y; });
    ErrorMap map(a.values.size(), kNoValue);
    for (int y = kRadius; y < a.height - kRadius; ++y)
        for (int x = kRadius; x < a.width - kRadius; ++x) {
            const size_t i = static_cast<size_t>(y) * static_cast<size_t>(a.width) + static_cast<size_t>(x);
            const double ma = a.values[i], mb = b.values[i];
            const double va = aa.values[i] - ma * ma, vb = bb.values[i] - mb * mb, cov = ab.values[i] - ma * mb;
            const double similar =
                (2 * ma * mb + kC1) * (2 * cov + kC2) / ((ma * ma + mb * mb + kC1) * (va + vb + kC2));
            map[i] = std::isnan(similar) ? kNoValue : static_cast<float>(std::clamp(similar, -1.0, 1.0));
        }
    return map;
}

}  // namespace sward
