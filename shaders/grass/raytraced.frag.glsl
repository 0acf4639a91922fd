// A ray through a shell of vertical slices, front to back, from where it enters (Habel, Wimmer and Jeschke 2007,
// sections 3 and 4; H-1 to H-8). Coordinates of the ray: x and z in cells of the field, from the cell that the eye is
// over; height in metres below the shell's top. The place's lean and slope are taken off the ray, so that slices stand
// upright on level ground. Needs: const bool INSIDE; const int REST.
#include "lib/density.glsl"
#include "lib/field.glsl"
#include "lib/force.glsl"
#include "lib/frame.glsl"
#include "lib/heights.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"
#include "lib/slice_light.glsl"
#include "lib/slices.glsl"
#include "lib/transparency.glsl"
#include "lib/wind.glsl"
#include "numerics/clump.h"
#include "numerics/correction.h"
#include "numerics/hash.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/population.h"
#include "numerics/rays.h"
#include "numerics/stand.h"

const int REST_MEAN = 0, REST_OPAQUE = 1, REST_NOTHING = 2;
const float kCoarse = 4.0;   // level of detail that stands for slices in the mean
const float kNear = 0.05;    // metres: the near plane
const float kTurned = 0.15;  // a slice that is seen edge on is filtered as one turned by so much

layout(location = 0) uniform int steps;
layout(location = 1) uniform float cutOff;
layout(location = 2) uniform float depthAt;
layout(location = 3) uniform float pixelsPerMetre;  // at one metre

in vec3 position;
in vec2 place;
out vec4 color;
layout(depth_less) out float gl_FragDepth;

// What is the same along a ray.
struct Shell {
    vec3 way;      // unit, from the eye
    vec3 start;    // where it begins in the shell, relative to the eye
    float height;  // of the shell here, metres
    vec2 turned;   // share of the slices across x and across z that shows
    vec3 gain, brighter, ambient;
    float visible;  // share of the sun that is seen from where it comes in: shadows are larger than its way through
};

// What has come together along a ray.
struct Sum {
    vec3 light;  // times its opacity
    float through;
    float depth;  // metres from the start to where depthAt of the opacity was reached
};

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

// Rise of the ground a metre along x and z.
vec2 slopeHere(vec2 ground) {
    if (!TERRAIN_HEIGHTS) return vec2(0.0);
    vec3 n = groundNormal(ground, slices.cellSize);
    return -n.xz / max(n.y, 0.05);
}

// A slice where a ray meets it.
struct Met {
    vec3 texel;
    float lightLayer;
    vec2 mirror;
    float side;
    vec3 root;  // the ground below, relative to the eye
};
Met metAt(SliceHit hit, Shell shell) {
    int n = slices.slices, axis = hit.family;
    float half_ = 0.5 / float(n);
    vec2 c = hit.position.xy + vec2(half_);
    int across = int(floor(float(hit.k) / float(n))), k = hit.k - n * across;
    float along = axis == 0 ? c.y : c.x, whole = floor(along);
    ivec2 cell = axis == 0 ? ivec2(across, int(whole)) : ivec2(int(whole), across);
    CellVersion v = cellVersion(int(slices.eyeCell.x) + cell.x, int(slices.eyeCell.y) + cell.y, slices.seed);
    vec2 signs = axis == 0 ? v.mirror : v.mirror.yx, begin = axis == 0 ? v.shift : v.shift.yx;
    float seen = (axis == 0 ? -shell.way.x : -shell.way.z) * signs.x;
    int layer = (signs.x > 0.0 ? k : n - 1 - k) + n - int(begin.x * float(n) + 0.5);  // repeats after n
    if (layer >= n) layer -= n;
    float in_ = along - whole;
    Met m;
    m.texel = vec3((signs.y > 0.0 ? 1.0 + in_ : 2.0 - in_) - begin.y,
                   clamp(1.0 + hit.position.z / shell.height, 0.0, 1.0), float(axis * n + layer));
    m.side = seen > 0.0 ? 1.0 : -1.0;
    m.lightLayer = seen > 0.0 ? 0.0 : float(2 * n);
    m.mirror = v.mirror;
    float here = (float(hit.k) + 0.5) / float(n);
    vec2 root = fromCells(axis == 0 ? vec2(here, along) : vec2(along, here));
    float above = shell.height + hit.position.z;
    m.root = vec3(root.x, shell.start.y + shell.way.y * hit.t - above, root.y);
    return m;
}

bool onTerrain(vec2 ground) { return ground == clamp(ground, vec2(0.0), frame.terrainSize); }

// What a slice there stores, and its opacity before shares of families.
float opacityOf(Met m, Shell shell, float level, float pixel, out vec4 stored) {
    stored = vec4(0.0);
    vec2 ground = m.root.xz + frame.eye.xz;
    if (!onTerrain(ground)) return 0.0;
    stored = textureLod(sliceThreshold, m.texel, level);
    float far = length(m.root), density = sliceDensity(fieldDensityOver(mapPlace(ground), pixel),
                                                       lodRamp(far, slices.minGeom, slices.geomInv));
    density *= 1.0 - lodRamp(far, slices.minBTF, slices.btfInv);
    return texelOpacity(stored.x, stored.y, density, slices.fade, level);
}

