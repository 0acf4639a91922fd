#include "grass/cover.h"

#include "core/numerics.h"

namespace sward {
namespace {

constexpr int kBlades = 64, kPoints = 4;

// Share of a blade's point at v that other blades leave visible, seen from above eye height: tips hide roots.
float seen(float v) { return std::exp(-2.4f * (1 - v)); }

// Share of the sun's light that reaches a blade at a height among its neighbours.
float sunShare(const BladeShade& shade, const glm::vec4& sun, float height, float open) {
    if (!shade.texture || shade.rows.empty()) return open;
    const f32::MaskPoint p = f32::maskPointOf({0, height, 0}, {1, 0}, glm::vec3(sun), shade.radius, shade.top);
    const size_t row = static_cast<size_t>(std::min(p.height, 1.0f) * static_cast<float>(shade.rows.size()));
    return shade.rows[std::min(row, shade.rows.size() - 1)];
}

}  // namespace

CoverSpecies meanCover(const Species& species, const Patch& patch, const FrameGlobals& frame, const BladeShade& shade) {
    CoverSpecies out{};
    glm::vec3 albedo(0), ambient(0);
    float weight = 0, lit = 0, upright = 0, level = 0, area = 0, height = 0;
    const size_t n = std::min<size_t>(patch.blades.size(), kBlades);
    for (size_t i = 0; i < n; ++i) {
        const Blade& b = patch.blades[i * patch.blades.size() / n];
        for (int p = 0; p < kPoints; ++p) {
            const float v = (static_cast<float>(p) + 0.5f) / kPoints, w = seen(v);
            const f32::BladeFrame f = f32::bladeFrameFacing(b.control, b.tip, b.facing, v);
            const float open = glm::mix(species.rootOcclusion, 1.0f, v), left = open * w;
            const float direct = sunShare(shade, frame.sunDirection, f.position.y, open) * w;
            albedo += f32::bladeTint(f32::bladeGradient(species.rootColor, species.midColor, species.tipColor, v), b.hue, b.lightness) * left;
            lit += left;
            ambient += glm::mix(glm::vec3(frame.groundLight), glm::vec3(frame.skyLight), 0.5f + 0.5f * std::abs(f.normal.y)) * left;
            upright += std::sqrt(std::max(1 - f.normal.y * f.normal.y, 0.0f)) * direct;
            level += std::abs(f.normal.y) * direct;
            weight += w;
        }
        area += b.width * glm::length(b.tip) * 0.7f;  // 0.7: the share of the strip that the blade's alpha fills
        height += b.tip.y;
    }
    if (n == 0) return out;
    out.albedo = glm::vec4(albedo / std::max(lit, 1e-6f), area / static_cast<float>(n) * species.bladesPerM2);
    out.ambient = glm::vec4(ambient / weight, height / static_cast<float>(n));
    const float clumps = species.clumpSize > 0 ? 0.2f * species.clumpStrength : 0;
    out.clumps = {species.clumpSize, clumps, species.translucency, species.gloss};
    // Blades of no more area than the ground's leave it most of its light.
    const float soil = std::max(0.35f, std::exp(-out.albedo.w));
    out.shape = {std::tan(glm::radians(std::min(species.leanDeg, 80.0f))), soil, upright / weight, level / weight};
    return out;
}

}  // namespace sward
