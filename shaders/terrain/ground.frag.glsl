// Ground colour: tiled soil under the terrain map (Jahrmann and Wimmer 2013, equation 1), lit; darker where grass
// stands on it.
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/bilinear.h"
#include "numerics/hash.h"
#include "numerics/lod.h"
#include "numerics/weights.h"
#include "lib/light.glsl"
#include "lib/lamps.glsl"
#include "lib/density.glsl"
#include "lib/shadow.glsl"
#include "lib/ground_light.glsl"

layout(binding = TEX_GROUND) uniform sampler2D tileTexture;
layout(binding = TEX_TERRAIN_MAP) uniform sampler2D terrainMap;

in vec3 position;
in vec2 place;
in vec3 normal;
out vec4 color;

// Densities of all species here, filtered for the pixel.
vec4 densities(vec2 uv) {
    vec4 d = vec4(0.0);
    int n = cover.speciesCount;
    if (!GRASS_DENSITY) return vec4(lessThan(vec4(0.0, 1.0, 2.0, 3.0), vec4(float(cover.speciesCount))));
    if (n > 0) d.x = texture(densityMap[0], tiled(uv, cover.species[0].tiling)).r;
    if (n > 1) d.y = texture(densityMap[1], tiled(uv, cover.species[1].tiling)).r;
    if (n > 2) d.z = texture(densityMap[2], tiled(uv, cover.species[2].tiling)).r;
    if (n > 3) d.w = texture(densityMap[3], tiled(uv, cover.species[3].tiling)).r;
    return d;
}

// Share of light that grass leaves to the soil.
float lightLeft(vec4 density, vec2 uv) {
    float left = 1.0, tall = GRASS_HEIGHTS ? texture(bladeHeightMap, tiled(uv, cover.heightTiling)).r : 1.0;
    for (int i = 0; i < cover.speciesCount; ++i) left *= soilLeft(cover.species[i].shade, density[i], tall);
    return left;
}

vec3 soil(vec2 uv) {
    vec3 tile = texture(tileTexture, place * frame.soilTiles).rgb * 2.0 * frame.soilColor;
    if (!TERRAIN_MAP) return tile;
    vec4 map = texture(terrainMap, tiled(uv, frame.terrainTiling));
    return soilColor(tile, frame.soilColor, map.rgb, map.a);
}

void main() {
    vec2 uv = mapPlace(place);
    float distance = length(position);
    vec3 n = normalize(normal);
    vec4 density = GRASS ? densities(uv) : vec4(0.0);
    float shades = GRASS ? lightLeft(density, uv) : 1.0,
          near = GRASS ? 1.0 - lodRamp(distance, cover.shadeFrom, cover.shadeInv) : 1.0;
    vec3 light = soilLight(position, uv, n, shades, near) * soil(uv);
    light = mix(light, horizonColor(position.xz), hazeShare(distance));
    color = vec4(clamp(light, vec3(0.0), vec3(kBrightest)), 1.0);
    float total = clamp(dot(density, vec4(1.0)), 0.0, 1.0);
    if (viewMode() == VIEW_TIERS) color.rgb = vec3(0.25);
    if (viewMode() == VIEW_NORMALS) color.rgb = n * 0.5 + 0.5;
    if (viewMode() == VIEW_OVERDRAW) color.rgb = vec3(1.0 / 32.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY) color.rgb = mix(vec3(0.35, 0.18, 0.05), vec3(0.1, 0.9, 0.2), total);
}
