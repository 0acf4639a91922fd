// A texel of the horizontal slice (lib/far.glsl), as opaque as the grass is along this slanted ray, less what vertical
// slices cover (grass/slices.h), and lit as they are.
#include "lib/along.glsl"
#include "lib/field.glsl"
#include "lib/density.glsl"
#include "lib/far.glsl"
#include "lib/far_light.glsl"
#include "lib/force.glsl"
#include "lib/frame.glsl"
#include "lib/ground_around.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"
#include "lib/slices.glsl"
#include "lib/transparency.glsl"
#include "lib/wind.glsl"
#include "numerics/clump.h"
#include "numerics/hash.h"
#include "numerics/land.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/stand.h"

in vec3 position;
in vec2 place;
out vec4 color;

// A random number fixed to the ground, its grains about a pixel.
uint grain(Repeated r) {
    float size = slices.farTexels,
          level = clamp(floor(log2(max(length(r.dx), length(r.dy)) / slices.sharpness * size)), 0.0, 16.0);
    ivec2 at = ivec2(r.texel.xy * size * exp2(-level));
    return hash3(uint(at.x) + 2048u * uint(at.y), cellHash(r.cell.x, r.cell.y, uint(level)), 77u);
}

// What clumpValues are here, less where a pixel holds several clumps.
vec3 clumpsHere(Repeated r, float pixel) {
    float left = 1.0 - pixel / (2.0 * slices.clumpSize);
    if (!GRASS_CLUMPS || slices.clumpSize <= 0.0 || left <= 0.0) return vec3(0.0);
    return left * clumpValues(r.cell.x, r.cell.y, r.inCell, slices.cellSize, slices.clumpSize, slices.seed);
}

// What the place has for the blades that the slice stands for; clumps are added where they are seen.
BladeStand standHere(vec2 uv) {
    BladeStand s = emptyStand();
    s.paint = leanAlong(uv);
    s.leanAtFull = slices.leanAtFull;
    s.breeze = windLeanAt(position.xz, -1.0, field.species[slices.species].gusts);
    s.clumpLean = slices.clumpLean;
    s.clumpLightness = slices.clumpLightness;
    return s;
}

// The force where this ray is so high over the ground, metres.
vec3 forceSeen(vec3 toEye, float high) {
    vec2 on = toEye.xz * ((high - slices.farHeight) / max(toEye.y, 0.03));
    return forceHere(position.xz + on, mapPlace(place + on));
}
// What lies there: x, how much of the grass; y, how much of it is pressed. Vertical slices that stand before it hide it
// themselves; where there are none, a ray sees of it what it would if it came in among grass that lies, too.
vec2 laidSeen(vec3 toEye, float vertical) {
    if (!FORCES && !FORCE_MAP) return vec2(0.0);
    vec3 f = forceSeen(toEye, 0.0);
    return vec2(laidBy(f), f.z) * mix(laidBy(forceSeen(toEye, slices.meanHeight * slices.cellSize)), 1.0, vertical);
}

void main() {
    vec3 face = cross(dFdx(position), dFdy(position));  // before pixels part
    vec2 slope = clamp(-face.xz / (abs(face.y) > 1e-12 ? face.y : 1e-12), vec2(-4.0), vec2(4.0));
    if (TERRAIN_BEYOND && beyondBy(place, frame.terrainSize) > 0.0) discard;  // of nodes that reach over the edge
    Repeated r = repeated(position.xz);
    vec2 uv = mapPlace(place);
    float d = length(position);
    vec3 toEye = -position / max(d, 1e-4), seen = seenOver(toEye, slope);
    float grown = densityAlong(uv), density = sliceDensity(grown, lodRamp(d, slices.minGeom, slices.geomInv));
    BladeStand stand = standHere(uv);
    vec2 lean = leanOf(stand, vec2(0.0)).lean;
    // Vertical slices that lean cover less of what lies below: as much as they are lowered.
    float vertical = GRASS_SLICES || GRASS_RAYTRACED ? sqrt(1.0 - min(dot(lean, lean), 0.9)) * verticalShare(toEye.y) *
                                                           (1.0 - lodRamp(d, slices.minBTF, slices.btfInv))
                                                     : 0.0;
    vec4 stored;
    vec2 laid = laidSeen(toEye, vertical);
    float alpha = farOpacity(sliceThreshold, r, density, bladeShareSeen(uv), seen.y, vertical, laid.x, stored);
    // Where pixels are covered by samples, soil shows between blades as it does between near ones, not as a veil.
    // Else it is blended: it lies alone, and needs no order.
    gl_SampleMask[0] = -1;
    if (TRANSPARENCY == COVERAGE) alpha = coveredAlpha(COVERAGE, alpha, grain(r));
    if (!(alpha > 0.002)) discard;
    vec4 leaf = textureGrad(sliceReflectance, r.texel, r.dx, r.dy);
    leaf.rgb = paintedAlong(leaf.rgb, uv, seen);
    float pixel = max(length(r.dx), length(r.dy)) / slices.sharpness * slices.cellSize;
    stand.clump = clumpsHere(r, pixel);
    BladeLean l = leanOf(stand, vec2(0.0));
    float plain = slices.reflectScale * darkened(d) * l.lighter;
    vec3 gain = plain * farLevel(max(length(r.dx), length(r.dy))) * farGain(seen, lean, l.clump, laid.y, grown);
    FarLit lit =
        FarLit(levelSun(), kLevel, position, kOnGround,
               gain * groundAround(position) * (slices.farAmbient * skyShare(uv) * skyOnGrassPastTrees(position)),
               sunVisible(position, kOnGround) * sunOverSlope(toEye, slope, density), gain,
               plain * laidGain(lookTap(seen), laid.y), sunsHotSpot(toEye, laid.y));
    vec3 light = clamp(farRadiance(sliceLight, r, leaf, stored.zw, lit), vec3(0.0), vec3(kBrightest));
    color = vec4(mix(light, hazeColor(position), hazeShare(d)), alpha);
    if (viewMode() == VIEW_TIERS) color.rgb = vec3(0.05, 0.75, 0.1);
    if (viewMode() == VIEW_NORMALS) color.rgb = vec3(0.5, 1.0, 0.5);
    if (viewMode() == VIEW_OVERDRAW) color = vec4(1.0 / 32.0, 0.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY) color = vec4(0.1, 0.9, 0.2, alpha);
}
