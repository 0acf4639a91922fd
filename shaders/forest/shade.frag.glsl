// What a forest leaves of the sky's light on the ground below it, as a factor of the picture, and the haze before the
// ground, which that factor must not darken, as an addend; the sun's share is taken where the ground is lit
// (lib/shadow.glsl), and lamps' light stays as it is.
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"

in vec3 position;
in vec2 place;
in vec3 normal;
layout(location = 0, index = 0) out vec4 added;
layout(location = 0, index = 1) out vec4 times;

const float kOpen = 0.996;  // what 8 bits show as the whole sky

void main() {
    float open = texture(forestShade, place * frame.terrainShare).g;
    if (open > kOpen) discard;
    vec3 n = normalize(normal), sky = ambientLight(n), sun = vec3(0.0);
    if (SUN) sun = sunLight(n) * sunVisible(position, vec3(0.0));
    if (LAMPS) sun += lampLight(position, n, vec3(0.0));
    vec3 left = (sky * open + sun) / max(sky + sun, vec3(1e-6));
    times = vec4(left, 1.0);
    added = vec4((vec3(1.0) - left) * hazeShare(length(position)) * hazeColor(position), 0.0);
}
