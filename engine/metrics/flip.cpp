// Index: colour spaces · contrast sensitivity · colour differences · features · the map.
#include "metrics/flip.h"

#include "core/jobs.h"
#include "core/numerics.h"
#include "metrics/convolve.h"

namespace sward {
namespace {

// --- colour spaces -----------------------------------------------------------------------------------------------
glm::dvec3 xyzOfChromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

// Linear RGB of the sRGB primaries to XYZ, scaled so that (1,1,1) is the white of D65 with Y = 1.
struct ColorSpace {
    glm::dmat3 toXyz, toRgb;
    glm::dvec3 white;
    ColorSpace() {
        white = xyzOfChromaticity(0.3127, 0.3290);
        glm::dmat3 m(xyzOfChromaticity(0.64, 0.33), xyzOfChromaticity(0.30, 0.60), xyzOfChromaticity(0.15, 0.06));
        const glm::dvec3 scale = glm::inverse(m) * white;
        for (int c = 0; c < 3; ++c) m[c] *= scale[c];
        toXyz = m;
        toRgb = glm::inverse(m);
    }
};
// The linear form of L*a*b* in which the eye's filters act (section 4.1.1).
glm::dvec3 yccOf(const ColorSpace& s, const glm::dvec3& rgb) {
    const glm::dvec3 v = s.toXyz * rgb / s.white;
    return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}
glm::dvec3 rgbOf(const ColorSpace& s, const glm::dvec3& ycc) {
    const double y = (ycc.x + 16) / 116;
    return s.toRgb * (glm::dvec3(y + ycc.y / 500, y, y - ycc.z / 200) * s.white);
}
double labCurve(double t) {
    constexpr double kDelta = 6.0 / 29;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}
// L*a*b* with chroma scaled by lightness (Hunt's effect).
glm::dvec3 huntLab(const ColorSpace& s, const glm::dvec3& rgb) {
    const glm::dvec3 v = s.toXyz * rgb / s.white;
    const double x = labCurve(v.x), y = labCurve(v.y), z = labCurve(v.z), lightness = 116 * y - 16;
    return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}
double hyab(const glm::dvec3& a, const glm::dvec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

// --- contrast sensitivity ----------------------------------------------------------------------------------------
// A sum of two Gaussians a sqrt(pi/b) e^(-pi^2 x^2 / b), x in degrees (table 1).
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity kAchromatic{1, 0.0047, 0, 1e-5}, kRedGreen{1, 0.0053, 0, 1e-5},
    kBlueYellow{34.1, 0.04, 13.5, 0.025};
constexpr double kPi = 3.14159265358979323846;

// Normalised to a sum of 1 over the square of taps.
Plane filtered(const Plane& plane, const Sensitivity& s, double ppd, int radius) {
    const auto part = [&](double a, double b) {
        const double sigma = std::sqrt(b / (2 * kPi * kPi)) * ppd;
        double sum = 0;
        for (int i = -radius; i <= radius; ++i) sum += std::exp(-i * i / (2 * sigma * sigma));
        return std::pair{gaussianTaps(sigma, radius), a * std::sqrt(kPi / b) * sum * sum};
    };
    const auto [first, weight] = part(s.a1, s.b1);
    Plane out = convolve(plane, first, first);
    if (s.a2 == 0) return out;
    const auto [second, other] = part(s.a2, s.b2);
    const Plane more = convolve(plane, second, second);
    for (size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = static_cast<float>((weight * out.values[i] + other * more.values[i]) / (weight + other));
    return out;
}

struct Planes {
    Plane y, cx, cz;
};
Planes planesOf(const ColorSpace& s, const Picture& p) {
    const Plane empty{p.width, p.height, std::vector<float>(p.pixels.size())};
    Planes out{empty, empty, empty};
    for (size_t i = 0; i < p.pixels.size(); ++i) {
        const glm::dvec3 v = p.pixels[i];
        const bool finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
        const glm::dvec3 ycc =
            finite ? yccOf(s, p.linear ? glm::clamp(v, 0.0, 1.0) : f64::srgbDecode3(v)) : glm::dvec3(kNoValue);
        out.y.values[i] = static_cast<float>(ycc.x), out.cx.values[i] = static_cast<float>(ycc.y),
        out.cz.values[i] = static_cast<float>(ycc.z);
    }
    return out;
}

// --- colour differences ------------------------------------------------------------------------------------------
// What the eye sees of each pixel, in Hunt-adjusted L*a*b*.
std::vector<glm::dvec3> perceived(const ColorSpace& s, const Planes& p, double ppd) {
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kBlueYellow.b1 / (2 * kPi * kPi)) * ppd));
    const Plane y = filtered(p.y, kAchromatic, ppd, radius), cx = filtered(p.cx, kRedGreen, ppd, radius),
                cz = filtered(p.cz, kBlueYellow, ppd, radius);
    std::vector<glm::dvec3> out(y.values.size());
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = huntLab(s, glm::clamp(rgbOf(s, {y.values[i], cx.values[i], cz.values[i]}), 0.0, 1.0));
    return out;
}

constexpr double kColorPower = 0.7, kKnee = 0.4, kKneeAt = 0.95;

double colorDifference(const glm::dvec3& a, const glm::dvec3& b, double greatest) {
    const double e = std::pow(hyab(a, b), kColorPower), knee = kKnee * greatest;
    return e < knee ? kKneeAt / knee * e : kKneeAt + (e - knee) / (greatest - knee) * (1 - kKneeAt);
}

// --- features ----------------------------------------------------------------------------------------------------
constexpr double kFeatureWidth = 0.082, kFeaturePower = 0.5;  // degrees; an exponent

// Positive weights to a sum of 1, negative ones to -1.
Taps balanced(Taps taps) {
    double above = 0, below = 0;
    for (const double t : taps) (t > 0 ? above : below) += std::abs(t);
    for (double& t : taps) t /= t > 0 ? above : below;
    return taps;
}
struct Features {
    std::vector<float> edge, point;
};
Features features(const Plane& y, double ppd) {
    const double sigma = 0.5 * kFeatureWidth * ppd;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const Taps smooth = gaussianTaps(sigma, radius);
    Taps first = smooth, second = smooth;
    for (int i = -radius; i <= radius; ++i) {
        first[static_cast<size_t>(i + radius)] *= -i;
        second[static_cast<size_t>(i + radius)] *= i * i / (sigma * sigma) - 1;
    }
    first = balanced(first), second = balanced(second);
    const auto length = [&](const Taps& taps) {
        const Plane a = convolve(y, taps, smooth), b = convolve(y, smooth, taps);
        std::vector<float> out(a.values.size());
        for (size_t i = 0; i < out.size(); ++i) out[i] = std::hypot(a.values[i], b.values[i]);
        return out;
    };
    return {length(first), length(second)};
}
Features featuresOf(Plane y, double ppd) {
    for (float& v : y.values) v = (v + 16) / 116;
    return features(y, ppd);
}

}  // namespace