vec3 lightOf(Met m, Shell shell, vec3 at, int axis, float fine, float pixel, vec4 stored) {
    vec4 leaf = textureLod(sliceReflectance, m.texel, fine);
    leaf.rgb = paintedOver(leaf.rgb, mapPlace(m.root.xz + frame.eye.xz), pixel);
    SliceSpot s;
    s.texel = m.texel;
    s.visible = shell.visible;
    s.images = sunImages(axis, m.side, m.mirror);
    s.lightLayer = m.lightLayer;
    s.gain = shell.gain, s.brighter = shell.brighter, s.ambient = shell.ambient;
    for (int c = 0; c < 3; ++c) s.lamp[c] = vec4(0.0);
    if (LAMPS) lampsOnImages(at, vec4(m.side, m.mirror, float(axis)), s.lamp);
    s.fine = fine;
    return clamp(sliceRadiance(s, leaf.rgb, leaf.a, stored), vec3(0.0), vec3(kBrightest));
}

void add(inout Sum sum, vec3 light, float alpha, float t) {
    float a = clamp(alpha, 0.0, 1.0);
    if (sum.through > 1.0 - depthAt && sum.through * (1.0 - a) <= 1.0 - depthAt) sum.depth = t;
    sum.light += sum.through * a * light;
    sum.through *= 1.0 - a;
}

// Width of a pixel so far off, metres.
float pixelAt(float distance) { return distance / pixelsPerMetre; }

float levelAt(float pixel, float facing) {
    vec2 texels =
        vec2(textureSize(sliceThreshold, 0).xy) * pixel / vec2(slices.cellSize * max(facing, kTurned), slices.top);
    return max(log2(max(max(texels.x, texels.y), 1e-6)) + log2(slices.sharpness), 0.0);
}

// What slices from `hit` on would show up to the shell's end. Which of them is looked at, and where, is random: looked
// at where the ray goes on, coarse texels would show as blocks.
void addRest(inout Sum sum, Shell shell, SliceRay ray, SliceHit hit, uint grain) {
    if (REST == REST_NOTHING || hit.family > kRayV) return;
    int axis = hit.family;
    vec2 speed = abs(ray.direction.xy) * float(slices.slices);
    float left = max(ray.end - hit.t, 0.0), middle = hit.t + 0.5 * min(left, slices.cellSize);
    Met m = metAt(hit, shell);
    uint r = hash2(grain, 79u);
    m.texel = vec3(hashUnit(r), clamp(1.0 + (ray.entry.z + ray.direction.z * middle) / shell.height, 0.0, 1.0),
                   float(axis * slices.slices + int(hashUnit(hash2(r, 1u)) * float(slices.slices))));
    vec4 stored;
    float pixel = pixelAt(length(shell.start) + hit.t), alpha = opacityOf(m, shell, kCoarse, pixel, stored);
    if (!(alpha > 0.0)) return;
    float slicesPerMetre = dot(speed, shell.turned), shown = 1.0 + left * slicesPerMetre;
    float all = REST == REST_OPAQUE ? 1.0 : correctionPow(alpha, min(shown, 64.0));
    // As deep as light comes in the mean.
    float t = hit.t + min(left, 1.0 / max(alpha * slicesPerMetre, 1e-3));
    add(sum, lightOf(m, shell, shell.start + shell.way * hit.t, axis, kCoarse, pixel, stored), all, t);
}

Sum traced(Shell shell, SliceRay ray, uint grain) {
    Sum sum = Sum(vec3(0.0), 1.0, -1.0);
    // A ray's way through the shell is short: where it comes in says how fine all that it meets is.
    float pixel = pixelAt(max(length(shell.start), slices.cellSize)), last = 0.0;
    vec2 levels = vec2(levelAt(pixel, abs(shell.way.x)), levelAt(pixel, abs(shell.way.z)));
    levels = floor(levels + hashUnit(hash2(grain, 80u)));  // one of two: twice the look-ups would blend them
    SliceHit hit = sliceHit(ray);
    for (int i = 0; i < steps && hit.family >= 0 && hit.family <= kRayV; ++i) {
        float turned = shell.turned[hit.family];
        if (turned > 0.004) {
            float level = levels[hit.family];
            Met m = metAt(hit, shell);
            vec4 stored;
            float alpha = opacityOf(m, shell, level, pixel, stored) * turned;
            if (alpha > 0.004) {
                float fine = max(level - 1.0, 0.0);
                add(sum, lightOf(m, shell, shell.start + shell.way * hit.t, hit.family, fine, pixel, stored), alpha,
                    hit.t);
                last = hit.t;
            }
        }
        ray = sliceAfter(ray, hit);
        if (sum.through <= 1.0 - cutOff) break;
        hit = sliceHit(ray);
    }
    if (sum.through > 1.0 - cutOff) addRest(sum, shell, ray, hit, grain);
    if (sum.depth < 0.0) sum.depth = last;
    return sum;
}

