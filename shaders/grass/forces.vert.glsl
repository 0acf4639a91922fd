// A corner of the square around one force (world/forces.h) in the map around the eye.
#include "lib/frame.glsl"
#include "shared/wind.h"
layout(std140, binding = UBO_FORCE) uniform ForceBlock { ForceGlobals force; };
layout(location = 0) in vec4 line;  // begin and end of its line: x, z relative to the eye
layout(location = 1) in vec3 size;  // radius, reach in radii, share

out vec2 place;  // from the line's begin
flat out vec4 ends;
flat out vec3 extent;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1), far = vec2(size.x * size.y);
    vec2 at = mix(min(line.xy, line.zw) - far, max(line.xy, line.zw) + far, corner);
    place = at - line.xy;
    ends = line;
    extent = size;
    gl_Position = vec4((at - force.corner) * force.share * 2.0 - 1.0, 0.5, 1.0);
}
