// A ray through a shell of vertical slices, front to back, from where it enters (Habel, Wimmer and Jeschke 2007,
// sections 3 and 4; H-1 to H-8), over level ground or over a mesh. Coordinates of the ray: x and z in cells of the
// field; height in metres below the shell's top. The place's lean and slope are taken off the ray, so that slices stand
// upright on level ground. Fragment shaders only. Needs: const bool INSIDE: the eye is in the shell; const int REST;
// const bool WHOLE: all of the patch's blades grow wherever any do; what lib/slices.glsl needs.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "lib/slice_light.glsl"
#include "lib/slices.glsl"
#include "lib/transparency.glsl"
#include "numerics/correction.h"
#include "numerics/hash.h"
#include "numerics/population.h"
#include "numerics/rays.h"
#include "numerics/stand.h"

const int REST_MEAN = 0, REST_OPAQUE = 1, REST_NOTHING = 2;
const float kCoarse = 4.0;   // level of detail that stands for slices in the mean
const float kNear = 0.05;    // metres: the near plane
const float kWave = 0.45;    // slices: how far one stands off its place at most
const float kTurned = 0.15;  // a slice that is seen edge on is filtered as one turned by so much

layout(location = 0) uniform int steps;
layout(location = 1) uniform float cutOff;
layout(location = 2) uniform float depthAt;
layout(location = 3) uniform float pixelsPerMetre;  // at one metre
layout(location = 6) uniform float footprint;       // pixels from slice to slice from which on all steps are taken

// What is the same along a ray.
struct Shell {
    vec3 way;      // unit, from the eye
    vec3 seen;     // that in the field's axes
    vec3 start;    // where it begins in the shell, relative to the eye
    float height;  // of the shell here, metres
    vec2 bend;     // curvature of the ground along the ray, 1/m, and by how much it grows a metre: 0 where it is level
    vec2 turned;   // share of the slices across x and across z that shows
    mat3 toField;  // from the world's axes to the field's
    vec3 raise;    // unit normal of the object below, 0 on the ground
    SunSeen sun;
    float sunRise, sunBend;        // over a mesh: sine of the sun's elevation; curvature towards it, 1/m
    vec3 gain, brighter, ambient;  // as SliceSpot has them
    float visible;                 // share of the sun that is seen from where it comes in, over a mesh
};

// What has come together along a ray.
struct Sum {
    vec3 light;  // times its opacity
    float through;
    float depth;  // metres from the start to where depthAt of the opacity was reached
};

// Bits of Met::sides; kAcrossZ: of a slice across z, else across x.
const int kBehind = 1, kMirrorX = 2, kMirrorZ = 4, kAcrossZ = 8;

// A slice where a ray meets it.
struct Met {
    vec3 texel;
    int sides;     // which side of it is seen, and how its cell is mirrored: kBehind, kMirrorX, kMirrorZ, kAcrossZ
    vec2 at;       // x, z in cells from slices.eyeCell
    float above;   // metres over the ground
    float t;       // metres from the start
    float chance;  // of the cell
};

// What grows there, as texelOpacity takes it; share of the sun that is seen from there; and the field's colour over the
// reflectance: by whoever traces.
float grownAt(Met m, Shell shell, float pixel);
float sunAt(Met m, Shell shell);
vec3 paintedAt(vec3 reflectance, Met m, Shell shell, float pixel);

// By how much the ground falls away under the ray, beside its slope.
float fallen(Shell shell, float t) { return (0.5 * shell.bend.x + shell.bend.y * t / 6.0) * t * t; }
// How far the ray is below the shell's top.
float heightAt(SliceRay ray, Shell shell, float t) { return ray.entry.z + ray.direction.z * t + fallen(shell, t); }

// axis: 0 for slices across x, 1 across z.
int sidesOf(Shell shell, int axis, vec2 mirror) {
    float from = axis == 0 ? shell.seen.x * mirror.x : shell.seen.z * mirror.y;
    return (from < 0.0 ? 0 : kBehind) | (mirror.x > 0.0 ? 0 : kMirrorX) | (mirror.y > 0.0 ? 0 : kMirrorZ) |
           (axis == 0 ? 0 : kAcrossZ);
}

