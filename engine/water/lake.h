// Where water is that may be seen: what both of water's effects ask.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "frame/draw_context.h"
#include "world/water.h"

namespace sward {

// Low x, z and high x, z relative to the eye of what of the water may be in view: of those kBoundsGrid x kBoundsGrid
// parts of the terrain that reach below the level, as far as the water's place goes. Nothing where none does, none is
// seen, or the eye is not above the water.
std::optional<glm::vec4> waterInView(DrawContext& ctx, const WaterPlace& place);

}  // namespace sward
