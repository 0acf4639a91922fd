// The brush on whatever is seen: a ring at its radius, a disc that fades as the brush does.
#include "lib/frame.glsl"
#include "lib/scene_depth.glsl"
out vec4 color;
void main() {
    float depth = sceneDepth(ivec2(gl_FragCoord.xy));
    if (depth <= 0.0) discard;
    vec4 p = frame.invViewProj * vec4(gl_FragCoord.xy * frame.pixelShare * 2.0 - 1.0, depth, 1.0);
    vec2 at = p.xz / p.w;
    float r = distance(at, frame.decalAt) / frame.decalRadius;
    float pixel = max(fwidth(r), 1e-4);
    float ring = 1.0 - smoothstep(1.0, 2.5, abs(r - 1.0) / pixel);
    float disc = r < 1.0 ? 0.22 * (1.0 - smoothstep(1.0 - frame.decalFalloff, 1.0, r)) : 0.0;
    float core = 1.0 - smoothstep(1.0, 2.0, abs(r - (1.0 - frame.decalFalloff)) / pixel);
    float alpha = max(max(ring * 0.95, disc), core * 0.35 * step(0.02, frame.decalFalloff));
    if (alpha <= 0.0) discard;
    color = vec4(mix(vec3(1.0, 0.72, 0.15), vec3(1.0), ring * 0.5), alpha);
}
