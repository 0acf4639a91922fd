// One vertex of one blade of one cell: which and where (lib/blade.glsl), and how it is lit (per vertex).
// Boulanger, Pattanaik and Bouatouch 2006, sections 3.1-3.5.
#include "lib/blade.glsl"
#include "lib/blade_light.glsl"
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/on_ground.glsl"
#include "lib/strip.glsl"
#include "numerics/basics.h"
#include "numerics/blade.h"
#include "numerics/population.h"
#include "shared/grass.h"

// At a covered sample: blades are thinner than pixels, and from the pixel's centre their light would be extrapolated.
centroid out vec4 lit;
centroid out vec4 sunned;  // as BladeLight has them
centroid out vec2 sunward;
centroid out vec3 maskAt;
centroid out vec3 strip;  // across, along; opacity
flat out uint grain;      // a random number of the blade
out vec3 moved;           // metres since the frame before

void main() {
    Blade b = bladeHere();
    Stand s = standHere(b, quads);
    lit = vec4(0.0);
    sunned = vec4(0.0);
    sunward = vec2(0.0);
    maskAt = vec3(0.0);
    strip = vec3(0.0);
    grain = 0u;
    moved = vec3(0.0);
    gl_Position =
        vec4(0.0, 0.0, 0.5, 1.0);  // dropped: no area. Not beyond a plane: then software clips the whole batch
    if (!exists(s)) return;

    float lighter;
    BladePose pose = poseHere(b, s, lighter);
    float lacked = middleLacked(quads);
    BladeFrame f = bladeFrameFacing(pose.control, pose.tip, pose.facing, s.v);
    vec3 fromRoot = f.position + f.side * (s.across * b.width * frame.widening);
    vec3 position = s.root + fromRoot;
    vec3 n = dot(f.normal, position) > 0.0 ? -f.normal : f.normal;  // the side that faces the eye
    BladeLight light = lightOnGround(
        Lit(bladeColor(b.hue, b.lightness * lighter, s.v, lacked, s.uv), n, unitOr(-position, 1e-6, n), position,
            fromRoot, b.dither, pose.upright, groundSlope(s.ground, s.root.y, species.maskReach),
            mix(species.rootOpen, 1.0, s.v), s.density, 1.0, 1.0),
        s.uv);
    lit = light.lit, sunned = light.sunned, sunward = light.sunward, maskAt = light.maskAt;
    // The sun's shade is looked up as high as the curve lies in the mean.
    maskAt.y += inFullHeight(overChords(pose, quads), s.uv).y / max(species.maskHeight, 1e-4);
    if (viewMode() == VIEW_NORMALS) lit.rgb = n * 0.5 + 0.5;
    strip = vec3(s.across + 0.5, s.v, s.opacity);
    grain = floatBitsToUint(b.dither);
    if (TEMPORAL) {
        BladePose before = poseBefore(b, s);
        BladeFrame g = bladeFrameFacing(before.control, before.tip, before.facing, s.v);
        moved = fromRoot - (g.position + g.side * (s.across * b.width * frame.widening));
    }
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
