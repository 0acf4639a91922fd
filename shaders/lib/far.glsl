// The horizontal slice over the ground: the patch repeated by integer cell, each in its version (Boulanger, Pattanaik
// and Bouatouch 2006, section 4.1, eq 7; B-16 to B-18). Fragment shaders only. Needs: const bool GRASS_HEIGHTS,
// CONSERVING.
#include "lib/density.glsl"
#include "lib/frame.glsl"
#include "lib/slices.glsl"
#include "numerics/correction.h"
#include "numerics/population.h"

struct Repeated {
    vec3 texel;
    vec2 dx, dy;  // gradients of the coordinate before it was wrapped, as fine as is wanted
    ivec2 cell;
    vec2 inCell;  // metres
    vec2 mirror;
};
// c: x, z in cells from slices.eyeCell; dx, dy: by how much a pixel to the right and one up are farther.
Repeated repeatedAt(vec2 c, vec2 dx, vec2 dy) {
    vec2 whole = floor(c);
    Repeated r;
    r.cell = ivec2(slices.eyeCell) + ivec2(whole);
    CellVersion v = cellVersion(r.cell.x, r.cell.y, slices.seed);
    r.mirror = v.mirror;
    vec2 local = c - whole;
    r.inCell = local * slices.cellSize;
    r.texel = vec3(placeInPatch(local, v.mirror, v.shift) + 1.0, 0.0);
    r.dx = dx * r.mirror * slices.sharpness;
    r.dy = dy * r.mirror * slices.sharpness;
    return r;
}
// at: x, z relative to the eye.
Repeated repeated(vec2 at) {
    vec2 c = at / slices.cellSize + slices.inCell;
    return repeatedAt(c, dFdx(c), dFdy(c));
}

// Share of their height that blades have, filtered for the pixel.
float bladeShareSeen(vec2 uv) {
    if (!GRASS_HEIGHTS) return 1.0;
    return texture(bladeHeightMap, tiled(uv, field.heightTiling)).r;
}

// How many times the slice's own optical depth lies on a ray of this sine: all blades' less what vertical slices cover.
// Blades that are pressed show their faces to the sky instead of to the side: their area towards the zenith grows to
// nearly all that they have, while that towards a level view, of which vertical slices cover what they have not sunk,
// goes.
float depthFactor(float sine, float vertical, float laid) {
    if (!CONSERVING) return 1.0;
    float y = clamp(sine, 0.03, 1.0), slant = sqrt(1.0 - y * y) / y;
    vec2 area = mix(slices.area, slices.laidArea, laid) * vec2(slant, 1.0);
    return max((length(area) - vertical * sunk(laid) * slices.area.x * slant) / max(slices.farDepth, 1e-4), 0.0);
}

// Opacity of the slice there, seen along a ray of this sine; pixels wider than a texel are filtered. tall: share of
// their height that blades have: a ray crosses so much less of them. vertical: share of the vertical slices that are
// drawn. laid: how much of the grass lies (laidBy): as far about as it was high. stored: the texel's thresholds and
// light from above.
float farOpacity(sampler2DArray thresholds, Repeated r, float density, float tall, float sine, float vertical,
                 float laid, out vec4 stored) {
    // The mean over what the ray crosses of the grass, or over the pixel if that is wider: only means can be corrected
    // for the slant. Colour and light are taken as sharp as is wanted.
    float y = clamp(sine, 0.03, 1.0), crossed = CONSERVING ? slices.meanHeight * max(sqrt(1.0 - y * y) / y, laid) : 0.0;
    float pixel = max(length(r.dx), length(r.dy)) / slices.sharpness, wide = max(pixel, crossed);
    float level = clamp(log2(wide * slices.farTexels), 0.0, 16.0);
    stored = textureLod(thresholds, r.texel, level);
    return correctionPow(storedOpacity(stored, density, level, chanceOf(r.cell)),
                         depthFactor(sine, vertical, laid) * tall);
}
