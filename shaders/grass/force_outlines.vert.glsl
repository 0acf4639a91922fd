// A corner of the square around one outline (mesh/footprint.h) in the map around the eye.
#include "lib/frame.glsl"
#include "shared/wind.h"
layout(std140, binding = UBO_FORCE) uniform ForceBlock { ForceGlobals force; };
layout(
    location = 0) uniform vec4 around;  // x, z of its origin relative to the eye; how far the force reaches; its share

out vec2 place;  // from the origin

void main() {
    place = (2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0) * around.z;
    gl_Position = vec4((around.xy + place - force.corner) * force.share * 2.0 - 1.0, 0.5, 1.0);
}
