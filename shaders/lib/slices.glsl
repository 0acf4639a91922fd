// What vertical and horizontal slices share: their images, light from tabulated directions, gains by view.
// Needs: const bool GRASS_DENSITY, GRASS_VEGETATION, GRASS_TRACED, FORCES, FORCE_MAP, TRANSLUCENCY, CONSERVING,
// LIGHT_COSINE, TERRAIN_HEIGHTS, SUN.
#include "lib/field.glsl"
#include "lib/density.glsl"
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/lamps.glsl"
#include "numerics/leaf.h"
#include "numerics/opacity.h"
#include "numerics/slope.h"
#include "numerics/sowing.h"
#include "numerics/traced.h"
#include "numerics/weights.h"
#include "shared/bindings.h"
#include "shared/slices.h"

layout(std140, binding = UBO_SLICES) uniform SliceBlock { SliceGlobals slices; };
layout(binding = TEX_SLICE_REFLECTANCE) uniform sampler2DArray sliceReflectance;
layout(binding = TEX_SLICE_THRESHOLD) uniform sampler2DArray sliceThreshold;
layout(binding = TEX_SLICE_LIGHT) uniform sampler2DArray sliceLight;
layout(binding = TEX_LAMP_GAINS) uniform sampler3D lampGains;
const int FULL_STORAGE = 2;

// The four tabulated views around one towards the eye, and their weights.
struct LookTap {
    ivec4 view;
    vec4 weight;
};
// Azimuth from x towards z in eighths of a turn, [0, 8): exact at whole ones, within 0.005 between; 0 of no direction.
float eighths(vec2 d) {
    vec2 size = abs(d);
    float t = min(size.x, size.y) / max(max(size.x, size.y), 1e-6), turn = t * (1.3476 - 0.3476 * t);
    if (size.y > size.x) turn = 2.0 - turn;
    if (d.x < 0.0) turn = 4.0 - turn;
    return d.y < 0.0 && turn > 0.0 ? 8.0 - turn : turn;
}
LookTap lookTap(vec3 toEye) {
    float turn = eighths(toEye.xz) * float(LOOK_AZIMUTHS / 8);
    float high = lookHeight(toEye) * float(LOOK_ELEVATIONS - 1);
    int a = min(int(turn), LOOK_AZIMUTHS - 1), b = (a + 1) % LOOK_AZIMUTHS, low = min(int(high), LOOK_ELEVATIONS - 2);
    float fa = turn - float(a), fh = high - float(low);
    LookTap t;
    t.view = ivec4(a, b, a, b) + LOOK_AZIMUTHS * ivec4(low, low, low + 1, low + 1);
    t.weight = vec4((1.0 - fa) * (1.0 - fh), fa * (1.0 - fh), (1.0 - fa) * fh, fa * fh);
    return t;
}

// The mean of what four views have: of factors as LookGain packs them, and of shares that may be below 0.
vec3 mixGains(LookTap t, uvec4 bits, float scale) {
    vec4 w = t.weight * (scale / 1023.0);
    return vec3(dot(w, vec4(bits & 1023u)), dot(w, vec4(bits >> 10 & 1023u)), dot(w, vec4(bits >> 20)));
}
vec3 mixShares(LookTap t, uvec4 bits) { return 2.0 * mixGains(t, bits, slices.leanScale) - slices.leanScale; }

