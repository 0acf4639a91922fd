// A corner of the square around one outline (mesh/footprint.h) in the map around the eye.
#include "shared/bindings.h"
#include "shared/wind.h"

layout(std140, binding = UBO_FORCE) uniform ForceBlock { ForceGlobals force; };
layout(location = 0) uniform vec2 origin;  // x, z relative to the eye
layout(location = 1) uniform float far;    // how far the force reaches (m)

out vec2 place;  // from the origin

void main() {
    place = (2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0) * far;
    gl_Position = vec4((origin + place - force.corner) * force.share * 2.0 - 1.0, 0.5, 1.0);
}
