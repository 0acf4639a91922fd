// The carrier of a shell of slices: the terrain's nodes, lifted by the height of the slices; or, for an eye inside the
// shell, the whole picture (Habel, Wimmer and Jeschke 2007, section 3). Needs: const bool INSIDE.
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/node.glsl"
#include "shared/bindings.h"
#include "shared/slices.h"

layout(std140, binding = UBO_SLICES) uniform SliceBlock { SliceGlobals slices; };

layout(location = 4) uniform float reach;  // metres over the ground around the eye within which rays begin

out vec3 position;  // of the carrier, relative to the eye; INSIDE: somewhere along the ray
out vec2 place;     // relative to the terrain's corner, metres

void main() {
    if (INSIDE) {
        vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
        vec4 ahead = frame.invViewProj * vec4(at, 0.5, 1.0);
        position = ahead.xyz / ahead.w;
        place = frame.eye.xz;
        cutAtWater(0.0);
        gl_Position = vec4(at, 1.0, 1.0);
        return;
    }
    NodeCorner c = nodeCorner();
    // Level ground is a node or few: no more of it than has rays.
    vec2 near = TERRAIN_HEIGHTS ? c.position.xz : clamp(c.position.xz, -reach, reach);
    place = c.place + (near - c.position.xz);
    position = vec3(near.x, c.position.y + slices.top, near.y);
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
