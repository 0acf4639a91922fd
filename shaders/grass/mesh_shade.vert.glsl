// A corner of the surface of a mesh on which grass grows, where the mesh was drawn.
#include "lib/frame.glsl"
#include "lib/mirror.glsl"

layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec2 meshUv;
layout(location = 10) uniform vec4 rows[3];  // from the mesh to positions relative to the eye
layout(location = 13) uniform float scale;   // metres that the mesh's unit is

out vec3 position;  // relative to the eye
out vec3 normal;
out vec2 uv;

void main() {
    vec4 p = vec4(meshPosition, 1.0);
    position = vec3(dot(rows[0], p), dot(rows[1], p), dot(rows[2], p));
    normal = vec3(dot(rows[0].xyz, meshNormal), dot(rows[1].xyz, meshNormal), dot(rows[2].xyz, meshNormal)) / scale;
    uv = meshUv;
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