// How far slices stand off their places at most, in slices. Only grass that is hardly taller than slices lie apart
// shows rows of them, and an eye within it sees none; blades that are tall are seen one by one, which waves would bend.
float waveMost() {
    if (INSIDE) return 0.0;
    return kWave * smoothstep(0.3, 0.6, slices.cellSize / (float(slices.slices) * slices.top));
}

// How far a slice stands off its place there, in slices: smooth noise along it, so that what slices show does not lie
// along straight lines, which a short lawn would show as a weave. k: the slice, from the eye's cell; along: slices.
float waveOf(int family, int k, float along) {
    ivec2 first = ivec2(slices.eyeCell) * slices.slices;
    int across = k + (family == kRayU ? first.x : first.y), whole = int(floor(along));
    int at = whole + (family == kRayU ? first.y : first.x);
    uint slice = hash2(uint(family), uint(across));
    float here = hashUnit(hashMix(slice ^ uint(at))), next = hashUnit(hashMix(slice ^ uint(at + 1)));
    return waveMost() * (2.0 * mix(here, next, smoothstep(0.0, 1.0, along - float(whole))) - 1.0);
}

// The ray from as many slices before its entry as may stand out into it.
SliceRay fromBefore(SliceRay r) {
    vec2 n = vec2(r.nu, r.nv), back = waveMost() / n * vec2(r.stepU, r.stepV);
    r.nextU = firstSlice(r.entry.x - back.x, r.direction.x, r.nu);
    r.nextV = firstSlice(r.entry.y - back.y, r.direction.y, r.nv);
    return r;
}

// The slice of a family that a ray comes to next, where it stands off its place. A ray along slices is moved by no more
// than one that meets them askew.
SliceHit nextOf(int family, SliceRay ray) {
    bool isU = family == kRayU;
    float n = float(slices.slices), inverse = isU ? ray.inverse.x : ray.inverse.y;
    float most = 2.0 / max(length(ray.direction.xy), kTiny);
    SliceHit hit;
    hit.family = family;
    hit.k = isU ? ray.nextU : ray.nextV;
    hit.t = (float(hit.k) / n - (isU ? ray.entry.x : ray.entry.y)) * inverse;
    vec3 place = ray.entry + ray.direction * clamp(hit.t, -1e3, 1e3);
    hit.t += waveOf(family, hit.k, (isU ? place.y : place.x) * n) / n * clamp(inverse, -most, most);
    hit.position = ray.entry + ray.direction * hit.t;
    return hit;
}

// What a ray meets next. Of two slices the nearer one where they stand, not that whose place is nearer: else what lies
// deeper, which is denser and darker, would hide what stands before it.
SliceHit waveHit(SliceRay ray) {
    SliceHit plain = sliceHit(ray);
    if (plain.family != kRayU && plain.family != kRayV) return plain;
    SliceHit u = nextOf(kRayU, ray), v = nextOf(kRayV, ray);
    return u.t <= v.t ? u : v;
}

Met metAt(SliceHit hit, Shell shell) {
    int n = slices.slices, axis = hit.family;
    float half_ = 0.5 / float(n), height = hit.position.z + fallen(shell, hit.t);
    vec2 c = hit.position.xy + vec2(half_);
    int across = int(floor(float(hit.k) / float(n))), k = hit.k - n * across;
    float along = axis == 0 ? c.y : c.x, whole = floor(along);
    ivec2 cell = axis == 0 ? ivec2(across, int(whole)) : ivec2(int(whole), across);
    CellVersion v = cellVersion(int(slices.eyeCell.x) + cell.x, int(slices.eyeCell.y) + cell.y, slices.seed);
    vec2 signs = axis == 0 ? v.mirror : v.mirror.yx, begin = axis == 0 ? v.shift : v.shift.yx;
    int layer = (signs.x > 0.0 ? k : n - 1 - k) + n - int(begin.x * float(n) + 0.5);  // repeats after n
    if (layer >= n) layer -= n;
    float in_ = along - whole;
    Met m;
    m.texel = vec3((signs.y > 0.0 ? 1.0 + in_ : 2.0 - in_) - begin.y, clamp(1.0 + height / shell.height, 0.0, 1.0),
                   float(axis * (slices.layers - n) + layer));
    m.sides = sidesOf(shell, axis, v.mirror);
    float here = (float(hit.k) + 0.5) / float(n);
    m.at = axis == 0 ? vec2(here, along) : vec2(along, here);
    m.above = shell.height + height;
    m.t = hit.t;
    m.chance = chanceOf(ivec2(slices.eyeCell) + cell);
    return m;
}

