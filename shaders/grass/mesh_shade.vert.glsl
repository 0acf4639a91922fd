// A corner of the surface of a mesh on which grass grows, where the mesh was drawn.
#include "lib/frame.glsl"
#include "lib/density.glsl"
#include "lib/mirror.glsl"
#include "lib/object_light.glsl"
#include "shared/bindings.h"
#include "shared/slices.h"

layout(std140, binding = UBO_SLICES) uniform SliceBlock { SliceGlobals slices; };

invariant gl_Position;  // the same in the programs that draw an object and the shade on it

layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec2 meshUv;
layout(location = 3) in vec3 meshAlongU;
layout(location = 4) in vec3 meshAlongV;
layout(location = 5) in vec3 meshBend;
layout(location = 9) in uint meshVertex;
layout(location = 4) uniform float uvLength;  // metres that one unit of texture coordinates is
layout(location = 10) uniform vec4 rows[3];   // from the mesh to positions relative to the eye
layout(location = 13) uniform float scale;    // metres that the mesh's unit is
layout(location = 16) uniform uint firstLight;

out vec3 position;  // relative to the eye
out vec3 normal;
out vec2 uv;
out vec3 around;    // light from all around; red below 0: as on open ground
out float crowded;  // how many times as much grass stands on a square metre as the field has

// Share of its leaves that a place keeps: over a surface that bends away, half way up, they have more room.
float keptOver(vec3 bend, float height) {
    vec3 wider = 0.5 * height * bend;
    return 1.0 / max((1.0 + wider.x) * (1.0 + wider.z) - wider.y * wider.y, 0.25);
}

void main() {
    vec4 p = vec4(meshPosition, 1.0);
    position = vec3(dot(rows[0], p), dot(rows[1], p), dot(rows[2], p));
    normal = vec3(dot(rows[0].xyz, meshNormal), dot(rows[1].xyz, meshNormal), dot(rows[2].xyz, meshNormal)) / scale;
    uv = meshUv;
    around = objectLightAt(firstLight, meshVertex);
    crowded = length(cross(meshAlongU, meshAlongV)) * (uvLength * uvLength / (scale * scale)) *
              keptOver(meshBend / scale, field.species[slices.species].height);
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
