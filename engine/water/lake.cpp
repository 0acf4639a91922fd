#include "water/lake.h"

namespace sward {
namespace {

// Grows a square (low x, z, high x, z) by a part of the terrain.
void grow(std::optional<glm::vec4>& square, const glm::vec2& low, const glm::vec2& high) {
    if (!square)
        square = glm::vec4(low, high);
    else
        square =
            glm::vec4(glm::min(glm::vec2(square->x, square->y), low), glm::max(glm::vec2(square->z, square->w), high));
}

}  // namespace

std::optional<glm::vec4> waterInView(DrawContext& ctx, const WaterPlace& place) {
    const Terrain& t = *ctx.shared.ground.terrain;
    const double level = static_cast<double>(place.water->level);
    updateHeightBounds(ctx.shared.bounds, t);
    const HeightBounds& bounds = ctx.shared.bounds;
    std::optional<glm::vec4> square;
    if (!(ctx.eye.y > level)) return square;
    const glm::dvec2 part = t.size / static_cast<double>(kBoundsGrid), eye(ctx.eye.x, ctx.eye.z);
    const glm::dvec2 from = glm::max(place.middle - place.radius, glm::dvec2(0)),
                     to = glm::min(place.middle + place.radius, t.size);
    const float height = static_cast<float>(level - ctx.eye.y);
    for (int z = 0; z < kBoundsGrid; ++z)
        for (int x = 0; x < kBoundsGrid; ++x) {
            const glm::dvec2 a = glm::max(glm::dvec2(x, z) * part, from),
                             b = glm::min(glm::dvec2(x + 1, z + 1) * part, to);
            if (!(a.x < b.x && a.y < b.y)) continue;
            const double lowest = static_cast<double>(
                bounds.parts.size() > 1 ? bounds.parts[static_cast<size_t>(z * kBoundsGrid + x)].first : bounds.low);
            if (!(lowest < level)) continue;
            const glm::vec2 low(a - eye), high(b - eye);
            if (ctx.frustum.touches({low.x, height, low.y}, {high.x, height, high.y})) grow(square, low, high);
        }
    return square;
}

}  // namespace sward
