// Gains of slices: factors by which they get the mean radiance of the blades that they stand for (appearance.h), kept
// up to date with the light, and packed for shaders. Does not: make slices or draw them (slices.h).
#pragma once
#include "grass/appearance.h"
#include "shared/slices.h"

namespace sward {

struct DrawContext;  // frame/draw_context.h
struct GrownField;   // grass/grown.h

// Brings those of a field's species (by its number) up to date with this frame's light, those of lamps as well.
void makeGains(DrawContext& ctx, const GrownField& field, size_t species);
// A factor of red, green and blue as shares of the scale, 10 bits each from the lowest on; what is out of range is
// clamped.
uint32_t packedGain(const glm::vec3& factor, float scale);
// Writes gains into what shaders read; not conserving: all 1, as published.
void setGains(SliceGlobals& g, bool conserving, Gains gains);

}  // namespace sward