// --- the map -----------------------------------------------------------------------------------------------------
ErrorMap flipMap(const PicturePair& pair, double pixelsPerDegree) {
    const ColorSpace space;
    const double greatest = std::pow(hyab(huntLab(space, {0, 1, 0}), huntLab(space, {0, 0, 1})), kColorPower);
    const Planes a = planesOf(space, pair.image), b = planesOf(space, pair.truth);
    const std::vector<glm::dvec3> seenA = perceived(space, a, pixelsPerDegree),
                                  seenB = perceived(space, b, pixelsPerDegree);
    const Features fa = featuresOf(a.y, pixelsPerDegree), fb = featuresOf(b.y, pixelsPerDegree);
    ErrorMap map(seenA.size(), kNoValue);
    parallelFor(map.size() / static_cast<size_t>(pair.truth.width), [&](size_t row) {
        for (size_t i = row * static_cast<size_t>(pair.truth.width);
             i < (row + 1) * static_cast<size_t>(pair.truth.width); ++i) {
            const double color = colorDifference(seenA[i], seenB[i], greatest);
            const double edge = std::abs(fa.edge[i] - fb.edge[i]), point = std::abs(fa.point[i] - fb.point[i]);
            const double feature = std::pow(std::max(edge, point) / std::sqrt(2.0), kFeaturePower);
            if (std::isfinite(color) && std::isfinite(feature))
                map[i] = static_cast<float>(std::pow(color, 1 - std::min(feature, 1.0)));
        }
    });
    return map;
}

}  // namespace sward
