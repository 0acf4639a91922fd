// Ground colour: the soil's image under the terrain map (Jahrmann and Wimmer 2013, equation 1), lit; darker where grass
// stands on it. Beyond the terrain: what world/land.h says.
#include "lib/frame.glsl"
#include "lib/ground_light.glsl"
#include "lib/light.glsl"
#include "lib/looks.glsl"
#include "lib/soil.glsl"
#include "numerics/land.h"
#include "numerics/light.h"
#include "shared/bindings.h"

layout(binding = TEX_GROUND) uniform sampler2D soilTexture;
layout(binding = TEX_TERRAIN_MAP) uniform sampler2D terrainMap;

in vec3 position;
in vec2 place;
in vec3 normal;
out vec4 color;

// Beyond the terrain a map that lies on it once: the mean along its edge. texels: a metre; pixel: texels of the edge
// that it is long.
vec4 mapOfEdge(float beyond, vec2 texels, float pixel) {
    const float kPlaces = 8.0;
    float step = 2.0 * landSpread(beyond) / kPlaces, level = log2(max(max(step * max(texels.x, texels.y), pixel), 1.0));
    vec4 sum = vec4(0.0);
    for (float i = 0.5; i < kPlaces; i += 1.0) {
        vec2 at = edgePlace(place, frame.terrainSize, step * i - landSpread(beyond));
        vec4 one = textureLod(terrainMap, mapPlace(at), level);
        sum += vec4(one.rgb * one.a, one.a);
    }
    return vec4(sum.rgb / max(sum.a, 1e-4), sum.a / kPlaces);
}

vec3 soil(vec2 uv, float beyond) {
    vec3 image = texture(soilTexture, place * frame.soilRepeats).rgb * 2.0 * frame.soilColor;
    if (!TERRAIN_MAP) return image;
    vec2 texels = frame.mapShare * vec2(textureSize(terrainMap, 0)),
         edge = edgePlace(place, frame.terrainSize, 0.0) * texels;
    float pixel = max(length(dFdx(edge)), length(dFdy(edge)));
    float within;
    vec4 map = colorAlong(terrainMap, tiled(uv, frame.terrainTiling), within);
    if (TERRAIN_BEYOND && beyond > 0.0 && !(frame.terrainTiling > 0.0)) map = mapOfEdge(beyond, texels, pixel);
    return soilColor(image, frame.soilColor, map.rgb, map.a);
}

// Beyond the terrain what grows is told by the reflectance alone: soil is lit, and seen, through it. Hills cast no
// shadows there: their map ends with the terrain.
vec3 land(vec3 soil, float left, float beyond) {
    return landSends(soil * left, frame.landGrass, left, frame.landMean, landMean(beyond, frame.landFade));
}
vec3 landLight(vec3 n) {
    bool shaded = OBJECT_SHADOWS && frame.sunIsUp > 0.0;
    return ambientLight(n) + sunLight(n) * (shaded ? sunPastObjects(position, vec3(0.0)) : 1.0);
}

void main() {
    vec2 uv = mapPlace(place);
    float distance = length(position);
    vec3 n = normalize(normal);
    float grown;
    SoilShares shares = soilUnder(uv, slopeOf(n), distance, grown);
    float beyond = TERRAIN_BEYOND ? beyondBy(place, frame.terrainSize) : 0.0;
    vec3 here = soil(uv, max(beyond, 0.0));  // before pixels part: it takes differences between neighbours
    vec3 light =
        beyond > 0.0 ? landLight(n) * land(here, shares.mean.sun, beyond) : soilLight(position, n, shares) * here;
    light = mix(light, hazeColor(position), hazeShare(distance));
    color = vec4(clamp(light, vec3(0.0), vec3(kBrightest)), 1.0);
    if (viewMode() == VIEW_TIERS) color.rgb = vec3(0.25);
    if (viewMode() == VIEW_NORMALS) color.rgb = n * 0.5 + 0.5;
    if (viewMode() == VIEW_OVERDRAW) color.rgb = vec3(1.0 / 32.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY)
        color.rgb = mix(vec3(0.35, 0.18, 0.05), vec3(0.1, 0.9, 0.2), clamp(grown, 0.0, 1.0));
}
