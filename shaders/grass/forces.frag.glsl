// A force's push, added to others', and its press, of which the strongest counts (by the blending).
#include "numerics/gust.h"

in vec2 place;
flat in vec4 ends;
flat in vec3 extent;
out vec4 color;

void main() {
    vec3 f = longForce(place, ends.zw - ends.xy, extent.x, extent.y, extent.z);
    color = vec4(f.xy, 0.0, f.z);
}