// How many times as bright grass is where it is laid down so far.
vec3 laidGain(LookTap t, float press) {
    if (!FORCES && !FORCE_MAP) return vec3(1.0);
    uvec4 bits = uvec4(slices.gains[t.view.x].laid, slices.gains[t.view.y].laid, slices.gains[t.view.z].laid,
                       slices.gains[t.view.w].laid);
    return mix(vec3(1.0), mixGains(t, bits, slices.gainScale.z), press);
}
// How many times as bright grass is where its blades lean so far, m per m. all: with the lean of clumps, of which each
// place has its own: the square of that is in the means that gains were made of.
vec3 leanGain(LookTap t, vec2 all, vec2 lean) {
    if (all == vec2(0.0)) return vec3(1.0);
    LookGain a = slices.gains[t.view.x], b = slices.gains[t.view.y], c = slices.gains[t.view.z],
             d = slices.gains[t.view.w];
    vec3 sum = all.x * mixShares(t, uvec4(a.leanX, b.leanX, c.leanX, d.leanX)) +
               all.y * mixShares(t, uvec4(a.leanZ, b.leanZ, c.leanZ, d.leanZ)) +
               lean.x * lean.x * mixShares(t, uvec4(a.leanXX, b.leanXX, c.leanXX, d.leanXX)) +
               lean.y * lean.y * mixShares(t, uvec4(a.leanZZ, b.leanZZ, c.leanZZ, d.leanZZ)) +
               lean.x * lean.y * mixShares(t, uvec4(a.leanXZ, b.leanXZ, c.leanXZ, d.leanXZ));
    return max(1.0 + sum, vec3(0.1));
}
// Factor that gives slices, in the sun's and the sky's light, the mean radiance of the blades they stand for; `lean`:
// by paint and wind, m per m; `clump`: by clumps where those are told apart; `press`: how far they are laid down.
vec3 sliceGain(vec3 toEye, vec2 lean, vec2 clump, float press, bool far) {
    LookTap t = lookTap(toEye);
    LookGain a = slices.gains[t.view.x], b = slices.gains[t.view.y], c = slices.gains[t.view.z],
             d = slices.gains[t.view.w];
    vec3 gain = far ? mixGains(t, uvec4(a.above, b.above, c.above, d.above), slices.gainScale.y)
                    : mixGains(t, uvec4(a.across, b.across, c.across, d.across), slices.gainScale.x);
    return gain * leanGain(t, lean + clump, lean) * laidGain(t, press);
}
// sliceGain of the horizontal slice where the field's density is so: between what it is at full density and at the thin
// one by its logarithm.
vec3 farGain(vec3 toEye, vec2 lean, vec2 clump, float press, float density) {
    vec3 full = sliceGain(toEye, lean, clump, press, true);
    if (!GRASS_DENSITY || density >= 1.0) return full;
    LookTap t = lookTap(toEye);
    LookGain a = slices.gains[t.view.x], b = slices.gains[t.view.y], c = slices.gains[t.view.z],
             d = slices.gains[t.view.w];
    uvec4 dense = uvec4(a.above, b.above, c.above, d.above), sparse = uvec4(a.thin, b.thin, c.thin, d.thin);
    vec3 thin =
        full * mixGains(t, sparse, slices.gainScale.w) / max(mixGains(t, dense, slices.gainScale.y), vec3(1e-4));
    return mix(thin, full, clamp(1.0 + log2(max(density, 1e-3)) / log2(float(THIN_DENSITY)), 0.0, 1.0));
}
// Factor that makes each level of detail of images as bright as the finest: coarse ones mix what faces light and what
// does not. level: of what is lit; pixel: how long it is, in cells.
float evenLevel(vec4 factors[2], float level) {
    float at = clamp(level, 0.0, 7.0);
    int fine = int(at), coarse = min(fine + 1, 7);
    return mix(factors[fine / 4][fine % 4], factors[coarse / 4][coarse % 4], at - float(fine));
}
// Factor that makes each level of vertical slices as bright. level: of what is lit; high: lookHeight of the view.
float sliceLevel(float level, float high) {
    float of = clamp(level, 0.0, float(SLICE_LEVELS - 1)), row = high * float(LOOK_ELEVATIONS - 1);
    int fine = int(of), coarse = min(fine + 1, SLICE_LEVELS - 1), low = min(int(row), LOOK_ELEVATIONS - 2);
    vec2 f = vec2(of - float(fine), row - float(low));
    ivec4 at = SLICE_LEVELS * ivec4(low, low, low + 1, low + 1) + ivec4(fine, coarse, fine, coarse);
    vec4 factors = vec4(slices.sliceLevels[at.x / 4][at.x % 4], slices.sliceLevels[at.y / 4][at.y % 4],
                        slices.sliceLevels[at.z / 4][at.z % 4], slices.sliceLevels[at.w / 4][at.w % 4]);
    return mix(mix(factors.x, factors.y, f.x), mix(factors.z, factors.w, f.x), f.y);
}
float farLevel(float pixel) { return evenLevel(slices.farLevels, log2(max(pixel * slices.farTexels, 1e-6))); }
// Factor of vertical slices that stand for this share of the blades; the others are drawn one by one.
float sharedGain(vec3 toEye, float share) {
    if (share >= 1.0) return 1.0;
    float thin = evenLevel(slices.thinner, lookHeight(toEye) * float(LOOK_ELEVATIONS - 1));
    return mix(1.0, thin, clamp(-log2(max(share, 1e-3)) / log2(float(THIN_DENSITY)), 0.0, 1.0));
}
// By how much more light slices send where one looks along it: gains hold for views a sixteenth of a turn apart. share:
// as `hotSpot` of SliceGlobals.
vec3 hotSpot(vec3 share, vec3 toEye, vec3 towards) {
    return GRASS_TRACED ? 1.0 + share * tracedGlow(toEye, towards) : vec3(1.0);
}
// The sun's; grass that is pressed down hides no shadows.
vec3 sunsHotSpot(vec3 toEye, float press) { return hotSpot(slices.hotSpot * (1.0 - press), toEye, frame.sunDirection); }
// Where the gains of light from one direction are kept. Towards the eye and the light, unit, in the field's axes.
vec3 directedPlace(vec3 toEye, vec3 towards) {
    vec2 level = vec2(length(toEye.xz), length(towards.xz));
    float cosine = dot(toEye.xz, towards.xz) / max(level.x * level.y, 1e-6);
    vec3 size = vec3(LAMP_AZIMUTHS, LAMP_ELEVATIONS, LAMP_ELEVATIONS),
         at = vec3(0.5 - 0.5 * clamp(cosine, -1.0, 1.0), lookHeight(toEye), lookHeight(towards));
    return (at * (size - 1.0) + 0.5) / size;
}
// How many times as bright such light is where one looks along it.
float directedSpot(vec3 toEye, vec3 towards) {
    float share = max(dot(slices.lampHotSpot, tracedRise(towards.y)), 0.0);
    return hotSpot(vec3(share), toEye, towards).x;
}
// sliceGain of a lamp's light, without what forces do: of vertical slices, and of the horizontal one.
vec2 lampGain(vec3 toEye, vec3 towards) {
    return textureLod(lampGains, directedPlace(toEye, towards), 0.0).rg * directedSpot(toEye, towards);
}

