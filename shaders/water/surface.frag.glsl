// Water: what it mirrors, what is seen through it, and glints of sun and lamps (numerics/water.h). What lies under it
// is dimmed where it was drawn, by a factor a colour (the second output); nothing is copied.
#include "lib/dimmed.glsl"
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/lamps.glsl"
#include "lib/light.glsl"
#include "lib/scene_depth.glsl"
#include "lib/shadow.glsl"
#include "lib/wind.glsl"
#include "numerics/water.h"
#include "shared/bindings.h"
#include "shared/water.h"

layout(std140, binding = UBO_WATER) uniform WaterBlock { WaterGlobals water; };
layout(binding = TEX_REFLECTION) uniform sampler2D reflected;

const float kWidestSmear = 0.58;  // clip units
const float kSmearLooks = 8.0;    // at most, by hand: drivers filter anisotropically each in its way, or not at all

in vec3 position;

// Slopes that the pixel shows; z: the mean square, along each axis, of those that are too small for it.
vec3 ripples() {
    if (!WIND) return vec3(0.0, 0.0, kSmoothest);
    vec2 dx = dFdx(position.xz), dy = dFdy(position.xz);
    float share = rippleShare(blowsAt(winds[NOW], position.xz));
    vec3 sum = vec3(0.0, 0.0, 0.0);
    for (int i = 0; i < WATER_WAVES; ++i) {
        WaterWave wave = water.waves[i];
        float seen = waveSeen(length(vec2(dot(wave.turns, dx), dot(wave.turns, dy))));
        if (seen > 0.0)
            sum.xy += waveWay(wave.turns) * (waveSlope(wave.turns, wave.phase, wave.slope, position.xz) * seen);
        sum.z += 0.25 * wave.slope * wave.slope * (1.0 - seen * seen);
    }
    return vec3(sum.xy * share, sum.z * share * share + kSmoothest);
}

// Depth of the nearest thing below the surface in this pixel: samples in front of it are not the water's.
float depthBelow(float surface) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (!MULTISAMPLED) return min(texelFetch(depthPlain, pixel, 0).r, surface);
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < frame.samples; ++i) {
        float d = texelFetch(depthSamples, pixel, i).r;
        if (d <= surface) {
            sum += d;
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : surface;
}

// Where a thing in that direction lies in the picture of what is mirrored. The picture is the scene seen by the
// mirrored eye: the image of what lies above the water is where the eye sees it below.
vec2 inMirror(vec3 towards) {
    vec4 clip = frame.viewProj * vec4(position + vec3(towards.x, -towards.y, towards.z) * water.mirroredAt, 1.0);
    return clip.xy / clip.w * water.mirrorScale + water.mirrorAt;
}

vec3 skyFrom(vec3 towards) { return mix(horizonColor(towards.xz), frame.skyLight, sqrt(towards.y)); }

// What the water mirrors: smeared along the view by waves that are too small for a pixel, out to two standard
// deviations of their slopes.
vec3 mirroredLight(vec3 toEye, vec3 ripple) {
    vec3 r = mirrored(-toEye, rippleNormal(ripple.xy));
    if (!WATER_REFLECTION || !(water.mirrors > 0.0)) return skyFrom(r);
    vec2 along = normalize(toEye.xz + vec2(1e-6, 0.0)) * sqrt(max(ripple.z - kSmoothest, 0.0));
    vec2 uv = inMirror(r);
    vec2 smear = inMirror(mirrored(-toEye, rippleNormal(ripple.xy + along))) -
                 inMirror(mirrored(-toEye, rippleNormal(ripple.xy - along)));
    vec2 widest = kWidestSmear * water.mirrorScale;
    smear = clamp(smear, -widest, widest);
    float texels = 2.0 * length(smear * vec2(textureSize(reflected, 0))),
          number = clamp(ceil(texels), 1.0, kSmearLooks), level = log2(max(texels / number, 1.0)), weights = 0.0;
    vec3 sum = vec3(0.0);
    for (float i = 0.5; i < number; i += 1.0) {
        float off = 2.0 * i / number - 1.0, weight = exp(-2.0 * off * off);
        sum += weight * textureLod(reflected, uv + off * smear, level).rgb;
        weights += weight;
    }
    return sum / weights;
}

// Light of lamps that falls on the water, and what of it the surface throws to the eye.
struct LampsHere {
    vec3 down, glint;
};
LampsHere lampsOnWater(vec3 toEye, vec3 ripple) {
    LampsHere sum = LampsHere(vec3(0.0), vec3(0.0));
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampAt(i, position);
        if (!(l.direction.y > 0.0)) continue;
        vec3 light = l.light * lampVisible(i, position, vec3(0.0));
        sum.down += light * l.direction.y;
        sum.glint += light * sunGlint(ripple.xy, ripple.z, toEye, l.direction);
    }
    return sum;
}

// Whether x, z are within a round place.
bool within(vec2 at, vec2 middle, float radius) { return dot(at - middle, at - middle) <= radius * radius; }
// Whether the eye's ray has come into another water before it comes to this one.
bool entersAnother() {
    for (int i = 0; i < WATER_COVERS && water.covers[i].z > 0.0; ++i) {
        vec4 cover = water.covers[i];
        vec2 at = position.xz * (cover.w / water.height);
        bool onLand = all(greaterThanEqual(at, water.land.xy)) && all(lessThanEqual(at, water.land.zw));
        if (onLand && within(at, cover.xy, cover.z)) return true;
    }
    return false;
}

void main() {
    if (!within(position.xz, water.middle, water.radius) || entersAnother()) discard;
    float distance = length(position);
    vec3 toEye = -position / distance, ripple = ripples();
    vec3 n = rippleNormal(ripple.xy);
    float mirror = waterFresnel(roughCosine(max(dot(n, toEye), 0.0), ripple.z));
    float surface = gl_FragCoord.z, below = max(depthBelow(surface), 1e-7);
    float straight = distance * (surface / below - 1.0), depth = straight * max(toEye.y, 0.0);
    vec3 left = waterLeft(water.extinction, waterWay(straight, depth, toEye.y), depth);
    float sun = SUN ? sunVisible(position, vec3(0.0)) * frame.sunIsUp : 0.0;
    vec3 down = frame.skyLight + (SUN ? frame.sunLight * (sun * max(frame.sunDirection.y, 0.0)) : vec3(0.0));
    LampsHere fromLamps = lampsOnWater(toEye, ripple);
    if (LAMPS) down += fromLamps.down;
    vec3 body = water.color * down * (1.0 - left) * (1.0 - mirror);
    if (SUN) body += frame.sunLight * (sun * sunGlint(ripple.xy, ripple.z, toEye, frame.sunDirection));
    if (LAMPS) body += fromLamps.glint;
    float haze = hazeShare(distance);
    vec3 through = left * (1.0 - mirror);
    // What is mirrored and what is seen through are in their own haze already.
    vec3 light = mirroredLight(toEye, ripple) * mirror + body * (1.0 - haze) +
                 hazeColor(position) * haze * (1.0 - mirror - through);
    added = vec4(clamp(light, vec3(0.0), vec3(kBrightest)), 1.0);
    factor = vec4(through, 0.0);
}
