#include "metrics/picture.h"

#include "core/jobs.h"
#include "core/numerics.h"

namespace sward {
namespace {

bool hasValue(const glm::vec3& c) { return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z); }

// Tone mapping clamps; a pixel that has no value must not become black by it.
glm::vec3 shown(const glm::vec3& c) {
    return hasValue(c) ? f32::srgbEncode3(f32::toneMapNeutral(c)) : glm::vec3(kNoValue);
}

// The error at which the slope and the bend of encoding are taken: all of it, or half of the darkest channel's value.
float shareOfError(const glm::vec3& c, const glm::vec3& error) {
    float share = 1;
    for (int k = 0; k < 3; ++k)
        if (error[k] > 0) share = std::min(share, std::max(c[k], 0.0f) / (2 * error[k]));
    return share;
}
// Sets the pixel's noise, and gives its value back what the bend takes from it.
void takeError(Picture& p, size_t i, const glm::vec3& c, const glm::vec3& error) {
    if (!hasValue(c) || !hasValue(error)) return;
    if (p.linear) return void(p.noise[i] = error * error);
    const float share = std::max(shareOfError(c, error), 1e-3f);
    const glm::vec3 above = shown(c + share * error), below = shown(c - share * error), here = shown(c);
    p.pixels[i] -= (above + below) / 2.0f - here;
    // By the slope of the value as it now is, whose bend is that of three values, too.
    const glm::vec3 wide = shown(c + 2 * share * error) - shown(c - 2 * share * error);
    const glm::vec3 slope = (2.0f * (above - below) - wide / 2.0f) / (2 * share);
    p.noise[i] = slope * slope;
}

std::string sizeText(const Picture& p) { return fmt::format("{}x{}", p.width, p.height); }

}  // namespace

Picture pictureOf(const Image& image, bool linear) {
    Picture p{image.width, image.height, image.linear && linear, {}};
    p.pixels.resize(static_cast<size_t>(p.width) * static_cast<size_t>(p.height));
    parallelFor(static_cast<size_t>(p.height), [&](size_t y) {
        for (size_t i = y * static_cast<size_t>(p.width); i < (y + 1) * static_cast<size_t>(p.width); ++i) {
            const float* v = &image.pixels[i * static_cast<size_t>(image.channels)];
            const glm::vec3 c = image.channels >= 3 ? glm::vec3(v[0], v[1], v[2]) : glm::vec3(v[0]);
            p.pixels[i] = image.linear && !linear ? shown(c) : c;
        }
    });
    return p;
}

Picture pictureOfLinear(int width, int height, const std::vector<float>& rgb) {
    return pictureOf({width, height, 3, true, rgb}, false);
}

Picture tracedPicture(const Image& image, const Image& error, bool linear) {
    CHECK_EQ(image.width, error.width);
    CHECK_EQ(image.height, error.height);
    Picture p = pictureOf(image, linear);
    p.noise.assign(p.pixels.size(), glm::vec3(0));
    const auto colorAt = [](const Image& from, size_t i) {
        const float* v = &from.pixels[i * static_cast<size_t>(from.channels)];
        return from.channels >= 3 ? glm::vec3(v[0], v[1], v[2]) : glm::vec3(v[0]);
    };
    parallelFor(static_cast<size_t>(p.height), [&](size_t y) {
        for (size_t i = y * static_cast<size_t>(p.width); i < (y + 1) * static_cast<size_t>(p.width); ++i)
            takeError(p, i, colorAt(image, i), colorAt(error, i));
    });
    return p;
}

Picture tracedPicture(int width, int height, const std::vector<float>& rgb, const std::vector<float>& error) {
    return tracedPicture({width, height, 3, true, rgb}, {width, height, 3, true, error}, false);
}

Result<PicturePair> pairPictures(Picture image, Picture truth, const std::vector<float>& mask) {
    if (image.width != truth.width || image.height != truth.height)
        return failed("the images differ in size: " + sizeText(image) + " and " + sizeText(truth),
                      "render both with the same --size");
    if (image.linear != truth.linear)
        return unsound("one image is linear and the other is not", "leave out --linear, or compare two EXR files");
    const size_t n = truth.pixels.size();
    if (!mask.empty() && mask.size() != n)
        return failed(fmt::format("the mask has {} pixels, the images have {} ({})", mask.size(), n, sizeText(truth)),
                      "render it with the same --size");
    PicturePair p{std::move(image), std::move(truth), std::vector<float>(n, 1)};
    for (size_t i = 0; i < n; ++i) {
        if (!mask.empty()) p.weight[i] = std::isfinite(mask[i]) ? std::clamp(mask[i], 0.0f, 1.0f) : 0.0f;
        if (!hasValue(p.image.pixels[i]) || !hasValue(p.truth.pixels[i])) {
            p.weight[i] = 0;
            p.image.pixels[i] = p.truth.pixels[i] = glm::vec3(kNoValue);
            if (p.nonFinite++ == 0)
                p.nonFiniteX = static_cast<int>(i) % p.truth.width, p.nonFiniteY = static_cast<int>(i) / p.truth.width;
        }
        p.weightSum += p.weight[i];
    }
    if (p.weightSum > 0) return p;
    return failed(p.nonFinite == n ? "no pixel is finite in both images" : "no pixel is left to compare",
                  mask.empty() ? "" : "look at the mask");
}

double weightedMean(const ErrorMap& map, const std::vector<float>& weight) {
    double sum = 0, weights = 0;
    for (size_t i = 0; i < map.size(); ++i) {
        if (!std::isfinite(map[i]) || weight[i] <= 0) continue;
        sum += static_cast<double>(map[i]) * weight[i];
        weights += weight[i];
    }
    return weights > 0 ? sum / weights : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace sward
