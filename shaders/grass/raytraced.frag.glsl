// A ray through the slices over the terrain (lib/slice_rays.glsl). Cells count from that which the eye is over.
// Needs: const bool INSIDE; const int REST; const bool WHOLE; const bool ENDS_AT_SCENE; const bool MULTISAMPLED.
#include "lib/density.glsl"
#include "lib/field.glsl"
#include "lib/force.glsl"
#include "lib/frame.glsl"
#include "lib/ground_around.glsl"
#include "lib/heights.glsl"
#include "lib/light.glsl"
#include "lib/motion.glsl"
#include "lib/scene_depth.glsl"
#include "lib/shadow.glsl"
#include "lib/slice_rays.glsl"
#include "lib/slices.glsl"
#include "lib/wind.glsl"
#include "numerics/clump.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/stand.h"

const int kLooksAhead = 24;

in vec3 position;
in vec2 place;
layout(location = 0) out vec4 color;
layout(depth_less) out float gl_FragDepth;

BladeStand standHere(vec3 foot, vec2 at, vec2 uv, out float press) {
    BladeStand s = emptyStand();
    s.paint = paintedLean(uv);
    s.leanAtFull = slices.leanAtFull;
    s.breeze = windLeanAt(foot.xz, -1.0, field.species[slices.species].gusts);
    vec2 whole = floor(at);
    ivec2 cell = ivec2(slices.eyeCell) + ivec2(whole);
    if (GRASS_CLUMPS && slices.clumpSize > 0.0)
        s.clump =
            clumpValues(cell.x, cell.y, (at - whole) * slices.cellSize, slices.cellSize, slices.clumpSize, slices.seed);
    s.clumpLean = slices.clumpLean;
    s.clumpHeight = slices.clumpHeight;
    s.clumpLightness = slices.clumpLightness;
    press = 0.0;
    if (FORCES || FORCE_MAP) {
        vec3 force = forceHere(foot.xz, uv);
        s.push = force.xy;
        press = force.z;
    }
    s.tall = bladeShare(uv);
    return s;
}

// x, z relative to the eye in cells, and back.
vec2 toCells(vec2 at) { return at / slices.cellSize + slices.inCell; }
vec2 fromCells(vec2 c) { return (c - slices.inCell) * slices.cellSize; }

bool onTerrain(vec2 ground) { return ground == clamp(ground, vec2(0.0), frame.terrainSize); }

// The ground below, relative to the eye.
vec3 rootOf(Met m, Shell shell) {
    vec2 root = fromCells(m.at);
    return vec3(root.x, shell.start.y + shell.way.y * m.t - m.above, root.y);
}

float grownAt(Met m, Shell shell, float pixel) {
    vec3 root = rootOf(m, shell);
    vec2 ground = root.xz + frame.eye.xz;
    if (!onTerrain(ground)) return 0.0;
    if (WHOLE) return 1.0;
    return sliceDensity(fieldDensityOver(mapPlace(ground), pixel),
                        lodRamp(length(root), slices.minGeom, slices.geomInv));
}
float sunAt(Met m, Shell shell) { return sunVisible(shell.start + shell.way * m.t, kOnGround); }
vec3 paintedAt(vec3 reflectance, Met m, Shell shell, float pixel) {
    return paintedOver(reflectance, mapPlace(fromCells(m.at) + frame.eye.xz), pixel, -shell.seen);
}

// How far along its way a ray goes through the shell before any of the species may grow below it (m); negative: none
// does. It looks ahead by a quarter of the way that its steps would come, again and again.
float bareWay(vec2 ground, vec3 way) {
    if (!GRASS_DENSITY || field.species[slices.species].tiling < 0.0) return 0.0;
    float level = max(length(way.xz), 1e-4), all = slices.top * level / max(-way.y, 1e-3), bare = 0.0;
    float part = min(all, 0.25 * float(steps) * slices.cellSize / float(slices.slices));
    for (int i = 0; i < kLooksAhead; ++i) {
        vec2 middle = ground + (bare + 0.5 * part) / level * way.xz;
        if (fieldDensityOver(mapPlace(middle), 2.0 * part + 2.0 * slices.top) > 0.0) return bare / level;
        bare += part;
        if (!(bare < all)) break;
        part = min(part, all - bare);
    }
    return -1.0;
}

