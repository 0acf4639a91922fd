// One vertex of the shadow that one light throws of one blade: the blade's vertex, followed down its ray to the plane
// of the ground at its root and laid onto the ground there. Boulanger, Pattanaik and Bouatouch 2006, section 3.5; B-20.
#include "lib/blade.glsl"
#include "lib/density.glsl"
#include "lib/frame.glsl"
#include "lib/ground_light.glsl"
#include "lib/heights.glsl"
#include "lib/lamps.glsl"
#include "lib/strip.glsl"
#include "numerics/blade.h"
#include "numerics/lod.h"
#include "numerics/population.h"
#include "numerics/shadow.h"
#include "shared/grass.h"

layout(location = 0) uniform int light;             // 0: the sun; i: lamp i - 1
layout(location = 1) uniform float pixelsPerMetre;  // at one metre

out vec3 left;  // share of the ground's light that is left
out vec3 haze;  // light of the haze between the eye and the ground

const float kLongest = 4.0;     // blade heights: shadows get no longer (numerics/shadow.h fades them instead)
const float kNearer = 0.06;     // metres by which depth is let off: the ground's triangles are not quite the heights
const float kNormalStep = 0.1;  // metres over which the ground's slope is taken

vec3 towardsLight(vec3 at) { return light == 0 ? frame.sunDirection : lampAt(light - 1, at).direction; }

void main() {
    Blade b = bladeHere();
    Stand s = standHere(b, min(species.segments, SHADOW_QUADS));
    left = vec3(1.0), haze = vec3(0.0);
    gl_Position =
        vec4(0.0, 0.0, 0.5, 1.0);  // dropped: no area. Not beyond a plane: then software clips the whole batch
    // A blade that fades shades by chance: the first that shades a pixel is the only one, and half a shadow would keep
    // whole ones out.
    if (!exists(s) || s.opacity < b.dither) return;
    float widening = shadowWidening(shadowsOfOne(b.width, length(s.root) / pixelsPerMetre),
                                    shadowChance(floatBitsToUint(b.dither), cell.x, cell.y));
    if (!(widening > 0.0)) return;
    vec3 n = groundNormal(s.ground, kNormalStep);
    SpeciesInField kind = field.species[species.index];
    float near = 1.0 - lodRamp(length(s.root), field.shadeFrom, field.shadeInv);
    SoilShares soil = soilShares(
        soilLeft(species.area, vec2(kind.skyLeft, kind.scattered), slopeOf(n), s.density, s.density, bladeShare(s.uv)),
        near, skyShare(s.uv));
    vec3 takes = shadowShare(light, s.root, n, soil);
    if (!(max(takes.r, max(takes.g, takes.b)) > 1.0 / 255.0)) return;

    float lighter;
    BladePose pose = poseHere(b, s, lighter);
    BladeFrame f = bladeFrameFacing(pose.control, pose.tip, pose.facing, s.v);
    vec3 p = f.position + f.side * (s.across * b.width * frame.widening * widening * (1.0 - s.v * s.v));
    vec3 l = towardsLight(s.root + p);
    GroundShadow shadow = shadowOfSun(dot(p, n), vec3(l.x, dot(l, n), l.z), kLongest * kind.height);
    vec2 land = p.xz + shadow.offset;
    vec3 at = vec3(s.root.x + land.x, groundHeight(s.ground + land), s.root.z + land.y);
    left = vec3(1.0) - takes * shadow.alpha, haze = hazeLight(at);
    gl_Position = frame.viewProj * vec4(at, 1.0);
    float distance = length(at);
    gl_Position.z *= distance / max(distance - kNearer, 0.5 * distance);
}
