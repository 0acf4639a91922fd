// One corner of one vertical slice of one cell. Quads follow the ground (their ends lie on cells' edges, so that
// neighbours share them), lean with the paint and with clumps, and are lit per vertex. Boulanger, Pattanaik and
// Bouatouch 2006, sections 3.1 and 3.3.
#include "lib/field.glsl"
#include "lib/density.glsl"
#include "lib/force.glsl"
#include "lib/frame.glsl"
#include "lib/ground_around.glsl"
#include "lib/heights.glsl"
#include "lib/light.glsl"
#include "lib/mirror.glsl"
#include "lib/shadow.glsl"
#include "lib/slices.glsl"
#include "lib/wind.glsl"
#include "numerics/clump.h"
#include "numerics/hash.h"
#include "numerics/lod.h"
#include "numerics/stand.h"

layout(location = 0) in ivec2 cell;
layout(location = 1) in vec2 cellCorner;  // relative to the eye
layout(location = 2) in vec2 mirror;      // of the cell's version of the patch (numerics/population.h)
layout(location = 3) in vec2 shift;

centroid out vec3 texel;  // across (it repeats), up, layer; where the samples lie that are covered: far away a slice is
                          // lower than a pixel, whose middle is often over it
out vec2 unmoved;         // texel's across and up in the pixel's middle: its derivatives tell how wide a pixel is
out vec3 foot;            // the ground below, relative to the eye
flat out vec4 images;     // sun: weights of the view's images: facing, side +, side -, above (behind is what is left);
                          // with LIGHT_COSINE its direction: facing, side, above
flat out vec4 axes;       // w: 0 slices across x, 1 across z; x: side of it that is seen, in the patch; y, z: mirror
flat out float lightLayer;
flat out float chance;  // of the cell
out vec3 gain;          // of light from the sun
out vec3 brighter;      // of lamps' light
out vec4 lamp[3];       // red, green, blue: lamps' light on the view's images; unless weights are taken per pixel
out vec3 ambient;
out vec4 haze;     // its colour times the share that it has; w: what is left to the slice
out vec3 moved;    // metres since the frame before
out vec2 weights;  // by distance, of what slices draw; by distance and view, of that what this family shows
out float high;    // lookHeight of the view

// What the place has for the blades that slices stand for; press: how far a force lays them down.
BladeStand standHere(vec2 inCell, vec2 uv, out float press) {
    BladeStand s = emptyStand();
    s.paint = paintedLean(uv);
    s.leanAtFull = slices.leanAtFull;
    s.breeze = windLeanAt(foot.xz, -1.0, field.species[slices.species].gusts);
    if (GRASS_CLUMPS && slices.clumpSize > 0.0)
        s.clump = clumpValues(cell.x, cell.y, inCell, slices.cellSize, slices.clumpSize, slices.seed);
    s.clumpLean = slices.clumpLean;
    s.clumpHeight = slices.clumpHeight;
    s.clumpLightness = slices.clumpLightness;
    press = 0.0;
    if (FORCES || FORCE_MAP) {  // the horizontal slice covers what it leaves
        vec3 force = forceHere(foot.xz, uv);
        s.push = force.xy;
        press = force.z;
    }
    s.tall = bladeShare(uv);
    return s;
}

// From a slice's foot up to its top, or to its own foot.
vec3 riseOf(BladeLean p, float press, float top) {
    float lean2 = min(dot(p.lean, p.lean), 0.9);
    return top * slices.top * (p.scale * sunk(press)) * vec3(p.lean.x, sqrt(1.0 - lean2), p.lean.y);
}

// In slices, within ]-0.15, 0.15[: moves each end of a slice by a number of the cells' edge that it lies on, which the
// neighbour shares. Without it the slices' straight tops, all at one distance, show as a weave.
float jitter(int axis, int k, int end) {
    ivec2 edge = axis == 0 ? cell + ivec2(0, end) : cell + ivec2(end, 0);
    return 0.3 * (hashUnit(hash3(uint(edge.x), uint(edge.y), uint(axis * 64 + k))) - 0.5);
}

void main() {
    int n = slices.slices, quad = gl_VertexID / 4, corner = gl_VertexID % 4;
    int axis = quad / n, k = quad % n;
    float end = float(corner & 1), top = float(corner >> 1), at = (float(k) + 0.5) / float(n);
    if (CONSERVING) at += jitter(axis, k, corner & 1) / float(n);
    vec2 local = axis == 0 ? vec2(at, end) : vec2(end, at);
    vec2 inCell = local * slices.cellSize;
    vec2 ground = vec2(cell) * slices.cellSize + inCell, uv = mapPlace(ground);
    foot = vec3(cellCorner.x + inCell.x, groundHeight(ground), cellCorner.y + inCell.y);
    float press;
    BladeStand stands = standHere(inCell, uv, press);
    BladeLean p = leanOf(stands, vec2(0.0));
    vec3 rise = riseOf(p, press, top), position = foot + rise;
    moved = vec3(0.0);
    if (TEMPORAL) {
        stands.breeze = windLeanBefore(foot.xz, -1.0, field.species[slices.species].gusts);
        moved = rise - riseOf(leanOf(stands, vec2(0.0)), press, top);
    }

    vec2 signs = axis == 0 ? mirror : mirror.yx,
         begin = axis == 0 ? shift : shift.yx;  // along the normal, along the slice
    float side = (axis == 0 ? -foot.x : -foot.z) * signs.x;
    int layer = ((signs.x > 0.0 ? k : n - 1 - k) + n - int(begin.x * float(n) + 0.5)) % n;
    texel = vec3((signs.y > 0.0 ? 1.0 + end : 2.0 - end) - begin.y, top, float(axis * (slices.layers - n) + layer));
    unmoved = texel.xy;
    lightLayer = float(side > 0.0 ? 0 : slices.layers);
    chance = chanceOf(cell);
    float level = max(length(foot.xz), 1e-4);
    float far = max(length(foot), 1e-4);
    float turned = CONSERVING ? verticalShare(-foot.y / far) * abs(axis == 0 ? foot.x : foot.z) / level : 1.0;
    weights =
        vec2(lodRamp(far, slices.minGeom, slices.geomInv), (1.0 - lodRamp(far, slices.minBTF, slices.btfInv)) * turned);

    float plain = p.lighter * darkened(far) * slices.reflectScale;
    vec2 slope = groundSlope(ground, foot.y, slices.cellSize);
    vec3 toEye = -foot / far, over = seenOver(toEye, slope),
         shown = plain * sharedGain(over, weights.x) * sliceGain(over, p.free - p.clump, p.clump, press, false);
    brighter = plain * laidGain(lookTap(toEye), press);
    high = lookHeight(over);
    axes = vec4(side > 0.0 ? 1.0 : -1.0, mirror, float(axis));
    images = sunImages(levelSun(), axis, axes.x, mirror);
    gain = SUN ? shown * sunsHotSpot(toEye, press) * sunOverSlope(toEye, slope, 1.0) * frame.sunLight * frame.sunIsUp
               : vec3(0.0);
    ambient = shown * slices.ambient * (skyShare(uv) * skyOnGrassPastTrees(foot)) * groundAround(foot);
    float hazed = hazeShare(length(position));
    haze = vec4(hazeColor(foot) * hazed, 1.0 - hazed);
    for (int c = 0; c < 3; ++c) lamp[c] = vec4(0.0);
    if (LAMPS && !WEIGHTS_PER_PIXEL) lampsOnImages(position, axes, kLevel, kOnGround, lamp);
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
    if (CONSERVING && turned < 0.004) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
