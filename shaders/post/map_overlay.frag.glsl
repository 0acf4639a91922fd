// A painted map over the scene, looked at from above: what stands on a place takes the place's colour.
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/bilinear.h"
#include "lib/heights.glsl"
#include "lib/scene_depth.glsl"
layout(binding = TEX_SCENE) uniform sampler2D map;
layout(location = 0) uniform vec4 overlay;  // channels; tiling, as in shared/frame.h; metres a pixel at 1 m; texels a metre
layout(location = 1) uniform float tallest;  // metres: what stands higher is no grass, and keeps its colour
out vec4 color;

vec4 mapAt(vec2 place, float level) {
    return textureLod(map, tiled(mapPlace(place), overlay.y), level);
}

vec3 amountColor(float amount) {
    const vec3 none = vec3(0.24, 0.05, 0.42), half_ = vec3(0.87, 0.30, 0.36), full = vec3(1.0, 0.92, 0.25);
    return amount < 0.5 ? mix(none, half_, amount * 2.0) : mix(half_, full, amount * 2.0 - 1.0);
}

// Where blades lean, its length the strength; 0 within a step of an 8-bit map.
vec2 leanOf(vec4 texel) {
    vec2 lean = texel.rg * 2.0 - 1.0;
    return length(lean) < 1.5 / 255.0 ? vec2(0.0) : lean / max(length(lean), 1.0);
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
    vec2 lean = leanOf(mapAt(middle, max(0.0, log2(pitch * overlay.w) - 1.0)));
    float strength = length(lean);
    if (strength < 0.04) return 0.0;
    vec2 d = lean / strength, from = (place - middle) / pitch;
    float size = 0.25 + 0.2 * strength;
    float along = dot(from, d) / size, across = abs(dot(from, vec2(-d.y, d.x))) / size;
    float pixel = metresPerPixel / (pitch * size);
    float shaft = max(across - 0.07, max(along - 0.4, -1.0 - along));
    float head = max((across - (1.0 - along) * 0.55) * 0.88, 0.3 - along);
    return 1.0 - smoothstep(0.0, 1.5 * pixel, min(shaft, head));
}

// Where the eye would see the ground if nothing stood on it: arrows lie there, or every blade would break them.
vec2 footOf(vec3 position, vec2 place) {
    float over = clamp(position.y - groundHeight(place), 0.0, 1.0);
    return place + position.xz * clamp(over / max(-position.y, 1e-3), 0.0, 0.5);
}

vec4 directionView(vec3 position, vec2 place, vec4 texel, float metresPerPixel) {
    vec2 lean = leanOf(texel);
    vec4 seen = vec4(directionColor(lean), mix(0.1, 0.5, length(lean)));
    return mix(seen, vec4(0.03, 0.03, 0.05, 0.85), arrow(footOf(position, place), metresPerPixel));
}

vec3 srgb(vec3 c) { return mix(12.92 * c, 1.055 * pow(max(c, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308))); }

void main() {
    float depth = sceneDepth(ivec2(gl_FragCoord.xy));
    if (depth <= 0.0) discard;
    vec4 p = frame.invViewProj * vec4(gl_FragCoord.xy * frame.viewport.zw * 2.0 - 1.0, depth, 1.0);
    vec3 position = p.xyz / p.w;
    vec2 place = position.xz + frame.eye.xz;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, frame.terrain.xy))) discard;
    if (position.y - groundHeight(place) > tallest) discard;
    float metresPerPixel = length(position) * overlay.z;
    vec4 texel = mapAt(place, max(0.0, log2(metresPerPixel * overlay.w)));
    if (overlay.x < 1.5) color = vec4(amountColor(clamp(texel.r, 0.0, 1.0)), 0.55);
    else if (overlay.x < 2.5) color = directionView(position, place, texel, metresPerPixel);
    else color = vec4(srgb(texel.rgb), texel.a * 0.75);
}
