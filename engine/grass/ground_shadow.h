// Shadows of blades on the ground: the near blades once more, followed down the light's rays onto the ground.
// Source: Boulanger, Pattanaik and Bouatouch 2006, section 3.5; B-20. The paper projects onto a plane by a matrix,
// marks the stencil buffer and darkens it by one rectangle. Here vertices go to the plane of the ground at their
// blade's root and are then laid on the ground, so that shadows lie on slopes and hills; and instead of a rectangle the
// first shadow to reach a sample of seen ground darkens it and sets the stencil's bit of that light, so that shadows of
// one light do not add up and yet may fade with their length and with the blade that throws them. A shadow takes away
// the light of its own light alone: where two lights' shadows cross, the shares that are left are multiplied. The sun
// and the first six lamps that cast shadows throw them. Blades have two quads at most, no texture, and end in a point;
// of those that are narrower than half a pixel one throws the shadow of several (numerics/shadow.h, shadowsOfOne).
// Does not: shade the ground beyond maxGeom (the horizontal slice does, grass/slices.h), nor objects. Cost: a blade's
// five vertices a light.
#pragma once
#include "grass/field.h"
#include "scene/rows.h"

namespace sward {

// Metres by which the shadows of a field's species i may reach beyond its blades, under the lights of this frame.
float groundShadowReach(const DrawContext& ctx, const Field& field, size_t i);

// Row of the effect "grass/ground-shadow" (techniques.cpp): runs in scenes with GroundShadows, CastingLights,
// GrassGeometry, Grass and Terrain.
const EffectRow& groundShadowEffect();

}  // namespace sward
