// What a forest leaves of the sky's light on the ground below it, multiplied onto the picture; the sun's is taken where
// the ground is lit (lib/shadow.glsl), and lamps' light stays as it is.
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"

in vec3 position;
in vec2 place;
in vec3 normal;
out vec4 color;

const float kOpen = 0.996;  // what 8 bits show as the whole sky

void main() {
    float open = texture(forestShade, place * frame.terrainShare).g;
    if (open > kOpen) discard;
    vec3 n = normalize(normal), sky = ambientLight(n), sun = vec3(0.0);
    if (SUN) sun = sunLight(n) * sunVisible(position, vec3(0.0));
    if (LAMPS) sun += lampLight(position, n, vec3(0.0));
    vec3 left = (sky * open + sun) / max(sky + sun, vec3(1e-6));
    color = vec4(mix(left, vec3(1.0), hazeShare(length(position))), 1.0);
}
