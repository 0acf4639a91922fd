// What hills demand along a line of a lamp's light (lib/lamp_hills.glsl): an invocation walks a line, away from the
// lamp.
#include "lib/frame.glsl"
#include "lib/heights.glsl"
#include "lib/lamp_hills.glsl"
#include "shared/bindings.h"
#include "shared/terrain.h"

layout(local_size_x = 32) in;
layout(r32f, binding = IMAGE_LAMP_HILLS) writeonly uniform image2DArray hills;
layout(location = 0) uniform int lamp;

const float kNothing = -1e6;

void main() {
    int line = int(gl_GlobalInvocationID.x);
    float most = kNothing;
    for (int row = 0; row < LAMP_HILLS_STEPS; ++row) {
        imageStore(hills, ivec3(line, row, lamp), vec4(most));  // the ground here shades what is behind it
        vec2 at = (vec2(line, row) + 0.5) / vec2(LAMP_HILLS_LINES, LAMP_HILLS_STEPS), place = hillPlace(lamp, at);
        bool inside = all(greaterThanEqual(place, vec2(0.0))) && all(lessThanEqual(place, frame.terrainSize));
        if (inside) most = max(most, hillDemand(lamp, groundHeight(place), hillDistance(lamp, at.y)));
    }
}