// What a slice there stores, and its opacity before shares of families; whether the place is bare.
float opacityOf(Met m, Shell shell, float level, float pixel, out vec4 stored, out bool bare) {
    stored = vec4(0.0);
    float density = grownAt(m, shell, pixel);
    bare = !(density > 0.0);
    if (bare) return 0.0;
    stored = textureLod(sliceThreshold, m.texel, level);
    if (WHOLE) return density * stored.y;  // what texelOpacity comes to at density 1
    return storedOpacity(stored, density, level, m.chance);
}

vec3 lightOf(Met m, Shell shell, vec3 at, float fine, float pixel, vec4 stored) {
    float side = (m.sides & kBehind) == 0 ? 1.0 : -1.0;
    vec2 mirror = vec2((m.sides & kMirrorX) == 0 ? 1.0 : -1.0, (m.sides & kMirrorZ) == 0 ? 1.0 : -1.0);
    int axis = (m.sides & kAcrossZ) == 0 ? 0 : 1;
    vec4 leaf = textureLod(sliceReflectance, m.texel, fine);
    leaf.rgb = paintedAt(leaf.rgb, m, shell, pixel);
    SliceSpot s;
    s.texel = m.texel;
    s.visible = sunAt(m, shell);
    s.images = sunImages(shell.sun, axis, side, mirror);
    s.lightLayer = side > 0.0 ? 0.0 : float(slices.layers);
    s.gain = shell.gain, s.brighter = shell.brighter, s.ambient = shell.ambient;
    for (int c = 0; c < 3; ++c) s.lamp[c] = vec4(0.0);
    if (LAMPS) lampsOnImages(at, vec4(side, mirror, float(axis)), shell.toField, shell.raise, s.lamp);
    s.fine = fine;
    return clamp(sliceRadiance(s, leaf.rgb, leaf.a, stored), vec3(0.0), vec3(kBrightest));
}

void add(inout Sum sum, vec3 light, float alpha, float t) {
    float a = clamp(alpha, 0.0, 1.0);
    if (sum.through > 1.0 - depthAt && sum.through * (1.0 - a) <= 1.0 - depthAt) sum.depth = t;
    sum.light += sum.through * a * light;
    sum.through *= 1.0 - a;
}

// Metres from the eye along a way to a depth of its pixel.
float distanceTo(float depth, vec3 way) {
    float ahead = (frame.viewProj * vec4(way, 0.0)).w;  // along the eye's axis, a metre of the way
    return kNear / max(depth * ahead, 1e-9);
}

// Width of a pixel so far off, metres.
float pixelAt(float distance) { return distance / pixelsPerMetre; }

float levelAt(float pixel, float facing) {
    vec2 texels =
        vec2(textureSize(sliceThreshold, 0).xy) * pixel / vec2(slices.cellSize * max(facing, kTurned), slices.top);
    return max(log2(max(max(texels.x, texels.y), 1e-6)) + log2(slices.sharpness), 0.0);
}

// A slice that a ray meets, with what it stores of light from above (front, back), its share of the ray's light, and
// the level of detail at which that is looked up.
struct Sent {
    float share;
    Met met;
    vec2 above;
    float fine;
};

// Its light times its share.
vec3 sentLight(Sent s, Shell shell, float pixel) {
    if (!(s.share > 0.0)) return vec3(0.0);
    vec3 at = shell.start + shell.way * s.met.t;
    return s.share * lightOf(s.met, shell, at, s.fine, pixel, vec4(0.0, 0.0, s.above));
}

bool meetsSlice(SliceHit hit) { return hit.family == kRayU || hit.family == kRayV; }

// Opacity that has come together along a ray, and the two slices that send the most of its light: the others are taken
// to be as bright as these in the mean, which spares two look-ups and the light of each.
struct Walk {
    SliceRay ray;
    SliceHit hit;  // what it meets next
    int left;      // steps
    int bare;      // more of them over bare ground, which cost little
    float through;
    float depth;  // as Sum has it
    float last;   // of the slices that were met, metres from the start
    Sent most, next;
};

