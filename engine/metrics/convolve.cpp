#include "metrics/convolve.h"

#include <cmath>

#include "core/jobs.h"

namespace sward {
namespace {

size_t at(int x, int y, int width) {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
}

template <class T>
PlaneOf<T> along(const PlaneOf<T>& p, const Taps& taps, int dx, int dy) {
    PlaneOf<T> out{p.width, p.height, std::vector<T>(p.values.size())};
    const int radius = static_cast<int>(taps.size() / 2);
    parallelFor(static_cast<size_t>(p.height), [&](size_t row) {
        const int y = static_cast<int>(row);
        std::vector<double> sums(static_cast<size_t>(p.width), 0);
        for (int k = -radius; k <= radius; ++k) {
            const double weight = taps[static_cast<size_t>(k + radius)];
            const T* from = &p.values[at(0, std::clamp(y + k * dy, 0, p.height - 1), p.width)];
            for (int x = 0; x < p.width; ++x)
                sums[static_cast<size_t>(x)] += weight * from[std::clamp(x + k * dx, 0, p.width - 1)];
        }
        for (int x = 0; x < p.width; ++x) out.values[at(x, y, p.width)] = static_cast<T>(sums[static_cast<size_t>(x)]);
    });
    return out;
}

}  // namespace

Taps gaussianTaps(double sigma, int radius) {
    Taps taps;
    double sum = 0;
    for (int i = -radius; i <= radius; ++i) sum += taps.emplace_back(std::exp(-i * i / (2 * sigma * sigma)));
    for (double& t : taps) t /= sum;
    return taps;
}

template <class T>
PlaneOf<T> convolve(const PlaneOf<T>& plane, const Taps& across, const Taps& down) {
    return along(along(plane, across, 1, 0), down, 0, 1);
}
template PlaneOf<float> convolve(const PlaneOf<float>&, const Taps&, const Taps&);
template PlaneOf<double> convolve(const PlaneOf<double>&, const Taps&, const Taps&);

}  // namespace sward
