// Ground colour: tiled soil under the terrain map (Jahrmann and Wimmer 2013, equation 1), lit; and, where blades are not
// drawn, the grass's mean colour by how much of the ground it hides at this angle.
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/bilinear.h"
#include "numerics/hash.h"
#include "numerics/lod.h"
#include "numerics/clump.h"
#include "numerics/leaf.h"
#include "numerics/weights.h"
#include "lib/light.glsl"
#include "lib/lamps.glsl"
#include "lib/cover.glsl"
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
    int n = int(cover.tiers.x);
    if (!GRASS_DENSITY) return vec4(lessThan(vec4(0.0, 1.0, 2.0, 3.0), vec4(cover.tiers.x)));
    if (n > 0) d.x = texture(densityMap[0], uv).r;
    if (n > 1) d.y = texture(densityMap[1], uv).r;
    if (n > 2) d.z = texture(densityMap[2], uv).r;
    if (n > 3) d.w = texture(densityMap[3], uv).r;
    return d;
}

struct Grass {
    vec3 light;    // radiance of the grass that is seen
    float hides;   // share of the ground it hides at this angle
    float shades;  // share of light that reaches the soil
    float total;   // sum of densities, for the views
};

// Light on upright blades of all azimuths, of which the eye sees the faces turned towards it: the mean of max(n.L, 0) over
// normals n weighted by n.E is ((pi - x) cos x + sin x) / 4 of the light's horizontal part, x the angle between light and eye
// from above; here as a polynomial in c = cos x (error 0.005).
float azimuthMean(float c) { return 0.25 + c * (0.39 + c * 0.145); }
float shareOnBlades(CoverSpecies s, vec2 away, vec3 towards) {
    float across = length(towards.xz);
    float c = -dot(towards.xz, away) / max(across, 1e-4);
    return s.shape.z * across * azimuthMean(c) + s.shape.w * 0.5 * max(towards.y, 0.0);
}
// The same of light that falls on the faces turned from the eye.
float shareThroughBlades(CoverSpecies s, vec2 away, vec3 towards) {
    float across = length(towards.xz);
    return s.shape.z * across * azimuthMean(dot(towards.xz, away) / max(across, 1e-4));
}
// What blades of reflectance c send to the eye of light from `towards`.
vec3 lightOnBlades(CoverSpecies s, vec3 c, vec3 toEye, vec2 away, vec3 towards, vec3 light) {
    vec3 sent = c * shareOnBlades(s, away, towards);
    if (TRANSLUCENCY) sent += leafThrough(c) * (s.clumps.z * shareThroughBlades(s, away, towards));
    if (GLOSS) sent += vec3(s.clumps.w * waxyMean(dot(towards, toEye)) * (s.shape.z + s.shape.w));
    return sent * light;
}
vec3 directOnBlades(CoverSpecies s, vec3 c, vec3 toEye, vec2 away) {
    vec3 sum = vec3(0.0);
    if (SUN) sum = lightOnBlades(s, c, toEye, away, frame.sunDirection.xyz, frame.sunLight.rgb);
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampAt(i, position);
        sum += lightOnBlades(s, c, toEye, away, l.direction, l.light);
    }
    return sum;
}

// Lightness of the clumps that the blades have too, and a mottle for single tufts, as long as pixels are small enough to
// show them.
float variation(CoverSpecies s, float pixel) {
    float mottle = texture(tileTexture, mat2(0.83, 0.56, -0.56, 0.83) * place * 0.9).g * 2.0;
    float v = mix(1.0, mottle, 0.4);
    if (!GRASS_CLUMPS || s.clumps.x <= 0.0 || pixel > s.clumps.x) return v;
    float cellSize = cover.tiers.w;
    ivec2 cell = ivec2(floor(place / cellSize));
    vec3 c = clumpValues(cell.x, cell.y, place - vec2(cell) * cellSize, cellSize, s.clumps.x, uint(cover.tiling.w));
    return v * (1.0 + c.z * s.clumps.y * (1.0 - pixel / s.clumps.x));
}

// Beer's law over the blades' area; a mown stripe shows its blades' length where they lean away, their tips where they
// lean towards the eye.
Grass grassHere(vec2 uv, vec3 toEye) {
    Grass g;
    g.light = vec3(0.0);
    g.shades = 1.0;
    g.total = 0.0;
    vec4 density = densities(uv);
    vec2 lean = paintedLean(uv);
    vec2 away = -toEye.xz / max(length(toEye.xz), 1e-4);
    float area = 0.0;
    float pixel = max(length(dFdx(place)), length(dFdy(place)));
    for (int i = 0; i < int(cover.tiers.x); ++i) {
        CoverSpecies s = cover.species[i];
        float a = density[i] * s.albedo.w;
        vec3 albedo = s.albedo.rgb;
        if (GRASS_VEGETATION) {
            vec4 v = texture(vegetationMap, uv * cover.tiling.y);
            albedo = mix(albedo, v.rgb, v.a);
        }
        float stripe = 1.0 + 0.55 * s.shape.x * dot(lean, away) * (1.0 - toEye.y * toEye.y);
        g.light += a * (albedo * s.ambient.rgb * skyShare(uv) + directOnBlades(s, albedo, toEye, away)) * stripe * variation(s, pixel);
        g.shades *= mix(1.0, s.shape.y, density[i]);
        area += a;
        g.total += density[i];
    }
    g.light = g.light / max(area, 1e-6);
    g.hides = 1.0 - exp(-0.5 * area / max(toEye.y, 0.08));
    return g;
}

vec3 soil(vec2 uv) {
    vec3 tile = texture(tileTexture, place * frame.groundColor.w).rgb * 2.0 * frame.groundColor.rgb;
    if (!TERRAIN_MAP) return tile;
    vec4 map = texture(terrainMap, uv);
    return mix(tile, map.rgb * (0.75 + 0.25 * tile / max(frame.groundColor.rgb, vec3(1e-3))), map.a);
}

void main() {
    vec2 uv = place * frame.terrain.zw;
    float distance = length(position);
    vec3 toEye = -position / max(distance, 1e-4);
    vec3 n = normalize(normal);
    vec3 light;
    float far = 0.0;
    Grass g;
    if (GRASS) {
        g = grassHere(uv, toEye);
        float ramp = lodRamp(distance, cover.tiers.y, cover.tiers.z);
        far = ramp * g.hides;
        light = mix(soilLight(position, n, g.shades, 1.0 - ramp) * soil(uv), g.light, far);
    } else {
        light = soilLight(position, n, 1.0, 1.0) * soil(uv);
    }
    light = mix(light, horizonColor(position.xz), hazeShare(distance));
    color = vec4(clamp(light, vec3(0.0), vec3(kBrightest)), 1.0);
    if (viewMode() == VIEW_TIERS) color.rgb = mix(vec3(0.25), vec3(0.05, 0.75, 0.1), far);
    if (viewMode() == VIEW_NORMALS) color.rgb = n * 0.5 + 0.5;
    if (viewMode() == VIEW_OVERDRAW) color.rgb = vec3(1.0 / 32.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY) color.rgb = GRASS ? mix(vec3(0.35, 0.18, 0.05), vec3(0.1, 0.9, 0.2), clamp(g.total, 0.0, 1.0)) : vec3(0.35, 0.18, 0.05);
}
