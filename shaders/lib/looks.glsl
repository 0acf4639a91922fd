// Maps read over pixels that lie along the ground, much longer than wide: with one level of detail both ways lines on a
// pitch and edges of stripes and paths would run out wide. As few looks along a pixel's length as make each as long as
// wide, but at most kLooks; by hand, because software renderers take a thousand times longer for anisotropic filtering.
// Fragment shaders only.
#include "lib/frame.glsl"

const float kLooks = 8.0;
const float kFiner = 1.0;  // levels: each look is blurred by a texel and more, which a pixel's samples do anyway

// Looks at a map: the first, the way from each to the next, how many, and their level of detail.
struct Looks {
    vec2 at, way;
    float number, level;
};
// at: its texture coordinates at the pixel; size: of the map, texels.
Looks looksAt(vec2 at, vec2 size) {
    vec2 x = frame.lookShare * dFdx(at), y = frame.lookShare * dFdy(at);
    float acrossX = length(x * size), acrossY = length(y * size), most = max(acrossX, acrossY),
          wide = max(min(acrossX, acrossY), 1.0), number = clamp(ceil(most / wide), 1.0, kLooks);
    vec2 way = (acrossX > acrossY ? x : y) / number;
    return Looks(at - 0.5 * (number - 1.0) * way, way, number, log2(max(most / number, wide)) - kFiner);
}
// The mean of a map's colours, each by its opacity, and that of opacity. within: what opacity there is where there is
// colour, as far as looks tell it: a line that is narrower than a pixel is as opaque as a wide one.
vec4 colorAlong(sampler2D map, vec2 at, out float within) {
    Looks l = looksAt(at, vec2(textureSize(map, 0)));
    vec4 sum = vec4(0.0);
    float squares = 0.0;
    for (float i = 0.0; i < l.number; i += 1.0) {
        vec4 one = textureLod(map, l.at + i * l.way, l.level);
        sum += vec4(one.rgb * one.a, one.a);
        squares += one.a * one.a;
    }
    within = squares / max(sum.a, 1e-4);
    return vec4(sum.rgb / max(sum.a, 1e-4), sum.a / l.number);
}
