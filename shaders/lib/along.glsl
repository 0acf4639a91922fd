// Maps read over pixels that lie along the ground, much longer than wide: with one level of detail both ways lines on a
// pitch and edges of stripes would run out wide. As few looks along a pixel's length as make each as long as wide, but
// at most kLooks; by hand, because software renderers take a thousand times longer for anisotropic filtering. Fragment
// shaders only. Needs: what lib/slices.glsl needs.
#include "lib/slices.glsl"

const float kLooks = 8.0;

// Looks at a map: the first, the way from each to the next, how many, and their level of detail.
struct Looks {
    vec2 at, way;
    float number, level;
};
// at: its texture coordinates at the pixel; size: of the map, texels.
Looks looksAt(vec2 at, vec2 size) {
    vec2 x = dFdx(at), y = dFdy(at);
    float acrossX = length(x * size), acrossY = length(y * size), most = max(acrossX, acrossY),
          wide = max(min(acrossX, acrossY), 1.0), number = clamp(ceil(most / wide), 1.0, kLooks);
    vec2 way = (acrossX > acrossY ? x : y) / number;
    return Looks(at - 0.5 * (number - 1.0) * way, way, number, log2(max(most / number, wide)));
}

// Reflectance (as a share of full scale) with the field's colour over it.
vec3 paintedAlong(vec3 reflectance, vec2 uv) {
    if (!GRASS_VEGETATION) return reflectance;
    Looks l = looksAt(uv * field.vegetationTiling, vec2(textureSize(vegetationMap, 0)));
    vec4 sum = vec4(0.0);
    for (float i = 0.0; i < l.number; i += 1.0) {
        vec4 paint = textureLod(vegetationMap, l.at + i * l.way, l.level);
        sum += vec4(paint.rgb * paint.a, paint.a);
    }
    return reflectance * (1.0 - sum.a / l.number) + sum.rgb / (l.number * slices.reflectScale);
}

// As fieldDensity.
float densityAlong(vec2 uv) {
    if (!GRASS_DENSITY) return 1.0;
    float tiling = field.species[slices.species].tiling;
    Looks l = looksAt(tiled(uv, tiling), vec2(textureSize(densityMap, 0)));
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
