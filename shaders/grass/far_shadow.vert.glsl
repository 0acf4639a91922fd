// Corners of the ground that the horizontal slice shades.
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/bilinear.h"
#include "lib/heights.glsl"
#include "lib/node.glsl"

out vec3 position;
out vec2 place;
out vec3 normal;

void main() {
    NodeCorner c = nodeCorner();
    place = c.place;
    position = c.position;
    normal = groundNormal(place, c.spacing);
    gl_Position = frame.viewProj * vec4(position, 1.0);
    gl_Position.z *= 1.001;  // before the ground, by a thousandth of the distance
}
