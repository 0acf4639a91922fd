#include "measure/metrics.h"

#include "core/numerics.h"

namespace sward {
namespace {

// A pixel as it is compared. Gray images stand for three equal channels.
glm::vec3 shown(const Image& image, size_t i, bool linear) {
    const float* p = &image.pixels[i * static_cast<size_t>(image.channels)];
    const glm::vec3 c = image.channels >= 3 ? glm::vec3(p[0], p[1], p[2]) : glm::vec3(p[0]);
    return image.linear && !linear ? f32::srgbEncode3(f32::toneMapNeutral(glm::max(c, glm::vec3(0)))) : c;
}
bool finite(const glm::vec3& c) { return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z); }

}  // namespace

Result<Difference> compareImages(const Image& a, const Image& b, bool linear) {
    if (a.width != b.width || a.height != b.height)
        return Error{ExitCode::Failed, fmt::format("the images differ in size: {}x{} and {}x{}", a.width, a.height, b.width, b.height), "", 0, 0,
                     "render both with the same --size"};
    Difference d;
    double sum = 0;
    for (size_t i = 0; i < static_cast<size_t>(a.width) * static_cast<size_t>(a.height); ++i) {
        const glm::vec3 x = shown(a, i, linear), y = shown(b, i, linear);
        if (!finite(x) || !finite(y)) {
            if (d.nonFinite++ == 0) d.nonFiniteX = static_cast<int>(i) % a.width, d.nonFiniteY = static_cast<int>(i) / a.width;
            continue;
        }
        const glm::dvec3 e = glm::dvec3(x) - glm::dvec3(y);
        sum += glm::dot(e, e);
        ++d.pixels;
    }
    if (d.pixels == 0) return Error{ExitCode::Failed, "no pixel is finite in both images", "", 0, 0, ""};
    d.rmse = std::sqrt(sum / (3.0 * static_cast<double>(d.pixels)));
    d.psnr = d.rmse > 0 ? -20 * std::log10(d.rmse) : std::numeric_limits<double>::infinity();
    return d;
}

std::vector<uint8_t> heatmap(const Image& a, const Image& b, bool linear) {
    std::vector<uint8_t> out;
    const size_t n = static_cast<size_t>(a.width) * static_cast<size_t>(a.height);
    out.reserve(n * 3);
    for (size_t i = 0; i < n; ++i) {
        const glm::vec3 e = glm::abs(shown(a, i, linear) - shown(b, i, linear));
        const float t = finite(e) ? std::clamp(2 * std::max({e.x, e.y, e.z}), 0.0f, 1.0f) * 3 : 3.0f;
        for (float c : {t, t - 1, t - 2}) out.push_back(static_cast<uint8_t>(std::lround(255 * std::clamp(c, 0.0f, 1.0f))));
    }
    return out;
}

}  // namespace sward
