// What a slice shows of the trees in its tile: leaves lit by sun and sky through the air above and around them, by each
// other, and by what shines through them, in the haze. Each tree stands on the ground at its own foot, whatever the slice's plane.
#include "lib/canopy.glsl"
#include "lib/frame.glsl"
#include "lib/shadow.glsl"
#include "numerics/correction.h"
#include "numerics/forest.h"
#include "numerics/leaf.h"
#include "shared/bindings.h"
#include "shared/forest.h"

layout(std430, binding = SSBO_FOREST_FEET) readonly buffer FeetBlock { TreeInView feet[]; };
layout(binding = TEX_FOREST_SLABS) uniform sampler2DArray slabs;  // of all levels, one after the other
layout(binding = TEX_FOREST_SLOTS) uniform usampler2D slots;

// Of a pixel: texels of this size, filtered linearly, spread light as far as a pixel's square does (variance 1/12).
const float kSharper = 0.577;

in vec3 position;
in vec2 stored;
flat in int number;
flat in vec2 blend;
flat in vec3 facing;
in float path;
in vec4 haze;
flat in vec2 canopy;
flat in int level;
layout(location = 0) out vec4 color;
layout(location = 1) out float depth;

void main() {
    vec2 uv = stored / forest.cells;
    ivec2 side = textureSize(slots, 0);
    uint slot = texelFetch(slots, ivec2(fract(uv) * vec2(side)), 0).r;
    if (slot >= uint(FOREST_SLOTS)) discard;
    TreeInView tree = feet[number * FOREST_SLOTS + int(slot)];
    float at = (position.y - tree.foot) / forest.height;
    if (!(at > 0.0 && at < 1.0)) discard;  // no tree stands there, or the slice passes over or under it
    float distance = length(position);
    float mip = log2(max(kSharper * distance * forest.pixel / forest.voxel, 1.0));
    float fine = forest.slabs * exp2(-float(level)), first = 2.0 * (forest.slabs - fine);
    vec4 leaves = blend.x * textureLod(slabs, vec3(uv, first + floor(at * fine)), mip);
    if (blend.y > 0.0) leaves += blend.y * textureLod(slabs, vec3(uv, first + fine + floor(0.5 * at * fine)), mip);
    if (leaves.a < 1.0 / 512.0) discard;
    depth = gl_FragCoord.z;
    leaves = colorCorrected(leaves, path * tree.seen);
    // The stored air is full of trees; where fewer stand around, light comes through so much less of it.
    vec4 shares = max(lightShares(uv, at), vec4(LEAST_LIGHT));
    vec2 around = pow(shares.gb, canopy.yy);
    around.x = oddsTimes(around.x, tree.skyward);
    vec3 below = frame.groundLight * (around.y * pow(max(forest.floor, LEAST_LIGHT), canopy.y)),
         above = frame.skyLight * around.x;
    vec3 sky = above * tree.facing, sun = vec3(0.0);
    vec3 light = mix(below, sky, tree.sky), passed = tree.through * mix(sky, below, tree.sky);
    if (SUN) {
        // What its own crown takes is taken wherever the tree stands.
        float visible = shares.a * pow(min(shares.r / shares.a, 1.0), canopy.x);
        visible = oddsTimes(visible, tree.sunward);
        if (TERRAIN_SHADOWS && frame.sunIsUp > 0.0) visible *= sunPastHills(position);
        sun = frame.sunLight * visible;
        light += sun * tree.sun;
        passed += sun * tree.passed;
    }
    vec3 others = lightFromLeaves(vec3(tree.red, tree.green, tree.blue), sun, above, below, dot(around, vec2(0.5)));
    light += others;
    passed += tree.through * others;
    vec3 sent = leaves.rgb * light + leafThrough(leaves.rgb) * passed;
    color = vec4(mix(sent, leaves.a * haze.rgb, haze.a), leaves.a);
    if (viewMode() == VIEW_TIERS) color.rgb = leaves.a * vec3(0.1, 0.25, 0.5);
    if (viewMode() == VIEW_DENSITY) color.rgb = leaves.a * vec3(0.25);
    if (viewMode() == VIEW_NORMALS) color.rgb = leaves.a * (facing * 0.5 + 0.5);
    if (viewMode() == VIEW_OVERDRAW) color = vec4(1.0 / 32.0, 0.0, 0.0, 0.0);
}
