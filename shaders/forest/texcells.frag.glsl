// What a slice shows of the trees in its tile: leaves lit by sun and sky through the air above and around them, by each
// other, by lamps through the leaves on the way there, and by what shines through them, in the haze. Each tree stands
// on the ground at its own foot, whatever the slice's plane.
#include "lib/canopy.glsl"
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/lamps.glsl"
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
flat in int sunRise;
flat in int level;
layout(location = 0) out vec4 color;
layout(location = 1) out float depth;

// Leaves on the way to a lamp: so many steps of so many metres from a leaf on; by then most crowns end.
const int kLampSteps = 6;
const float kLampStep = 0.8;
const float kLampUnseen = 1e-3;  // light of which no screen shows what leaves send back

// Share of the light from a direction that comes through the leaves before a leaf: those of its own tree (slot), and of
// the others so many as stand around. uv, at: where it is; reach: metres to the lamp.
float pastLeaves(vec3 towards, float reach, vec2 uv, float at, uint slot) {
    float level = clamp(round(log2(kLampStep * forest.slabs / forest.height)), 0.0, log2(forest.slabs));
    float fine = forest.slabs * exp2(-level), first = 2.0 * (forest.slabs - fine),
          mip = log2(max(kLampStep / forest.voxel, 1.0)), step = min(kLampStep, reach / float(kLampSteps)), thick = 0.0;
    vec3 way = vec3(toLattice(towards.xz, forest.edge) / forest.cells, towards.y / forest.height) * step;
    ivec2 side = textureSize(slots, 0);
    for (int i = 0; i < kLampSteps; ++i) {
        vec3 there = vec3(uv, at) + way * (float(i) + 0.5);
        if (!(there.z > 0.0 && there.z < 1.0)) continue;
        float opacity = textureLod(slabs, vec3(there.xy, first + floor(there.z * fine)), mip).a;
        bool own = texelFetch(slots, ivec2(fract(there.xy) * vec2(side)), 0).r == slot;
        thick -= logOneMinus(min(opacity, 0.999)) * (own ? 1.0 : canopy.y);
    }
    // In slabs as they were baked.
    float stretch = length(towards * vec3(forest.verticalScale, 1.0, forest.verticalScale)) / length(towards);
    return exp(-thick * stretch * step * fine / forest.height);
}
// Light of lamps that leaves send back, and that shines through them, as the sun's (main).
void addLamps(TreeInView tree, vec2 uv, float at, uint slot, inout vec3 light, inout vec3 passed) {
    vec3 toEye = normalize(-position);
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampAt(i, position);
        if (!(max(max(l.light.r, l.light.g), l.light.b) > kLampUnseen)) continue;
        float visible = lampVisible(i, position, vec3(0.0)), cosine = dot(toEye, l.direction);
        float reach = lamps.lights[i].isPoint > 0.0 ? length(lamps.lights[i].place - position) : 1e6;
        if (visible > 0.0) visible *= pastLeaves(l.direction, reach, uv, at, slot);
        visible *= tree.level + (tree.upright - tree.level) * l.direction.y * l.direction.y;
        light += l.light * (visible * foliagePhase(cosine));
        passed += l.light * (visible * tree.through * foliagePhase(-cosine));
    }
}

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
    vec4 shares = max(lightShares(uv, at, sunRise), vec4(LEAST_LIGHT));
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
    if (LAMPS) addLamps(tree, uv, at, slot, light, passed);
    vec3 sent = leaves.rgb * light + leafThrough(leaves.rgb) * passed;
    if (LAMPS) sent = min(sent, vec3(kBrightest));
    color = vec4(mix(sent, leaves.a * haze.rgb, haze.a), leaves.a);
    if (viewMode() == VIEW_TIERS) color.rgb = leaves.a * vec3(0.1, 0.25, 0.5);
    if (viewMode() == VIEW_DENSITY) color.rgb = leaves.a * vec3(0.25);
    if (viewMode() == VIEW_NORMALS) color.rgb = leaves.a * (facing * 0.5 + 0.5);
    if (viewMode() == VIEW_OVERDRAW) color = vec4(1.0 / 32.0, 0.0, 0.0, 0.0);
}
