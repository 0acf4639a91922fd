// Corners of the horizontal slice: the terrain's nodes, lifted (Boulanger, Pattanaik and Bouatouch 2006, section 4.1).
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/node.glsl"
#include "shared/bindings.h"
#include "shared/slices.h"

layout(std140, binding = UBO_SLICES) uniform SliceBlock { SliceGlobals slices; };

out vec3 position;  // relative to the eye
out vec2 place;     // relative to the terrain's corner, metres

void main() {
    NodeCorner c = nodeCorner();
    place = c.place;
    position = c.position + vec3(0.0, slices.farHeight, 0.0);
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
