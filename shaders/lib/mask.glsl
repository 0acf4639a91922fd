// How blades shade blades: the shadow mask of a species (grass/mask.h). Any stage.
#include "numerics/shadow.h"
#include "shared/bindings.h"

layout(binding = TEX_MASK) uniform sampler3D bladeMask;

// Where in the mask a point of a blade (relative to its root) is for a light. own: turns by which the blade's mask is
// turned around it. radius and height of its cylinder: m.
vec3 maskPoint(vec3 fromRoot, float own, vec3 towards, float radius, float height) {
    MaskPoint p = maskPointOf(fromRoot, vec2(1.0, 0.0), towards, radius, height);
    return vec3(p.turn + own, p.height, p.rise);
}
// Share of light that passes the neighbours there, at a density.
float maskLight(vec3 at, float density) { return maskVisibility(textureLod(bladeMask, at, 0.0), density); }
// Its mean over all blades there.
float maskMean(vec3 at, float density) { return maskVisibility(textureLod(bladeMask, at, 1.0), density); }
