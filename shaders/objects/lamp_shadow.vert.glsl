// A vertex of what casts a shadow, as a lamp sees it.
layout(location = 1) uniform vec4 toClip[4];  // rows: from positions relative to the eye
layout(location = 0) in vec3 meshPosition;
layout(location = 2) in vec2 meshUv;
layout(location = 3) in vec4 row0;
layout(location = 4) in vec4 row1;
layout(location = 5) in vec4 row2;

out vec2 uv;

void main() {
    vec4 p = vec4(meshPosition, 1.0), at = vec4(dot(row0, p), dot(row1, p), dot(row2, p), 1.0);
    uv = meshUv;
    gl_Position = vec4(dot(toClip[0], at), dot(toClip[1], at), dot(toClip[2], at), dot(toClip[3], at));
}
