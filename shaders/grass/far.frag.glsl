// A texel of the horizontal slice: the patch repeated by integer cell, mirrored by each cell's hash (section 4.1, eq 7;
// B-16 to B-18), as opaque as the grass is along this slanted ray, less what vertical slices cover (see grass/slices.h).
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/hash.h"
#include "numerics/bilinear.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/correction.h"
#include "numerics/clump.h"
#include "lib/light.glsl"
#include "lib/shadow.glsl"
#include "lib/cover.glsl"
#include "lib/slices.glsl"

in vec3 position;
in vec2 place;
out vec4 color;

struct Repeated {
    vec3 texel;
    vec2 dx, dy;    // gradients of the coordinate before it was wrapped, as fine as is wanted
    ivec2 cell;
    vec2 inCell;    // metres
    vec2 mirror;
};
Repeated repeated() {
    vec2 c = position.xz / slices.shape.x + slices.eyeCell.zw;
    vec2 whole = floor(c);
    Repeated r;
    r.cell = ivec2(slices.eyeCell.xy) + ivec2(whole);
    r.mirror = cellMirror(cellHash(r.cell.x, r.cell.y, uint(slices.counts.y)));
    vec2 local = c - whole;
    r.inCell = local * slices.shape.x;
    r.texel = vec3(mix(1.0 - local, local, step(0.0, r.mirror)), 0.0);
    r.dx = dFdx(c) * r.mirror * slices.lean.w;
    r.dy = dFdy(c) * r.mirror * slices.lean.w;
    return r;
}

vec3 radiance(Repeated r, vec3 reflectance, vec2 above, vec2 uv) {
    vec3 ambient = slices.farAmbient.rgb * skyShare(uv) * reflectance;
    if (!SUN) return ambient;
    vec3 sun = frame.sunLight.rgb * frame.sunDirection.w * sunVisible(position, vec3(0.0));
    vec4 w = slices.sunWeights;
    float zNeg = 1.0 - (w.x + w.y + w.z + w.w);
    vec4 images = vec4(r.mirror.x > 0.0 ? w.xw : w.wx, r.mirror.y > 0.0 ? vec2(w.z, zNeg) : vec2(zNeg, w.z));
    if (STORAGE == FULL_STORAGE) {
        vec3 sum = vec3(0.0);
        for (int i = 0; i < 5; ++i) sum += (i < 4 ? images[i] : w.y) * textureGrad(sliceLight, vec3(r.texel.xy, float(i)), r.dx, r.dy).rgb;
        return ambient + sun * sum;
    }
    vec4 lit = textureGrad(sliceLight, r.texel, r.dx, r.dy);
    if (!LIGHT_COSINE) return ambient + sun * reflectance * (dot(lit, images) + above.x * w.y);
    vec3 towards = frame.sunDirection.xyz * vec3(r.mirror.x, 1.0, r.mirror.y);
    float level = log2(max(length(r.dx), length(r.dy)) * slices.counts.z);
    return ambient + sun * reflectance * cosineOf(vec3(lit.x, above.x, lit.z), vec3(lit.y, above.y, lit.w), towards, max(level, 0.0));
}

// How many times the slice's own optical depth lies on a ray of this sine: all blades' less what vertical slices cover.
float depthFactor(float sine, float vertical) {
    if (!CONSERVING) return 1.0;
    float y = clamp(sine, 0.03, 1.0), across = slices.areas.x * sqrt(1.0 - y * y) / y, above = max(slices.areas.y, 1e-6);
    return max((sqrt(across * across + above * above) - vertical * across) / above, 0.0);
}

float lighterHere(Repeated r, float pixel) {
    if (!GRASS_CLUMPS || slices.clumps.w <= 0.0 || pixel > slices.clumps.w) return 1.0;
    vec3 c = clumpValues(r.cell.x, r.cell.y, r.inCell, slices.shape.x, slices.clumps.w, uint(slices.counts.y));
    return 1.0 + c.z * slices.clumps.z * (1.0 - pixel / slices.clumps.w);
}

void main() {
    Repeated r = repeated();
    vec2 uv = place * frame.terrain.zw;
    float d = length(position);
    vec3 toEye = -position / max(d, 1e-4);
    float footprint = max(length(r.dx), length(r.dy)), pixel = footprint / slices.lean.w;   // in cells
    // Opacity over the whole pixel, since it is corrected for the slant; colour and light as sharp as is wanted.
    vec4 stored = textureGrad(sliceThreshold, r.texel, r.dx / slices.lean.w, r.dy / slices.lean.w);
    float far = lodRamp(d, slices.tiers.x, slices.tiers.y);
    float alpha = texelOpacity(stored.xy, sliceDensity(fieldDensity(uv), far), max(log2(pixel * slices.counts.z), 0.0));
    float vertical = GRASS_SLICES ? 1.0 - lodRamp(d, slices.tiers.z, slices.tiers.w) : 0.0;
    alpha = correctionPow(alpha, depthFactor(toEye.y, vertical));
    if (!(alpha > 0.002)) discard;
    vec3 reflectance = paintedOver(textureGrad(sliceReflectance, r.texel, r.dx, r.dy).rgb, uv, 0.85 / slices.shape.w);
    vec3 gain = slices.shape.w * lighterHere(r, pixel * slices.shape.x) * sliceGain(toEye, paintedLean(uv), true);
    color = vec4(mix(radiance(r, reflectance, stored.zw, uv) * gain, horizonColor(position.xz), hazeShare(d)), alpha);
    if (viewMode() == VIEW_TIERS) color.rgb = vec3(0.05, 0.75, 0.1);
    if (viewMode() == VIEW_NORMALS) color.rgb = vec3(0.5, 1.0, 0.5);
    if (viewMode() == VIEW_OVERDRAW) color = vec4(1.0 / 32.0, 0.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY) color = vec4(0.1, 0.9, 0.2, alpha);
}
