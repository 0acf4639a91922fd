// Maps read over pixels that lie along the ground, much longer than wide: with one level of detail both ways lines on a
// pitch and edges of stripes and paths would run out wide. As few looks along a pixel's length as make each as long as
// wide, but at most kLooks; by hand, because software renderers take a thousand times longer for anisotropic filtering.
// Fragment shaders only. Needs: const bool TEMPORAL.

const float kLooks = 8.0;
const float kFiner = 1.0;  // levels: each look is blurred by a texel and more, which a pixel's samples do anyway
const float kPart = 0.35;  // of a pixel's width

// Looks at a map: the first, the way from each to the next, how many, and their level of detail.
struct Looks {
    vec2 at, way;
    float number, level;
};
// at: its texture coordinates at the pixel; size: of the map, texels.
Looks looksAt(vec2 at, vec2 size) {
    // Frames that add up each look at another place of the pixel, so that each sees a part of it.
    float share = TEMPORAL ? kPart : 1.0;
    vec2 x = share * dFdx(at), y = share * dFdy(at);
    float acrossX = length(x * size), acrossY = length(y * size), most = max(acrossX, acrossY),
          wide = max(min(acrossX, acrossY), 1.0), number = clamp(ceil(most / wide), 1.0, kLooks);
    vec2 way = (acrossX > acrossY ? x : y) / number;
    return Looks(at - 0.5 * (number - 1.0) * way, way, number, log2(max(most / number, wide)) - kFiner);
}
// The mean of a map's colours, each by its opacity, and that of opacity.
vec4 colorAlong(sampler2D map, vec2 at) {
    Looks l = looksAt(at, vec2(textureSize(map, 0)));
    vec4 sum = vec4(0.0);
    for (float i = 0.0; i < l.number; i += 1.0) {
        vec4 one = textureLod(map, l.at + i * l.way, l.level);
        sum += vec4(one.rgb * one.a, one.a);
    }
    return vec4(sum.rgb / max(sum.a, 1e-4), sum.a / l.number);
}
