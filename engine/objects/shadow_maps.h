// Shadow maps: what those of the sun and those of lamps have in common. Depth is reversed: the nearest to the light is
// 1, nothing is 0. Does not: say what is drawn into which map, nor when.
#pragma once
#include <vector>

#include "frame/draw_context.h"

namespace sward {

// Square maps of depth, the layers of one texture, to be looked up with comparison and linearly.
struct ShadowMaps {
    GlName<TextureKind> texture;
    Tally tally;
    std::vector<Framebuffer> targets;  // by layer
    int side = 0;                      // texels
};
// Maps in which nothing shades anything; `owner` ("domain/stem") is charged for 4 bytes a texel.
ShadowMaps makeShadowMaps(Gpu& gpu, const char* owner, int side, int layers);

// Axes across the rays of a light that comes from one direction.
struct LightAxes {
    glm::vec3 towards{0}, right{0}, up{0};  // unit
    glm::dvec3 origin{0};                   // of the terrain in the world: texels lie at the same places of it
};
// towards: unit, to the light. From nothing else, so that they stay while the eye moves.
LightAxes axesAcross(const glm::vec3& towards, const glm::dvec3& origin);
// From positions relative to the eye to a map of `side` texels: x, y and depth in [0, 1] within `half` metres of
// `centre`, which is a place in the world, as the eye is. Its texels lie at the same places of the terrain whatever the
// centre, and wherever the terrain stands.
glm::mat4 mapAround(const LightAxes& axes, const glm::dvec3& centre, const glm::dvec3& eye, double half, int side);
// Whether something of the caster may shade what lies within `reach` metres of the eye.
bool shadesWithin(const LightAxes& axes, const ShadowCaster& caster, float reach);

// Draws into a map from now on, after emptying it.
void beginShadowMap(const ShadowMaps& maps, int layer);
// Draws the caster by the current program, which has its alpha's cutoff at location 0, and counts it for the pass.
// inMirror: the map shows left and right exchanged.
void drawCaster(DrawContext& ctx, const ShadowCaster& caster, bool inMirror = false);

}  // namespace sward