// t: where it counts for the ray's depth, metres.
void meet(inout Walk walk, Sent s, float alpha, float t) {
    float a = alpha > 0.004 ? min(alpha, 1.0) : 0.0, left = walk.through * (1.0 - a);
    if (walk.through > 1.0 - depthAt && left <= 1.0 - depthAt) walk.depth = t;
    s.share = walk.through - left;
    walk.through = left;
    bool most = s.share > walk.most.share, next = s.share > walk.next.share;
    if (next) walk.next = s;
    if (most) walk.next = walk.most;
    if (most) walk.most = s;
}

// What slices from `hit` on would show up to the shell's end, as one slice more. Which of them is looked at, where, and
// how its cell is mirrored, is random: looked at where the ray goes on, coarse texels would show as blocks.
void meetRest(inout Walk walk, Shell shell, float pixel, uint grain) {
    SliceRay ray = walk.ray;
    SliceHit hit = walk.hit;
    if (REST == REST_NOTHING || !meetsSlice(hit) || !(walk.through > 1.0 - cutOff)) return;
    Sent s;
    s.fine = kCoarse;
    vec2 speed = abs(ray.direction.xy) * float(slices.slices);
    float left = max(ray.end - hit.t, 0.0), middle = hit.t + 0.5 * min(left, slices.cellSize);
    uint r = hash2(grain, 79u);
    int across = hit.family == kRayU ? 0 : 1, n = slices.slices;
    if (!WHOLE) s.met = metAt(hit, shell);  // its place says what grows there
    s.met.texel = vec3(hashUnit(r << 14), clamp(1.0 + heightAt(ray, shell, middle) / shell.height, 0.0, 1.0),
                       float(across * (slices.layers - n) + int((r >> 20) * uint(n) >> 12)));
    s.met.t = hit.t;
    s.met.sides = sidesOf(shell, across, vec2((r & 1u) == 0u ? 1.0 : -1.0, (r & 2u) == 0u ? 1.0 : -1.0));
    vec4 stored;
    bool bare;
    float alpha = opacityOf(s.met, shell, kCoarse, pixel, stored, bare);
    if (!(alpha > 0.0)) return;
    s.above = stored.zw;
    float slicesPerMetre = dot(speed, shell.turned), shown = 1.0 + left * slicesPerMetre;
    float all = REST == REST_OPAQUE ? 1.0 : correctionPow(alpha, min(shown, 64.0));
    // As deep as light comes in the mean.
    meet(walk, s, all, hit.t + min(left, 1.0 / max(alpha * slicesPerMetre, 1e-3)));
}

// Steps of a ray where a pixel is so wide: slices that lie within one are not told apart, and their mean will do.
int stepsAt(float pixel) {
    float apart = slices.cellSize / (float(slices.slices) * max(pixel, 1e-9));
    return int(clamp(ceil(float(steps) * apart / max(footprint, 1e-6)), 1.0, float(steps)));
}

bool goesOn(Walk walk) { return walk.left > 0 && meetsSlice(walk.hit) && walk.through > 1.0 - cutOff; }

// One slice on, if there is any.
void step(inout Walk walk, Shell shell, vec2 levels, float pixel) {
    bool on = goesOn(walk), isU = walk.hit.family == kRayU;
    float turned = isU ? shell.turned.x : shell.turned.y, level = isU ? levels.x : levels.y, alpha = 0.0;
    vec4 stored = vec4(0.0);
    Sent s;
    s.met = metAt(walk.hit, shell);
    bool bare = false;
    if (on && s.met.t >= 0.0) alpha = opacityOf(s.met, shell, level, pixel, stored, bare) * turned;
    s.above = stored.zw, s.fine = max(level - 1.0, 0.0);
    meet(walk, s, alpha, s.met.t);
    if (alpha > 0.004) walk.last = s.met.t;
    if (!on) return;
    walk.ray = sliceAfter(walk.ray, walk.hit);
    walk.hit = waveHit(walk.ray);
    if (!(s.met.t >= 0.0)) return;
    if (bare && walk.bare > 0)
        --walk.bare;
    else
        --walk.left;
}

