// How blades shade blades: the shadow mask of a species (grass/mask.h). Needs: numerics/glsl.h, basics.h, shadow.h; a
// sampler of the mask bound to TEX_MASK.
layout(binding = TEX_MASK) uniform sampler2D bladeMask;

// Where the ray from a point of a blade (relative to its root) towards a light leaves the blade's cylinder: turns from
// where the blade faces, height as a share of the mask; z: 1 if the light stands above, else 0. radius and height of
// that cylinder: metres.
vec3 maskPoint(vec3 fromRoot, vec2 facing, vec3 towards, float radius, float height) {
    MaskPoint p = maskPointOf(fromRoot, facing, towards, radius, height);
    return vec3(p.turn, p.height, towards.y > 0.0 ? 1.0 : 0.0);
}
// Share of light that passes the neighbours there, at a density; at most at half its resolution (grass/mask.cpp).
float maskLight(vec2 at, float density) { return maskVisibility(texture(bladeMask, at), density); }
// The same for a vertex, over a texel's surroundings.
float maskLightAtVertex(vec2 at, float density) { return maskVisibility(textureLod(bladeMask, at, 1.0), density); }