// The direction towards the eye over ground of this slope: a hillside that faces the eye shows its grass as from above.
vec3 seenOver(vec3 toEye, vec2 slope) {
    if (!TERRAIN_HEIGHTS) return toEye;
    vec3 over = overLevel(toEye, slope);
    return normalize(vec3(over.x, max(over.y, 0.0), over.z));
}
// How many times as bright the sun is on grass for the slope of its ground.
float sunOverSlope(vec3 toEye, vec2 slope, float density) {
    if (!TERRAIN_HEIGHTS || !SUN) return 1.0;
    return slopeBrightens(slices.area * density, toEye, frame.sunDirection, slope);
}

// The chance of a cell (numerics/sowing.h), and the opacity of what a slice stores there (texelOpacity).
float chanceOf(ivec2 cell) { return slices.step > 0.0 ? cellChance(cell.x, cell.y, slices.sowSeed) : 0.5; }
float storedOpacity(vec4 stored, float density, float level, float chance) {
    Sown s = Sown(slices.spread, slices.step, slices.sownShare);
    return texelOpacity(stored.x, stored.y, density, slices.fade, level, s, chance);
}

// Share of its height that a slice keeps where it is pressed: it has no blades to lay down each its own way, so it
// sinks.
const float kSinks = 0.9;
float sunk(float press) { return 1.0 - kSinks * press; }
// How much of the grass lies under a force (lib/force.glsl), in [0, 1]: what slices lack of their height, pressed down
// and pushed over.
float laidBy(vec3 f) { return min((1.0 - sunk(f.z) * sqrt(1.0 - min(dot(f.xy, f.xy), 0.9))) / kSinks, 1.0); }