void main() {
    float far = max(length(position), 1e-4);
    vec3 way = position / far;
    // Where the ray is when it enters, over which ground.
    vec3 start = INSIDE ? vec3(0.0) : position;
    vec2 ground = INSIDE ? frame.eye.xz : place, uv = mapPlace(ground);
    gl_SampleMask[0] = -1;
    gl_FragDepth = gl_FragCoord.z;
    float bare = bareWay(ground, way);
    if (bare < 0.0) discard;
    float above = INSIDE ? -groundHeight(ground) : slices.top;
    if (bare > 0.0) {
        start += way * bare, ground += way.xz * bare, uv = mapPlace(ground);
        above = start.y - groundHeight(ground);
        if (!(above > 0.0)) discard;
    }
    vec3 foot = start - vec3(0.0, above, 0.0);
    float press;
    BladeStand stands = standHere(foot, toCells(foot.xz), uv, press);
    BladeLean p = leanOf(stands, vec2(0.0));
    float lean2 = min(dot(p.lean, p.lean), 0.9), upright = sqrt(1.0 - lean2);
    float height = max(slices.top * p.scale * sunk(press) * upright, 1e-4);
    vec3 n = groundNormal(ground, slices.cellSize);
    vec2 slope = -n.xz / max(n.y, 0.05);
    float sinks = riseOver(way, slope);
    float ahead = max((above - height) / max(-sinks, 1e-6), 0.0);
    if (above > height && !(sinks < 0.0)) discard;
    vec2 shear = p.lean / upright;
    vec3 entry =
        vec3(toCells(start.xz + way.xz * ahead - shear * min(above, height)) - vec2(0.5 / float(slices.slices)),
             min(above - height, 0.0));
    vec3 direction = vec3((way.xz - shear * sinks) / slices.cellSize, sinks);

    float level = max(length(way.xz), 1e-4);
    vec3 toEye = -way, over = seenOver(toEye, slope);
    far = INSIDE ? slices.cellSize : far;
    Shell shell;
    shell.way = way, shell.seen = way;
    shell.start = start + way * ahead;
    shell.height = height;
    shell.bend = vec2(0.0);
    shell.toField = kLevel;
    shell.sun = levelSun();
    shell.turned = CONSERVING ? verticalShare(toEye.y) * abs(way.xz) / level : vec2(1.0);
    float plain = p.lighter * darkened(far) * slices.reflectScale;
    float share = lodRamp(length(shell.start), slices.minGeom, slices.geomInv);
    vec3 shown = plain * sharedGain(over, share) * sliceGain(over, p.free - p.clump, p.clump, press, false);
    shell.gain =
        SUN ? shown * sunsHotSpot(toEye, press) * sunOverSlope(toEye, slope, 1.0) * frame.sunLight * frame.sunIsUp
            : vec3(0.0);
    shell.ambient =
        shown * slices.ambient * (skyShare(uv) * skyOnGrassPastTrees(shell.start)) * groundAround(shell.start);
    shell.brighter = plain * laidGain(lookTap(toEye), press);

    vec2 comesIn = toCells(shell.start.xz);
    uint grain = INSIDE ? grainAt(comesIn + way.xz, way.y, far) : grainAt(comesIn, 0.0, far);
    shell.raise = kOnGround;
    SliceRay ray = sliceRay(entry, direction, slices.slices, slices.slices, height);
    float scene = 0.0;
    if (ENDS_AT_SCENE) {
        scene = distanceTo(sceneDepth(ivec2(gl_FragCoord.xy)), way) - length(start) - ahead;
        if (!(scene > 0.0)) discard;
        ray.end = min(ray.end, scene);
    }
    Sum sum = traced(shell, ray, grain);
    // Far away whole rays give way to the horizontal slice, not blade by blade: between the blades that were left one
    // would see down to where all of them keep the light off.
    float stays = 1.0 - lodRamp(length(shell.start), slices.minBTF, slices.btfInv);
    sum.light *= stays, sum.through = mix(1.0, sum.through, stays);
    color = shownOf(sum, shell, grain);
    if (!(color.a > 0.0)) discard;
    if (viewMode() == VIEW_OVERDRAW) color.a = 0.0;
    if (ENDS_AT_SCENE) sum.depth = min(sum.depth, 0.98 * scene);
    if (TEMPORAL) {
        stands.breeze = windLeanBefore(foot.xz, -1.0, field.species[slices.species].gusts);
        tellMotion(movedSince(sum, shell, ray, p, leanOf(stands, vec2(0.0))));
    }
    gl_FragDepth = depthOf(sum, shell, gl_FragCoord.z);
}
