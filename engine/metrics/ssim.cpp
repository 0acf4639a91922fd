#include "metrics/ssim.h"

#include "metrics/convolve.h"

namespace sward {
namespace {

constexpr int kRadius = 5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

// f(luma of the image, luma of the truth) at each pixel, averaged over windows.
template <class F>
Plane windowMeans(const PicturePair& p, F&& f) {
    Plane plane{p.truth.width, p.truth.height, std::vector<float>(p.truth.pixels.size())};
    const glm::vec3 luma(0.2126f, 0.7152f, 0.0722f);
    for (size_t i = 0; i < plane.values.size(); ++i)
        plane.values[i] = f(glm::dot(p.image.pixels[i], luma), glm::dot(p.truth.pixels[i], luma));
    const Taps window = gaussianTaps(1.5, kRadius);
    return convolve(plane, window, window);
}

}  // namespace

ErrorMap ssimMap(const PicturePair& pair) {
    const Plane a = windowMeans(pair, [](float x, float) { return x; }),
                b = windowMeans(pair, [](float, float y) { return y; });
    const Plane aa = windowMeans(pair, [](float x, float) { return x * x; }),
                bb = windowMeans(pair, [](float, float y) { return y * y; });
    const Plane ab = windowMeans(pair, [](float x, float y) { return x * y; });
    ErrorMap map(a.values.size(), kNoValue);
    for (int y = kRadius; y < a.height - kRadius; ++y)
        for (int x = kRadius; x < a.width - kRadius; ++x) {
            const size_t i = static_cast<size_t>(y) * static_cast<size_t>(a.width) + static_cast<size_t>(x);
            const double ma = a.values[i], mb = b.values[i];
            const double va = aa.values[i] - ma * ma, vb = bb.values[i] - mb * mb, cov = ab.values[i] - ma * mb;
            map[i] = static_cast<float>((2 * ma * mb + kC1) * (2 * cov + kC2) /
                                        ((ma * ma + mb * mb + kC1) * (va + vb + kC2)));
        }
    return map;
}

}  // namespace sward
