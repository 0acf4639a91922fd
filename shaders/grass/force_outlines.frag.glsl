// What an outline throws at a place: its push, added to others', and its press, of which the strongest counts (by the
// blending). As outlineAt (mesh/footprint.h) and forceAt (world/forces.h) on the CPU.
#include "numerics/gust.h"
#include "shared/bindings.h"

layout(binding = TEX_OBJECT) uniform sampler2D distances;
layout(location = 2) uniform float share;      // of the force that is left
layout(location = 3) uniform float radius;     // m
layout(location = 4) uniform float reach;      // radii
layout(location = 5) uniform vec2 heading;     // cosine and sine of its turn
layout(location = 6) uniform vec2 rasterLow;   // x, z where the distances begin, in the outline's units
layout(location = 7) uniform vec2 rasterSize;  // x, z, in those
layout(location = 8) uniform float metres;     // a unit
layout(location = 9) uniform float texel;      // units a texel

in vec2 place;
out vec4 color;

float distanceAt(vec2 at) { return textureLod(distances, (at - rasterLow) / rasterSize, 0.0).r; }

void main() {
    vec2 at = vec2(heading.x * place.x - heading.y * place.y, heading.y * place.x + heading.x * place.y) / metres;
    vec2 beside = at - clamp(at, rasterLow, rasterLow + rasterSize);
    float far = length(beside), d = texel;
    vec2 slope = far > 0.0 ? beside / far
                           : vec2(distanceAt(at + vec2(d, 0.0)) - distanceAt(at - vec2(d, 0.0)),
                                  distanceAt(at + vec2(0.0, d)) - distanceAt(at - vec2(0.0, d))) /
                                 (2.0 * d);
    vec2 turned = vec2(heading.x * slope.x + heading.y * slope.y, heading.x * slope.y - heading.y * slope.x);
    vec3 f = outlineForce((distanceAt(at) + far) * metres, turned, radius, reach, share);
    color = vec4(f.xy, 0.0, f.z);
}
