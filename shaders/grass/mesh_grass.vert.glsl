// A corner of the shell over a mesh: its surface, lifted by the height of the slices (Habel, Wimmer and Jeschke 2007,
// section 3; mesh/carrier.h).
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "shared/bindings.h"
#include "shared/slices.h"

layout(std140, binding = UBO_SLICES) uniform SliceBlock { SliceGlobals slices; };
layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec2 meshUv;
layout(location = 3) in vec3 meshAlongU;
layout(location = 4) in vec3 meshAlongV;
layout(location = 5) in vec3 meshBend;
layout(location = 6) in float meshLift;
layout(location = 7) in vec4 meshChart;
layout(location = 10) uniform vec4 rows[3];  // from the mesh to positions relative to the eye
layout(location = 13) uniform float scale;   // metres that the mesh's unit is

out vec3 position;  // relative to the eye
out vec3 normal;
out vec2 uv;
out vec3 alongU;  // a metre
out vec3 alongV;
out vec3 bend;  // 1/m
out float lift;
flat out vec4 chart;

vec3 turned(vec3 v) { return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v)) / scale; }

void main() {
    vec4 p = vec4(meshPosition, 1.0);
    normal = turned(meshNormal);
    position = vec3(dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)) + normal * (meshLift * slices.top);
    uv = meshUv;
    alongU = turned(meshAlongU) / scale;
    alongV = turned(meshAlongV) / scale;
    bend = meshBend / scale;
    lift = meshLift;
    chart = meshChart;
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
