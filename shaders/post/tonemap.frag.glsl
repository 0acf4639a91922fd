// Linear light to the screen: Khronos PBR Neutral tone mapping (2024), which keeps hues, then sRGB. False-colour views
// are already in screen colours; others are dithered by half of one of the screen's 255 levels; depth is shown as the
// logarithm of the distance.
#include "lib/frame.glsl"
#include "lib/scene_depth.glsl"
#include "numerics/tonemap.h"
#include "shared/bindings.h"

layout(binding = TEX_SCENE) uniform sampler2D scene;
out vec4 color;

vec3 depthView(float depth) {
    float distance = 0.05 / max(depth, 1e-7);
    return vec3(depth <= 0.0 ? 1.0 : clamp(log2(distance / 0.1) / 14.0, 0.0, 1.0));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 light = texelFetch(scene, pixel, 0).rgb;
    vec3 shown = srgbEncode3(toneMapNeutral(max(light, vec3(0.0))));
    ivec2 place = pixel + ivec2(frame.pixelFrom);
    shown += ditherOf(place.x, place.y) / 255.0;
    if (viewMode() == VIEW_DEPTH)
        shown = depthView(sceneDepth(pixel));
    else if (viewMode() != VIEW_FINAL)
        shown = clamp(light, 0.0, 1.0);
    if (viewMode() == VIEW_OVERDRAW)
        shown =
            vec3(clamp(light.r * 2.0, 0.0, 1.0), clamp(light.r * 2.0 - 1.0, 0.0, 1.0), clamp(light.r - 1.0, 0.0, 1.0));
    color = vec4(shown, 1.0);
}