// Share of vertical slices that is drawn for a view of this sine: from steeply above one would look between them.
float verticalShare(float sine) {
    if (!CONSERVING) return 1.0;
    float y = clamp(sine, 1e-3, 1.0);
    return min(slices.steepest * sqrt(1.0 - y * y) / y, 1.0);
}

// Filtered density of the species at a point of the terrain; uv: of mapPlace.
float fieldDensity(vec2 uv) {
    if (!GRASS_DENSITY) return 1.0;
    return texture(densityMap, tiled(uv, field.species[slices.species].tiling)).r;
}

// Level of detail of a map that is read at `uv * tiling`, for a pixel that is `metres` wide.
float mapLevel(ivec2 size, float tiling, float metres) {
    vec2 texels = vec2(size) * frame.mapShare * (max(tiling, 1.0) * metres);
    return max(log2(max(max(texels.x, texels.y), 1e-6)), 0.0);
}
// The same for a pixel so wide, where neighbouring pixels look at other places altogether.
float fieldDensityOver(vec2 uv, float metres) {
    if (!GRASS_DENSITY) return 1.0;
    float tiling = field.species[slices.species].tiling;
    return textureLod(densityMap, tiled(uv, tiling), mapLevel(textureSize(densityMap, 0), tiling, metres)).r;
}

// Reflectance (as a share of full scale) under paint, seen along toEye, by vertical slices or the horizontal one: as
// bright as blades are that are painted so. paint: its colour, and its opacity in the mean of what is looked at;
// within: its opacity where there is any.
vec3 underPaint(vec3 reflectance, vec4 paint, float within, vec3 toEye, bool far) {
    if (!(paint.a > 0.0)) return reflectance;
    LookTap t = lookTap(toEye);
    LookGain a = slices.gains[t.view.x], b = slices.gains[t.view.y], c = slices.gains[t.view.z],
             d = slices.gains[t.view.w];
    uvec4 bits = far ? uvec4(a.paintAbove, b.paintAbove, c.paintAbove, d.paintAbove)
                     : uvec4(a.paintAcross, b.paintAcross, c.paintAcross, d.paintAcross);
    vec3 shine = mixGains(t, uvec4(a.shine, b.shine, c.shine, d.shine), SHINE_SCALE),
         level = mixGains(t, bits, PAINT_SCALE), own = reflectance * slices.reflectScale;
    float through = slices.translucency, again = slices.recollision;
    vec3 painted = ((1.0 - within) * own * leafOnce(own, through, again) +
                    within * level * paint.rgb * leafOnce(vec3(TRACED_GREY), through, again)) /
                       leafOnce(mix(own, paint.rgb, within), through, again) +
                   within * level * shine;
    return mix(reflectance, painted / slices.reflectScale, min(paint.a / max(within, 1e-4), 1.0));
}
vec3 paintedOver(vec3 reflectance, vec2 uv, vec3 toEye) {
    if (!GRASS_VEGETATION) return reflectance;
    vec4 paint = texture(vegetationMap, uv * field.vegetationTiling);
    return underPaint(reflectance, paint, paint.a, toEye, false);
}
vec3 paintedOver(vec3 reflectance, vec2 uv, float metres, vec3 toEye) {
    if (!GRASS_VEGETATION) return reflectance;
    float level = mapLevel(textureSize(vegetationMap, 0), field.vegetationTiling, metres);
    vec4 paint = textureLod(vegetationMap, uv * field.vegetationTiling, level);
    return underPaint(reflectance, paint, paint.a, toEye, false);
}

