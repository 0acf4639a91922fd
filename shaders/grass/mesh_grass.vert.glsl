// A corner of the shell over a mesh: its surface, lifted by the height of the slices (Habel, Wimmer and Jeschke 2007,
// section 3; mesh/carrier.h). INSIDE: for an eye within the shell, a corner of the whole picture; the vertex is the
// surface under the eye. Needs: const bool INSIDE.
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/object_light.glsl"
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
layout(location = 8) in float meshPart;
layout(location = 9) in uint meshVertex;
layout(location = 10) uniform vec4 rows[3];     // from the mesh to positions relative to the eye
layout(location = 13) uniform float scale;      // metres that the mesh's unit is
layout(location = 14) uniform float lifted;     // over the surface, in heights of the slices
layout(location = 15) uniform float firstPart;  // of the mesh, among the parts of all
layout(location = 16) uniform uint firstLight;

out vec3 position;  // relative to the eye; INSIDE: somewhere along the ray
out vec3 normal;
out vec2 uv;
out vec3 alongU;  // a metre
out vec3 alongV;
out vec3 bend;  // 1/m
out float lift;
out vec3 around;  // light from all around on the surface; red below 0: as on open ground
flat out vec4 chart;
flat out float part;  // of all shells; below 0: it has an edge

vec3 turned(vec3 v) { return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v)) / scale; }

void main() {
    vec4 p = vec4(meshPosition, 1.0);
    normal = turned(meshNormal);
    position = vec3(dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)) + normal * (meshLift * lifted * slices.top);
    uv = meshUv;
    alongU = turned(meshAlongU) / scale;
    alongV = turned(meshAlongV) / scale;
    bend = meshBend / scale;
    lift = meshLift * lifted;
    around = objectLightAt(firstLight, meshVertex);
    chart = meshChart;
    part = meshPart + sign(meshPart) * firstPart;
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
    if (INSIDE) {
        vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
        vec4 ahead = frame.invViewProj * vec4(at, 0.5, 1.0);
        position = ahead.xyz / ahead.w;
        cutAtWater(0.0);
        gl_Position = vec4(at, 1.0, 1.0);
    }
}
