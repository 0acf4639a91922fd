// FLIP against a second implementation, written straight from the paper's formulas: double precision, one
// two-dimensional sum a pixel, no separable filters. The images that its authors publish values for are not ours to
// ship.
#include "metrics/flip.h"

#include "metrics/pictures.h"

namespace sward::test {
namespace {

using V = glm::dvec3;
constexpr double kPi = 3.14159265358979323846;

// IEC 61966-2-1, with the usual four digits.
double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
V xyz(const V& c) {
    return {0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z, 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z,
            0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z};
}
V rgb(const V& c) {
    const glm::dmat3 m(xyz({1, 0, 0}), xyz({0, 1, 0}), xyz({0, 0, 1}));
    return glm::inverse(m) * c;
}
const V kWhite = xyz({1, 1, 1});
V lab(const V& c) {
    const V v = xyz(c) / kWhite;
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    return {116 * f(v.y) - 16, 500 * (f(v.x) - f(v.y)), 200 * (f(v.y) - f(v.z))};
}
double hyab(const V& c, const V& d) {
    V a = lab(c), b = lab(d);
    a.y *= 0.01 * a.x, a.z *= 0.01 * a.x, b.y *= 0.01 * b.x, b.z *= 0.01 * b.x;
    return std::abs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}
// Equation 7: 0.4 of the greatest difference comes to 0.95.
double spread(double e) {
    const double greatest = std::pow(hyab({0, 1, 0}, {0, 0, 1}), 0.7);
    e = std::pow(e, 0.7);
    return e < 0.4 * greatest ? e * 0.95 / (0.4 * greatest) : 0.95 + 0.05 * (e - 0.4 * greatest) / (0.6 * greatest);
}
double solid(const V& a, const V& b) { return spread(hyab(a, b)); }

struct Straight {
    const Picture& p;
    double ppd;
    V at(int x, int y) const {
        const V c =
            p.pixels[static_cast<size_t>(std::clamp(y, 0, p.height - 1) * p.width + std::clamp(x, 0, p.width - 1))];
        const V v = xyz({linear(c.x), linear(c.y), linear(c.z)}) / kWhite;
        return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
    }
    // Sum of weight(dx, dy) * channel over a square, with the sum of the weights.
    template <class W>
    double filter(int x, int y, int radius, int channel, W&& weight) const {
        double sum = 0, weights = 0;
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx) {
                const double w = weight(dx, dy);
                sum += w * at(x + dx, y + dy)[channel], weights += w;
            }
        return sum / weights;
    }
    V seen(int x, int y) const {
        const double table[3][4] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
        const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
        V ycc;
        for (int c = 0; c < 3; ++c)
            ycc[c] = filter(x, y, radius, c, [&](int dx, int dy) {
                const double r2 = (dx * dx + dy * dy) / (ppd * ppd), *t = table[c];
                return t[0] * std::sqrt(kPi / t[1]) * std::exp(-kPi * kPi * r2 / t[1]) +
                       t[2] * std::sqrt(kPi / t[3]) * std::exp(-kPi * kPi * r2 / t[3]);
            });
        const double luminance = (ycc.x + 16) / 116;
        return glm::clamp(rgb(V(luminance + ycc.y / 500, luminance, luminance - ycc.z / 200) * kWhite), 0.0, 1.0);
    }
    // Length of the gradient (order 1: edges) or of the second derivatives (order 2: points) of luminance.
    double feature(int x, int y, int order) const {
        const double sigma = 0.5 * 0.082 * ppd;
        const int radius = static_cast<int>(std::ceil(3 * sigma));
        const auto derivative = [&](bool down) {
            double above = 0, below = 0, aboveWeight = 0, belowWeight = 0;
            for (int dy = -radius; dy <= radius; ++dy)
                for (int dx = -radius; dx <= radius; ++dx) {
                    const double g = std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)), d = down ? dy : dx;
                    const double w = order == 1 ? -d * g : (d * d / (sigma * sigma) - 1) * g,
                                 v = (at(x + dx, y + dy).x + 16) / 116;
                    if (w > 0)
                        above += w * v, aboveWeight += w;
                    else
                        below -= w * v, belowWeight -= w;
                }
            return above / aboveWeight - below / belowWeight;
        };
        return std::hypot(derivative(false), derivative(true));
    }
};
double straightFlip(const Picture& a, const Picture& b, int x, int y, double ppd) {
    const Straight p{a, ppd}, q{b, ppd};
    const double color = spread(hyab(p.seen(x, y), q.seen(x, y)));
    const double edge = std::abs(p.feature(x, y, 1) - q.feature(x, y, 1)),
                 point = std::abs(p.feature(x, y, 2) - q.feature(x, y, 2));
    return std::pow(color, 1 - std::sqrt(std::max(edge, point) / std::sqrt(2.0)));
}
double meanFlip(const Picture& a, const Picture& b, double ppd = 67) {
    const PicturePair p = pairOf(a, b);
    return weightedMean(flipMap(p, ppd), p.weight);
}

