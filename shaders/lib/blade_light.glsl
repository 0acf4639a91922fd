// How a point of a blade is coloured and lit: every light but what the shadow mask decides by the fragment.
// Needs: const bool GRASS_VEGETATION, GRASS_HEIGHTS, SUN, FOG, ATMOSPHERE, BLADE_SHADOWS, CASTING_LIGHTS. hue,
// lightness: as numerics/population.h bladeTint takes them; uv: of the root (mapPlace).
#include "lib/blade.glsl"
#include "lib/field.glsl"
#include "lib/density.glsl"
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/lamps.glsl"
#include "lib/leaf.glsl"
#include "lib/light.glsl"
#include "lib/mask.glsl"
#include "lib/shadow.glsl"
#include "numerics/basics.h"
#include "numerics/population.h"

vec3 bladeColor(float hue, float lightness, float v, vec2 uv) {
    vec3 c = bladeTint(bladeGradient(species.rootColor, species.midColor, species.tipColor, v), hue, lightness);
    if (!GRASS_VEGETATION) return c;
    vec4 paint = textureLod(vegetationMap, uv * field.vegetationTiling, 0.0);
    return mix(c, paint.rgb, paint.a);
}

// A vertex that is lit: reflectance; the side of the blade that the eye sees; where it is; where the blade faces; what
// of the light is left so near to the root, where no mask says it.
struct Lit {
    vec3 color, normal, toEye, position, fromRoot;
    vec2 facing;
    vec3 upright;  // of its pose
    float open, density;
};
// Where in the shadow mask it is, for a light.
vec2 maskFor(vec3 fromRoot, vec2 facing, vec3 upright, vec3 towards) {
    return maskPoint(stoodUp(fromRoot, upright), facing, unitOr(stoodUp(towards, upright), 1e-6, towards),
                     species.maskRadius, species.maskHeight)
        .xy;
}
// As leafLight takes them.
vec3 bladeGloss() { return vec3(species.translucency, species.gloss, species.roughness); }
vec3 sunOn(Lit p) {
    if (!SUN) return vec3(0.0);
    return leafLight(p.color, bladeGloss(), p.normal, p.toEye, frame.sunDirection, frame.sunLight) *
           sunVisible(p.position, vec3(0.0));
}
// Lamps that cast shadows are shaded here, by the vertex: unlike the sun there may be many.
vec3 lampsOn(Lit p) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampReaching(i, p.position, vec3(0.0));
        float share = p.open;
        if (BLADE_SHADOWS && i < castingLamps())
            share = maskLightAtVertex(maskFor(p.fromRoot, p.facing, p.upright, l.direction), p.density);
        sum += leafLight(p.color, bladeGloss(), p.normal, p.toEye, l.direction, l.light) * share;
    }
    return sum;
}
// A point of a blade as it would be without the map of heights: its neighbours are lowered as it is, so that they shade
// it as they would then.
vec3 inFullHeight(vec3 fromRoot, vec2 uv) { return GRASS_HEIGHTS ? fromRoot / max(bladeShare(uv), 0.02) : fromRoot; }
struct BladeLight {
    vec4 lit;     // radiance; w: share of it that is haze
    vec4 sunned;  // radiance where the sun reaches between the neighbours; w: density. Only where blades shade blades
    vec2 maskAt;  // where in their shadow mask
};
// Light on a blade: what no mask holds back into lit, what it may into sunned.
BladeLight lightBlade(Lit p, vec2 uv) {
    BladeLight o = BladeLight(vec4(0.0), vec4(0.0), vec2(0.0));
    float distance = length(p.position), share = hazeShare(distance);
    p.color *= darkened(distance);
    p.fromRoot = inFullHeight(p.fromRoot, uv);
    vec3 sun = sunOn(p);
    vec3 rest = p.color * ambientLight(p.normal) * (skyShare(uv) * p.open) + lampsOn(p);
    if (BLADE_SHADOWS && CASTING_LIGHTS && frame.sunCasts > 0.0) {
        o.sunned = vec4(sun * (1.0 - share), p.density);
        o.maskAt = maskFor(p.fromRoot, p.facing, p.upright, frame.sunDirection);
    } else {
        rest += sun * p.open;
    }
    o.lit = vec4(rest, share);
    if (FOG || ATMOSPHERE) o.lit.rgb = mix(o.lit.rgb, hazeColor(p.position), share);
    return o;
}
