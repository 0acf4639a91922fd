// The mean of this frame's sample and of what the frames before had where the pixel was then (engine/post/antialias.h).
#include "lib/frame.glsl"
#include "shared/bindings.h"

layout(binding = TEX_SCENE) uniform sampler2D scene;
layout(binding = TEX_DEPTH) uniform sampler2D depths;
layout(binding = TEX_MOTION) uniform sampler2D motions;
layout(binding = TEX_HISTORY) uniform sampler2D history;  // mean; number of frames
layout(binding = TEX_HISTORY_DISTANCE) uniform sampler2D distances;
layout(location = 0) uniform mat4 seen;  // eye-relative to clip, not moved by a part of a pixel
layout(location = 1) uniform mat4
    seenBefore;                           // the same of the frame before, from positions relative to this frame's eye
layout(location = 2) uniform float most;  // frames that a mean may be of; 1: there were none
layout(location = 3) uniform bool still;  // nothing moved, nor did time go on
layout(location = 0) out vec4 mean;
layout(location = 1) out float distance_;  // metres along the eye's axis; below 0: something about the pixel moved

const float kNear = 0.05;           // metres: the near plane, so that distance = near / depth
const float kNever = 1e9;           // metres: nothing is there
const float kUnmoved = 1.0 / 64.0;  // pixels
const float kOff = 0.05;            // share by which distances of one thing may differ from frame to frame
const float kInFront = 1.25;        // times as near: not the same thing
const float kGuess = 2.0;    // frames for which the mean of the pixels around stands where there is nothing to keep
const float kCarried = 6.0;  // pixels along which a mean is carried: each look-up between pixels blurs it
const float kSpread = 1.25;  // standard deviations of the colours around by which what is kept may differ from them

// The 3 x 3 pixels around one.
struct Around {
    vec3 mean, spread, low, high;
    ivec2 leads;  // the pixel whose motion the middle one follows: edges go with what stands far in front
    float depth;  // there
    bool moves;   // something in them does by itself
};

ivec2 inside(ivec2 pixel) { return clamp(pixel, ivec2(0), ivec2(frame.pixels) - 1); }
vec3 lightAt(ivec2 pixel) {
    vec3 c = texelFetch(scene, pixel, 0).rgb;
    return all(lessThan(abs(c), vec3(kBrightest * 2.0))) ? c : vec3(0.0);  // false for NaN
}

Around around(ivec2 pixel) {
    float own = texelFetch(depths, pixel, 0).r;
    Around a = Around(vec3(0.0), vec3(0.0), vec3(kBrightest), vec3(0.0), pixel, own, false);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 there = inside(pixel + ivec2(x, y));
            vec3 c = lightAt(there);
            float depth = texelFetch(depths, there, 0).r;
            a.mean += c / 9.0;
            a.spread += c * c / 9.0;
            a.low = min(a.low, c), a.high = max(a.high, c);
            a.moves = a.moves || texelFetch(motions, there, 0).xyz != vec3(0.0);
            if (depth > a.depth && depth > kInFront * own) a.depth = depth, a.leads = there;
        }
    a.spread = sqrt(max(a.spread - a.mean * a.mean, vec3(0.0)));
    return a;
}

// Where in the frame before what `pixel` shows was, in pixels from there to here; w: metres along the eye's axis then.
struct Way {
    vec2 moved;
    float far;
    bool known;
};
Way wayOf(ivec2 pixel, float depth) {
    vec2 at = (vec2(pixel) + 0.5) * frame.pixelShare * 2.0 - 1.0;
    vec4 here = frame.invViewProj * vec4(at, depth, 1.0);  // w is 0 infinitely far away
    vec4 there = vec4(here.xyz - texelFetch(motions, pixel, 0).xyz * here.w, here.w);
    vec4 now = seen * here, then = seenBefore * there;
    Way w;
    w.known = then.w > 0.0;
    w.moved = (now.xy / now.w - then.xy / max(then.w, 1e-9)) * 0.5 * frame.pixels;
    w.far = here.w > 0.0 ? min(then.w / here.w, kNever) : kNever;
    return w;
}

// What was seen about a place in the frame before, whether none of it as far away as `far`, and whether some of it
// stood far in front of the rest.
struct Before {
    bool hidden, edge;
};
Before beforeAt(vec2 at, float far) {
    float low = kNever * 2.0, high = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            float d = abs(texelFetch(distances, inside(ivec2(floor(at)) + ivec2(x, y)), 0).r);
            low = min(low, d), high = max(high, d);
        }
    return Before(high < far * (1.0 - kOff) || low > far * (1.0 + kOff), high > low * kInFront);
}

// The history between its pixels: Catmull and Rom's cubic, so that what is looked up frame after frame stays sharp.
vec3 historyAt(vec2 at) {
    vec2 middle = floor(at - 0.5) + 0.5, f = at - middle;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f)), w1 = 1.0 + f * f * (-2.5 + 1.5 * f),
         w2 = f * (0.5 + f * (2.0 - 1.5 * f)), w3 = f * f * (-0.5 + 0.5 * f);
    vec2 both = w1 + w2, places[3] = vec2[3](middle - 1.0, middle + w2 / both, middle + 2.0),
         weights[3] = vec2[3](w0, both, w3);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            if (x != 1 && y != 1) continue;  // corners weigh next to nothing
            float weight = weights[x].x * weights[y].y;
            sum += weight * textureLod(history, vec2(places[x].x, places[y].y) * frame.pixelShare, 0.0).rgb;
            total += weight;
        }
    return max(sum / total, vec3(0.0));
}

// Mean so far, and of how many frames, as far as it holds for the pixel.
vec4 kept(ivec2 pixel, Around a) {
    Way w = wayOf(a.leads, a.depth);
    vec2 from = vec2(pixel) + 0.5 - w.moved;
    bool here = all(lessThan(abs(w.moved), vec2(kUnmoved)));
    bool moved = a.moves || texelFetch(distances, pixel, 0).r < 0.0;  // what was there may have left it
    if (here && !moved) return texelFetch(history, pixel, 0);
    Before before = beforeAt(from, w.far);
    if (!w.known || any(lessThan(from, vec2(0.0))) || any(greaterThan(from, frame.pixels)) || before.hidden)
        return vec4(a.mean, kGuess);
    vec4 was = here ? texelFetch(history, pixel, 0) : vec4(historyAt(from), texelFetch(history, ivec2(from), 0).a);
    was.a = min(was.a, kCarried / max(length(w.moved), kUnmoved));
    if (!moved && !before.edge) return was;
    vec3 low = max(a.low, a.mean - kSpread * a.spread), high = min(a.high, a.mean + kSpread * a.spread);
    return vec4(clamp(was.rgb, low, high), was.a);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Around a = around(pixel);
    distance_ = min(kNear / max(texelFetch(depths, pixel, 0).r, 1e-12), kNever) * (a.moves ? -1.0 : 1.0);
    vec4 was = vec4(0.0);
    if (still)
        was = texelFetch(history, pixel, 0);
    else if (most > 1.0)
        was = kept(pixel, a);
    float frames = min(was.a, most - 1.0) + 1.0;
    mean = vec4(was.rgb + (lightAt(pixel) - was.rgb) / frames, frames);
}