// A random number fixed to the place: its grains are about a pixel.
uint grainAt(vec2 c, float distance) {
    float size = float(textureSize(sliceThreshold, 0).x), pixel = distance / (pixelsPerMetre * slices.cellSize);
    float level = clamp(floor(log2(max(pixel * size, 1e-6))), 0.0, 16.0);
    vec2 whole = floor(c);
    ivec2 cell = ivec2(slices.eyeCell) + ivec2(whole), at = ivec2((c - whole) * size * exp2(-level));
    return hash3(uint(at.x) + 2048u * uint(at.y), cellHash(cell.x, cell.y, uint(level)), 78u);
}

// Whether nothing of the species grows as far as a ray may come through the shell.
bool bareAhead(vec2 ground, vec3 way) {
    if (!GRASS_DENSITY || field.species[slices.species].tiling < 0.0) return false;
    float steep = max(-way.y, 1e-3),
          reach = min(slices.top * length(way.xz) / steep, float(steps) * slices.cellSize / float(slices.slices));
    float room = 2.0 * reach + 2.0 * slices.top;
    return !(fieldDensityOver(mapPlace(ground + 0.5 * reach * way.xz), room) > 0.0);
}

void main() {
    float far = max(length(position), 1e-4);
    vec3 way = position / far;
    // Where the ray is when it enters, over which ground.
    vec3 start = INSIDE ? vec3(0.0) : position;
    vec2 ground = INSIDE ? frame.eye.xz : place, uv = mapPlace(ground);
    gl_SampleMask[0] = -1;
    gl_FragDepth = gl_FragCoord.z;
    if (bareAhead(ground, way)) discard;
    float above = INSIDE ? -groundHeight(ground) : slices.top;
    vec3 foot = start - vec3(0.0, above, 0.0);
    float press;
    BladeLean p = leanOf(standHere(foot, toCells(foot.xz), uv, press), vec2(0.0));
    float lean2 = min(dot(p.lean, p.lean), 0.9), upright = sqrt(1.0 - lean2);
    float height = max(slices.top * p.scale * sunk(press) * upright, 1e-4);
    float sinks = way.y - dot(slopeHere(ground), way.xz);
    float ahead = max((above - height) / max(-sinks, 1e-6), 0.0);
    if (above > height && !(sinks < 0.0)) discard;
    vec2 shear = p.lean / upright;
    vec3 entry =
        vec3(toCells(start.xz + way.xz * ahead - shear * min(above, height)) - vec2(0.5 / float(slices.slices)),
             min(above - height, 0.0));
    vec3 direction = vec3((way.xz - shear * sinks) / slices.cellSize, sinks);

    float level = max(length(way.xz), 1e-4);
    vec3 toEye = -way;
    far = INSIDE ? slices.cellSize : far;
    Shell shell;
    shell.way = way;
    shell.start = start + way * ahead;
    shell.height = height;
    shell.turned = CONSERVING ? verticalShare(toEye.y) * abs(way.xz) / level : vec2(1.0);
    shell.brighter = p.lighter * darkened(far) * slices.reflectScale * sliceGain(toEye, p.free, press, false);
    shell.gain = SUN ? shell.brighter * frame.sunLight * frame.sunIsUp : vec3(0.0);
    shell.ambient = shell.brighter * slices.ambient * skyShare(uv);

    uint grain = grainAt(toCells(shell.start.xz), far);
    shell.visible = sunVisible(shell.start, vec3(0.0));
    Sum sum = traced(shell, sliceRay(entry, direction, slices.slices, slices.slices, height), grain);
    float opacity = 1.0 - sum.through;
    float alpha = coveredAlpha(TRANSPARENCY, opacity, grain);
    if (!(alpha > 0.0)) discard;
    vec3 light = sum.light / max(opacity, 1e-4);
    float hazed = hazeShare(length(shell.start));
    color = vec4(light * (1.0 - hazed) + horizonColor(shell.start.xz) * hazed, alpha);
    vec4 clip = frame.viewProj * vec4(shell.start + way * sum.depth, 1.0);
    gl_FragDepth = hitDepth(clip, gl_FragCoord.z, kNear);
    if (viewMode() == VIEW_TIERS) color.rgb = vec3(0.5, 0.1, 0.8);
    if (viewMode() == VIEW_NORMALS) color.rgb = vec3(0.5, 0.5, 1.0);
    if (viewMode() == VIEW_OVERDRAW) color = vec4(1.0 / 32.0, 0.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY) color.rgb = vec3(0.1, 0.65, 0.15);
}
