// What far grass reads of its maps, along the ground (lib/looks.glsl). Fragment shaders only. Needs: what
// lib/slices.glsl needs.
#include "lib/density.glsl"
#include "lib/field.glsl"
#include "lib/frame.glsl"
#include "lib/looks.glsl"
#include "lib/slices.glsl"

// As paintedOver, of the horizontal slice.
vec3 paintedAlong(vec3 reflectance, vec2 uv, vec3 toEye) {
    if (!GRASS_VEGETATION) return reflectance;
    float within;
    vec4 paint = colorAlong(vegetationMap, uv * field.vegetationTiling, within);
    return underPaint(reflectance, paint, within, toEye, true);
}

// As fieldDensity.
float densityAlong(vec2 uv) {
    if (!GRASS_DENSITY) return 1.0;
    Looks l = looksAt(tiled(uv, field.species[slices.species].tiling), vec2(textureSize(densityMap, 0)));
    float sum = 0.0;
    for (float i = 0.0; i < l.number; i += 1.0) sum += textureLod(densityMap, l.at + i * l.way, l.level).r;
    return sum / l.number;
}

// As paintedLean.
vec2 leanAlong(vec2 uv) {
    if (!GRASS_ORIENTATION) return vec2(0.0);
    Looks l = looksAt(uv * field.orientationTiling, vec2(textureSize(orientationMap, 0)));
    vec2 sum = vec2(0.0);
    for (float i = 0.0; i < l.number; i += 1.0) sum += textureLod(orientationMap, l.at + i * l.way, l.level).rg;
    return paintOf(sum.x / l.number, sum.y / l.number);
}
