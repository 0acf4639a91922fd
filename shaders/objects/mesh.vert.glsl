// A vertex of an object, placed relative to the eye.
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/object_light.glsl"

invariant gl_Position;  // the same in the programs that draw an object and the shade on it

layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec2 meshUv;
layout(location = 3) in vec4 row0;
layout(location = 4) in vec4 row1;
layout(location = 5) in vec4 row2;
layout(location = 6) in uint firstLight;

out vec3 position;  // relative to the eye
out vec3 normal;
out vec2 uv;
out vec3 around;  // light from all around; red below 0: as on open ground

void main() {
    vec4 p = vec4(meshPosition, 1.0);
    position = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
    normal = vec3(dot(row0.xyz, meshNormal), dot(row1.xyz, meshNormal), dot(row2.xyz, meshNormal));
    uv = meshUv;
    around = objectLightAt(firstLight, uint(gl_VertexID));
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
