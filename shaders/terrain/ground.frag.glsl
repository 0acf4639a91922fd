// Ground colour: the soil's image under the terrain map (Jahrmann and Wimmer 2013, equation 1), lit; darker where grass
// stands on it.
#include "lib/frame.glsl"
#include "lib/ground_light.glsl"
#include "lib/light.glsl"
#include "lib/soil.glsl"
#include "numerics/light.h"
#include "shared/bindings.h"

layout(binding = TEX_GROUND) uniform sampler2D soilTexture;
layout(binding = TEX_TERRAIN_MAP) uniform sampler2D terrainMap;

in vec3 position;
in vec2 place;
in vec3 normal;
out vec4 color;

vec3 soil(vec2 uv) {
    vec3 image = texture(soilTexture, place * frame.soilRepeats).rgb * 2.0 * frame.soilColor;
    if (!TERRAIN_MAP) return image;
    vec4 map = texture(terrainMap, tiled(uv, frame.terrainTiling));
    return soilColor(image, frame.soilColor, map.rgb, map.a);
}

void main() {
    vec2 uv = mapPlace(place);
    float distance = length(position);
    vec3 n = normalize(normal);
    float grown;
    SoilShares shares = soilUnder(uv, distance, grown);
    vec3 light = soilLight(position, n, shares) * soil(uv);
    light = mix(light, hazeColor(position), hazeShare(distance));
    color = vec4(clamp(light, vec3(0.0), vec3(kBrightest)), 1.0);
    if (viewMode() == VIEW_TIERS) color.rgb = vec3(0.25);
    if (viewMode() == VIEW_NORMALS) color.rgb = n * 0.5 + 0.5;
    if (viewMode() == VIEW_OVERDRAW) color.rgb = vec3(1.0 / 32.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY)
        color.rgb = mix(vec3(0.35, 0.18, 0.05), vec3(0.1, 0.9, 0.2), clamp(grown, 0.0, 1.0));
}