TEST(Flip, OfEqualPicturesIsZero) { EXPECT_EQ(meanFlip(noise(40, 30, 1), noise(40, 30, 1)), 0); }
TEST(Flip, OfPlainColoursIsTheirHyabSpreadOverTheScale) {
    const V colors[] = {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0.5}};
    for (const V& a : colors)
        for (const V& b : colors) {
            const V la{linear(a.x), linear(a.y), linear(a.z)}, lb{linear(b.x), linear(b.y), linear(b.z)};
            EXPECT_NEAR(meanFlip(plain(12, 9, glm::vec3(a)), plain(12, 9, glm::vec3(b))), solid(la, lb), 2e-4);
        }
    // By hand: black and white are 100 apart in lightness alone; blue and green are the most different of all.
    const double greatest = std::pow(hyab({0, 1, 0}, {0, 0, 1}), 0.7), e = std::pow(100, 0.7);
    EXPECT_NEAR(meanFlip(plain(12, 9, glm::vec3(0)), plain(12, 9, glm::vec3(1))),
                e < 0.4 * greatest ? 0.95 * e / (0.4 * greatest) : 0.95 + 0.05 * (e / greatest - 0.4) / 0.6, 2e-4);
    EXPECT_NEAR(meanFlip(plain(12, 9, {0, 1, 0}), plain(12, 9, {0, 0, 1})), 1, 2e-4);
}
TEST(Flip, IsWhatThePapersFormulasGiveForAPointALineAndNoise) {
    constexpr int kWidth = 31, kHeight = 27;
    const Picture gray = plain(kWidth, kHeight, glm::vec3(0.4f));
    Picture point = gray;
    point.pixels[static_cast<size_t>(13 * kWidth + 15)] = {1, 0.9f, 0.2f};
    const Picture line = made(
        kWidth, kHeight, [](int x, int) { return x < 15 ? glm::vec3(0.1f, 0.5f, 0.2f) : glm::vec3(0.8f, 0.3f, 0.6f); });
    const std::pair<Picture, Picture> cases[] = {
        {point, gray}, {line, gray}, {noise(kWidth, kHeight, 1), noise(kWidth, kHeight, 2)}};
    for (const double ppd : {67.0, 25.0})
        for (const auto& [a, b] : cases) {
            const ErrorMap map = flipMap(pairOf(a, b), ppd);
            for (int y = 0; y < kHeight; y += 6)
                for (int x = 0; x < kWidth; x += 5)
                    EXPECT_NEAR(map[static_cast<size_t>(y * kWidth + x)], straightFlip(a, b, x, y, ppd), 5e-4)
                        << x << "," << y << " at " << ppd;
        }
}
TEST(Flip, SeesLessOfFineNoiseFromFartherAway) {
    const Picture a = noise(64, 48, 1), b = noise(64, 48, 2);
    EXPECT_LT(1.5 * meanFlip(a, b, 134), meanFlip(a, b, 33));
}
TEST(Flip, IsTheSameBothWays) {
    EXPECT_DOUBLE_EQ(meanFlip(noise(40, 30, 1), noise(40, 30, 2)), meanFlip(noise(40, 30, 2), noise(40, 30, 1)));
}
TEST(Flip, HasNoValueWhereItsFiltersReachANonFinitePixel) {
    Picture bad = noise(64, 48, 1);
    bad.pixels[static_cast<size_t>(24 * 64 + 32)].y = kNoValue;
    const ErrorMap map = flipMap(pairOf(bad, noise(64, 48, 2)));
    size_t none = 0;
    for (size_t i = 0; i < map.size(); ++i) {
        const int dx = static_cast<int>(i % 64) - 32, dy = static_cast<int>(i / 64) - 24;
        EXPECT_EQ(std::isnan(map[i]), std::max(std::abs(dx), std::abs(dy)) <= 10) << dx << "," << dy;
        none += std::isnan(map[i]);
    }
    EXPECT_EQ(none, 21u * 21u);
}

}  // namespace
}  // namespace sward::test
