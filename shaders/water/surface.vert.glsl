// The corners of what may be seen of the water.
#include "lib/frame.glsl"
#include "shared/water.h"
layout(std140, binding = UBO_WATER) uniform WaterBlock { WaterGlobals water; };
out vec3 position;  // relative to the eye

void main() {
    vec2 share = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    vec2 at = mix(water.low, water.high, share);
    position = vec3(at.x, water.height, at.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
