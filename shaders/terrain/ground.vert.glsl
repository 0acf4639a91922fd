// The ground's corners.
#include "lib/frame.glsl"
#include "lib/heights.glsl"
#include "lib/mirror.glsl"
#include "lib/node.glsl"

invariant gl_Position;  // the same in all programs that draw these corners
out vec3 position;      // relative to the eye
out vec2 place;         // relative to the terrain's corner, metres
out vec3 normal;

void main() {
    NodeCorner c = nodeCorner();
    position = c.position;
    place = c.place;
    normal = groundNormal(place, c.spacing);
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