// Light from one direction on a texel and on its other side, from what it stores: `plus` and `minus` are the parts of
// normals along each axis and against it, `towards` the light. One blade has one of the two on each axis, and their
// difference is exact. Where filtering mixed blades that face both ways, each way has light: the hyperbola of the mean
// and that spread, which is exact where the mean is 0 or nothing is mixed.
vec2 cosineOf(vec3 plus, vec3 minus, vec3 towards) {
    float facing = dot(plus - minus, towards), spread = 2.0 * dot(min(plus, minus), abs(towards));
    float both = sqrt(facing * facing + spread * spread);
    return 0.5 * vec2(both + facing, both - facing);
}

// What leaves send of light on this side (x) and through them from the other (y).
vec3 leavesSend(vec3 reflectance, vec2 light) {
    vec3 sent = reflectance * light.x;
    if (TRANSLUCENCY) sent += leafThrough(reflectance) * (slices.translucency * light.y);
    return sent;
}

// Five weights (x+, y, z+, x-; z- is what is left) of a lamp here, faded at the horizon (B-4).
vec4 lampWeights(vec3 direction) {
    LightWeights w = lightWeightsFast(direction);
    return vec4(w.xPos, w.yPos, w.zPos, w.xNeg);
}
float lampFade(vec3 direction) { return horizonFade(direction.y, 0.052); }

// Five weights as weights of a vertical slice's images: facing, side +, side -, above. axes: side that is seen, mirror
// x, z, and 0 for slices across x, 1 across z.
vec4 imagesOf(vec4 w, vec4 axes) {
    float zNeg = 1.0 - (w.x + w.y + w.z + w.w);
    vec2 x = axes.y > 0.0 ? vec2(w.x, w.w) : vec2(w.w, w.x), z = axes.z > 0.0 ? vec2(w.z, zNeg) : vec2(zNeg, w.z);
    vec2 along = axes.w < 0.5 ? x : z, across = axes.w < 0.5 ? z : x;
    return vec4(axes.x > 0.0 ? along.x : along.y, across, w.y);
}
// The sun as a slice sees it, in the patch's own axes. sun: towards it, and its five weights (x+, y, z+, x-), in the
// field's axes; axis: 0 for slices across x, 1 across z; side of it that is seen; mirror of its cell.
struct SunSeen {
    vec3 towards;
    vec4 weights;
};
vec4 sunImages(SunSeen sun, int axis, float side, vec2 mirror) {
    if (!LIGHT_COSINE) return imagesOf(sun.weights, vec4(side, mirror, float(axis)));
    vec3 l = sun.towards * vec3(mirror.x, 1.0, mirror.y);
    return axis == 0 ? vec4(l.x * side, l.z, l.y, 0.0) : vec4(l.z * side, l.x, l.y, 0.0);
}

// Over level ground a field's axes are the world's.
const mat3 kLevel = mat3(1.0);
const vec3 kOnGround = vec3(0.0);
SunSeen levelSun() { return SunSeen(frame.sunDirection, slices.sunWeights); }

// Light of all lamps on the images of a vertical slice at a point, with their gains. toField: from the world's axes to
// the field's; raise: unit normal of the object on which the grass stands, 0 on the ground.
void lampsOnImages(vec3 at, vec4 axes, mat3 toField, vec3 raise, inout vec4 sum[3]) {
    vec3 toEye = toField * (-at / max(length(at), 1e-4));
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampReaching(i, at, raise);
        vec3 direction = toField * l.direction;
        vec4 w = imagesOf(lampWeights(direction), axes) * (lampFade(direction) * lampGain(toEye, direction).x);
        for (int c = 0; c < 3; ++c) sum[c] += l.light[c] * w;
    }
}
