// A painted map over the scene, looked at from above: what stands on a place takes the place's colour. Over painted
// forces, also those of what stands and went there. Needs: const bool FORCES, GRASS.
#include "lib/frame.glsl"
#include "lib/heights.glsl"
#include "lib/scene_depth.glsl"
#include "numerics/gust.h"
#include "shared/bindings.h"
#include "shared/wind.h"

layout(binding = TEX_SCENE) uniform sampler2D map;
layout(std140, binding = UBO_FORCE) uniform ForceBlock { ForceGlobals force; };
layout(binding = TEX_FORCE) uniform sampler2D forcesAround;
const int AMOUNTS = 1, DIRECTIONS = 2, FORCE_KIND = 3, HEIGHTS = 5;  // beside these: colours
layout(location = 0) uniform int kind;                               // of the map
layout(location = 1) uniform float tallest;  // metres: what stands higher is no grass, and keeps its colour
layout(location = 2) uniform bool painted;   // false: there is no map, only what presses by itself
layout(location = 3) uniform float tiling;   // of the map, as in shared/grass.h
layout(location = 4) uniform float pixel;    // metres, at a distance of 1 m
layout(location = 5) uniform float texels;   // of the map, a metre
layout(location =
           6) uniform vec3 relief;  // of the land: its lowest ground seen from the eye, 1 / metres, metres a contour
out vec4 color;

vec4 mapAt(vec2 place, float level) { return textureLod(map, tiled(mapPlace(place), tiling), level); }

vec3 amountColor(float amount) {
    const vec3 none = vec3(0.24, 0.05, 0.42), half_ = vec3(0.87, 0.30, 0.36), full = vec3(1.0, 0.92, 0.25);
    return amount < 0.5 ? mix(none, half_, amount * 2.0) : mix(half_, full, amount * 2.0 - 1.0);
}

// Where blades lean, its length the strength; 0 within a step of an 8-bit map.
vec2 leanOf(vec4 texel) {
    vec2 lean = texel.rg * 2.0 - 1.0;
    return length(lean) < 1.5 / 255.0 ? vec2(0.0) : lean / max(length(lean), 1.0);
}

// As blades meet it: painted, and of what stands and went there.
vec3 forceAt(vec2 place, float level) {
    vec3 sum = painted ? paintedForce(mapAt(place, level)) : vec3(0.0);
    vec2 inMap = (place - frame.eye.xz - force.corner) * force.share;
    if (FORCES && GRASS && inMap == clamp(inMap, vec2(0.0), vec2(1.0))) sum += textureLod(forcesAround, inMap, 0.0).rga;
    return forceOf(sum);
}

vec2 wayAt(vec2 place, float level) {
    return kind >= FORCE_KIND ? forceAt(place, level).xy : leanOf(mapAt(place, level));
}

// Hue by direction, clockwise from red in the north.
vec3 directionColor(vec2 lean) {
    float turn = atan(lean.x, -lean.y) / 6.2831853;
    vec3 hue = clamp(abs(fract(turn + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return mix(vec3(1.0), hue, length(lean));
}

// An arrow in each square of a grid whose pitch is about 40 pixels: 1 on it, with a soft edge of a pixel.
float arrow(vec2 place, float metresPerPixel) {
    float pitch = exp2(ceil(log2(metresPerPixel * 40.0)));
    vec2 middle = (floor(place / pitch) + 0.5) * pitch;
    vec2 lean = wayAt(middle, max(0.0, log2(pitch * texels) - (kind >= FORCE_KIND ? 3.0 : 1.0)));
    float strength = length(lean);
    if (strength < 0.04) return 0.0;
    vec2 d = lean / strength, from = (place - middle) / pitch;
    float size = 0.25 + 0.2 * strength;
    float along = dot(from, d) / size, across = abs(dot(from, vec2(-d.y, d.x))) / size;
    float width = metresPerPixel / (pitch * size);
    float shaft = max(across - 0.07, max(along - 0.4, -1.0 - along));
    float head = max((across - (1.0 - along) * 0.55) * 0.88, 0.3 - along);
    return 1.0 - smoothstep(0.0, 1.5 * width, min(shaft, head));
}

// Where the eye would see the ground if nothing stood on it: arrows lie there, or every blade would break them.
vec2 footOf(vec3 position, vec2 place) {
    float over = clamp(position.y - groundHeight(place), 0.0, 1.0);
    return place + position.xz * clamp(over / max(-position.y, 1e-3), 0.0, 0.5);
}

// Hue says where to, darkness how flat; what nothing presses on stays clear.
vec4 forceColor(vec3 f) {
    float push = length(f.xy);
    return vec4(directionColor(f.xy) * (1.0 - 0.4 * f.z), mix(0.06, 0.65, max(push, f.z)));
}

vec4 withArrows(vec4 seen, vec3 position, vec2 place, float metresPerPixel) {
    return mix(seen, vec4(0.03, 0.03, 0.05, 0.85), arrow(footOf(position, place), metresPerPixel));
}

vec4 directionView(vec3 position, vec2 place, vec2 lean, float metresPerPixel) {
    return withArrows(vec4(directionColor(lean), mix(0.1, 0.5, length(lean))), position, place, metresPerPixel);
}

vec3 srgb(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(max(c, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

// Low to high as amounts, with lines of equal height where they lie apart by some pixels.
vec4 heightView(vec2 place) {
    float up = groundHeight(place) - relief.x, contour = up / relief.z, pixels = 1.0 / max(fwidth(contour), 1e-6);
    float line = 1.0 - smoothstep(0.6, 1.4, abs(fract(contour + 0.5) - 0.5) * pixels);
    return mix(vec4(amountColor(clamp(up * relief.y, 0.0, 1.0)), 0.4), vec4(0.03, 0.03, 0.05, 0.8),
               line * smoothstep(4.0, 10.0, pixels));
}

void main() {
    float depth = sceneDepth(ivec2(gl_FragCoord.xy));
    if (depth <= 0.0) discard;
    vec4 p = frame.invViewProj * vec4(gl_FragCoord.xy * frame.pixelShare * 2.0 - 1.0, depth, 1.0);
    vec3 position = p.xyz / p.w;
    vec2 place = position.xz + frame.eye.xz;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, frame.terrainSize))) discard;
    if (position.y - groundHeight(place) > tallest) discard;
    float metresPerPixel = length(position) * pixel;
    float level = max(0.0, log2(metresPerPixel * texels));
    vec4 texel = painted ? mapAt(place, level) : vec4(0.0);
    if (kind <= AMOUNTS)
        color = vec4(amountColor(clamp(texel.r, 0.0, 1.0)), 0.55);
    else if (kind == DIRECTIONS)
        color = directionView(position, place, leanOf(texel), metresPerPixel);
    else if (kind == FORCE_KIND)
        color = withArrows(forceColor(forceAt(place, level)), position, place, metresPerPixel);
    else if (kind == HEIGHTS)
        color = heightView(footOf(position, place));
    else
        color = vec4(srgb(texel.rgb), texel.a * 0.75);
}