Sum traced(Shell shell, SliceRay ray, uint grain) {
    // A ray's way through the shell is short: where it comes in says how fine all that it meets is.
    float pixel = pixelAt(max(length(shell.start), slices.cellSize));
    float even = sliceLevel(levelAt(pixel, 0.7) - 1.0, lookHeight(-shell.seen));
    shell.gain *= even, shell.ambient *= even;
    vec2 levels = vec2(levelAt(pixel, abs(shell.seen.x)), levelAt(pixel, abs(shell.seen.z)));
    levels = floor(levels + hashUnit(grain));  // one of two: twice the look-ups would blend them
    Walk walk;
    walk.ray = fromBefore(ray), walk.hit = waveHit(walk.ray);
    walk.left = stepsAt(pixel), walk.bare = walk.left;
    walk.through = 1.0, walk.depth = -1.0, walk.last = 0.0;
    walk.most.share = 0.0, walk.next.share = 0.0;
    // Two steps a round, and the test at the end: rasterisers in software keep what a round hands on in memory, and
    // run what stands behind a test once more for nothing.
    do {
        step(walk, shell, levels, pixel);
        step(walk, shell, levels, pixel);
    } while (goesOn(walk));
    meetRest(walk, shell, pixel, grain);
    Sum sum;
    sum.through = walk.through, sum.depth = walk.depth < 0.0 ? walk.last : walk.depth;
    vec3 light = sentLight(walk.most, shell, pixel) + sentLight(walk.next, shell, pixel);
    sum.light = light * ((1.0 - walk.through) / max(walk.most.share + walk.next.share, 1e-6));
    return sum;
}

// A random number fixed to a place: its grains are about a pixel. A ray's place is where it comes in, from where on all
// of them differ: from an eye within the shell, after a cell. c, up: in cells; distance: metres from the eye.
uint grainAt(vec2 c, float up, float distance) {
    int size = textureSize(sliceThreshold, 0).x;
    float pixel = distance / (pixelsPerMetre * slices.cellSize);
    int level = int(clamp(log2(max(pixel * float(size), 1e-6)), 0.0, 16.0)), grains = max(size >> level, 1);
    vec2 whole = floor(c);
    ivec2 at = (ivec2(slices.eyeCell) + ivec2(whole)) * grains + ivec2((c - whole) * float(grains));
    return hash3(uint(at.x), uint(at.y), 78u + uint(level) + 32u * uint(int(floor(up * float(grains)))));
}

// Colour and alpha of what a ray saw; alpha 0: nothing of the pixel.
vec4 shownOf(Sum sum, Shell shell, uint grain) {
    float opacity = 1.0 - sum.through, alpha = coveredAlpha(TRANSPARENCY, opacity, grain);
    vec3 light = sum.light / max(opacity, 1e-4);
    float hazed = hazeShare(length(shell.start));
    if (viewMode() == VIEW_TIERS) return vec4(0.5, 0.1, 0.8, alpha);
    if (viewMode() == VIEW_NORMALS) return vec4(0.5, 0.5, 1.0, alpha);
    if (viewMode() == VIEW_OVERDRAW) return vec4(1.0 / 32.0, 0.0, 0.0, alpha);
    if (viewMode() == VIEW_DENSITY) return vec4(0.1, 0.65, 0.15, alpha);
    return vec4(light * (1.0 - hazed) + hazeColor(shell.start) * hazed, alpha);
}
// Metres that what a ray saw moved since the frame before, in the field's axes, where grass leant as `before`.
vec3 movedSince(Sum sum, Shell shell, SliceRay ray, BladeLean now, BladeLean before) {
    float up = sqrt(1.0 - min(dot(now.lean, now.lean), 0.9)),
          upBefore = sqrt(1.0 - min(dot(before.lean, before.lean), 0.9));
    float above = clamp(shell.height + heightAt(ray, shell, sum.depth), 0.0, shell.height), along = above / up;
    vec2 level = (now.lean - before.lean) * along;
    return vec3(level.x, (up - upBefore) * along, level.y);
}
// Depth of the pixel; carrier: the carrier's.
float depthOf(Sum sum, Shell shell, float carrier) {
    return hitDepth(frame.viewProj * vec4(shell.start + shell.way * sum.depth, 1.0), carrier, kNear);
}
