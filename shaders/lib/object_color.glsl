// What a view shows of an object's surface: its light in the haze, or what the view's mode asks for.
#include "lib/frame.glsl"
#include "lib/light.glsl"

// light: from the surface to the eye; n: its unit normal; position: relative to the eye.
vec4 objectColor(vec3 light, vec3 n, vec3 position) {
    if (viewMode() == VIEW_TIERS || viewMode() == VIEW_DENSITY) return vec4(vec3(0.25), 1.0);
    if (viewMode() == VIEW_NORMALS) return vec4(n * 0.5 + 0.5, 1.0);
    if (viewMode() == VIEW_OVERDRAW) return vec4(1.0 / 32.0, 0.0, 0.0, 1.0);
    return vec4(mix(light, hazeColor(position), hazeShare(length(position))), 1.0);
}
