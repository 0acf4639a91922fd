#include "maps/distances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sward {
namespace {

// Squared distances along a line, each the least of from[q] + (p - q)^2: the lower envelope of parabolas (Felzenszwalb
// and Huttenlocher).
class Envelope {
  public:
    explicit Envelope(int most)
        : at_(static_cast<size_t>(most)), from_(static_cast<size_t>(most)), until_(static_cast<size_t>(most) + 1) {}
    void run(float* line, int n, int stride) {
        int count = 0;
        for (int q = 0; q < n; ++q) {
            const float v = line[q * stride];
            if (v == INFINITY) continue;
            float meets = -INFINITY;
            while (count > 0) {
                const float r = static_cast<float>(at_[size_t(count - 1)]), s = static_cast<float>(q);
                meets = ((v + s * s) - (from_[size_t(count - 1)] + r * r)) / (2 * (s - r));
                if (meets > until_[size_t(count - 1)]) break;
                --count, meets = -INFINITY;
            }
            at_[size_t(count)] = q, from_[size_t(count)] = v, until_[size_t(count)] = meets;
            ++count;
        }
        if (count == 0) return;
        until_[size_t(count)] = INFINITY;
        for (int p = 0, k = 0; p < n; ++p) {
            while (until_[size_t(k + 1)] < static_cast<float>(p)) ++k;
            const float d = static_cast<float>(p - at_[size_t(k)]);
            line[p * stride] = from_[size_t(k)] + d * d;
        }
    }

  private:
    std::vector<int> at_;
    std::vector<float> from_, until_;
};

}  // namespace

std::vector<float> distancesTo(const std::vector<uint8_t>& texels, int width, int height, uint8_t wanted) {
    std::vector<float> d(texels.size());
    for (size_t i = 0; i < d.size(); ++i) d[i] = texels[i] == wanted ? 0 : INFINITY;
    Envelope envelope(std::max(width, height));
    for (int x = 0; x < width; ++x) envelope.run(&d[static_cast<size_t>(x)], height, width);
    for (int y = 0; y < height; ++y) envelope.run(&d[static_cast<size_t>(y) * static_cast<size_t>(width)], width, 1);
    for (float& v : d) v = std::sqrt(v);
    return d;
}

}  // namespace sward
