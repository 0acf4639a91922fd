// A vertex of what casts a shadow, as the sun sees it.
#include "shared/objects.h"
layout(std140, binding = UBO_SHADOW) uniform ShadowBlock { ShadowGlobals shadow; };
layout(location = 1) uniform int map;
layout(location = 0) in vec3 meshPosition;
layout(location = 2) in vec2 meshUv;
layout(location = 3) in vec4 row0;
layout(location = 4) in vec4 row1;
layout(location = 5) in vec4 row2;

out vec2 uv;

void main() {
    vec4 p = vec4(meshPosition, 1.0);
    vec3 at = (shadow.cascades[map].toMap * vec4(dot(row0, p), dot(row1, p), dot(row2, p), 1.0)).xyz;
    uv = meshUv;
    gl_Position = vec4(at.xy * 2.0 - 1.0, at.z, 1.0);
}
