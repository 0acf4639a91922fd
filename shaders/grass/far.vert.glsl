// Corners of the horizontal slice: the terrain's nodes, lifted (Boulanger, Pattanaik and Bouatouch 2006, section 4.1).
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/bilinear.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "lib/heights.glsl"
#include "numerics/weights.h"
#include "numerics/leaf.h"
#include "lib/light.glsl"
#include "lib/lamps.glsl"
#include "lib/cover.glsl"
#include "lib/slices.glsl"
#include "lib/node.glsl"
#include "lib/mirror.glsl"

out vec3 position;  // relative to the eye
out vec2 place;     // relative to the terrain's corner, metres

void main() {
    NodeCorner c = nodeCorner();
    place = c.place;
    position = c.position + vec3(0.0, slices.farHeight, 0.0);
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
