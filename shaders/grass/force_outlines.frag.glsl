// What an outline throws at a place: its push, added to others', and its press, of which the strongest counts (by the
// blending). As outlineAt (mesh/footprint.h) and forceAt (world/forces.h) on the CPU.
#include "numerics/gust.h"
#include "shared/bindings.h"

layout(binding = TEX_OBJECT) uniform sampler2D distances;
layout(location = 0) uniform vec4 around;
layout(location = 1) uniform vec4 rim;     // radius, reach; cosine and sine of its turn
layout(location = 2) uniform vec4 raster;  // low x, z; size x, z; in its units
layout(location = 3) uniform vec2 size;    // metres a unit; units a texel

in vec2 place;
out vec4 color;

float distanceAt(vec2 at) { return textureLod(distances, (at - raster.xy) / raster.zw, 0.0).r; }

void main() {
    vec2 at = vec2(rim.z * place.x - rim.w * place.y, rim.w * place.x + rim.z * place.y) / size.x;
    vec2 beside = at - clamp(at, raster.xy, raster.xy + raster.zw);
    float far = length(beside), d = size.y;
    vec2 slope = far > 0.0 ? beside / far
                           : vec2(distanceAt(at + vec2(d, 0.0)) - distanceAt(at - vec2(d, 0.0)),
                                  distanceAt(at + vec2(0.0, d)) - distanceAt(at - vec2(0.0, d))) /
                                 (2.0 * d);
    vec2 turned = vec2(rim.z * slope.x + rim.w * slope.y, rim.z * slope.y - rim.w * slope.x);
    vec3 f = outlineForce((distanceAt(at) + far) * size.x, turned, rim.x, rim.y, around.w);
    color = vec4(f.xy, 0.0, f.z);
}
