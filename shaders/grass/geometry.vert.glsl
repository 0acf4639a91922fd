// One vertex of one blade of one cell: which and where (lib/blade.glsl), and how it is lit (per vertex).
// Boulanger, Pattanaik and Bouatouch 2006, sections 3.1-3.5.
#include "lib/blade.glsl"
#include "lib/blade_light.glsl"
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/straight.glsl"
#include "lib/strip.glsl"
#include "numerics/basics.h"
#include "numerics/blade.h"
#include "numerics/population.h"
#include "shared/grass.h"

// At a covered sample: blades are thinner than pixels, and from the pixel's centre their light would be extrapolated.
centroid out vec4 lit;
centroid out vec4 sunned;  // as BladeLight has them
centroid out vec3 turned;
centroid out vec2 maskAt;
centroid out vec3 strip;  // across (-1: a plain triangle), along; opacity
flat out uint grain;      // a random number of the blade
out vec3 moved;           // metres since the frame before

const float kPlainPixels = 1.5;  // as engine/grass/tessellated.cpp has it
// One thin quad of several that the blade has near the eye is a triangle: its image is too fine to be seen, and the
// mean of that over all of the quad would show more of the tip.
bool isPlain(Stand s, float width) {
    float pixelsPerMetre =
        0.5 * frame.pixels.y * length(vec3(frame.viewProj[0].y, frame.viewProj[1].y, frame.viewProj[2].y));
    return s.cell.middleLacked > 0.49 && species.segments > 1 && width * pixelsPerMetre < kPlainPixels * length(s.root);
}
// A vertex, relative to the root.
vec3 cornerOf(BladePose pose, Stand s, float width, bool plain) {
    vec3 side = vec3(-pose.facing.y, 0.0, pose.facing.x) * s.across;
    if (!plain) return bladePosition(pose.control, pose.tip, s.v) + side * width;
    PlainBlade p = plainBlade(pose, width);
    return mix(p.base, p.apex, s.v) + side * (p.width * (1.0 - s.v));
}
// Light on the row v of a blade, so far to a side of its middle (m). n: normal of the side that faces the eye.
BladeLight lightOn(Blade b, Stand s, BladePose pose, float v, float lighter, vec3 side, out vec3 n) {
    BladeFrame f = bladeFrameFacing(pose.control, pose.tip, pose.facing, v);
    vec3 fromRoot = f.position + side, position = s.root + fromRoot;
    n = dot(f.normal, position) > 0.0 ? -f.normal : f.normal;
    float lacked = s.cell.middleLacked > 0.49 ? 0.0 : s.cell.middleLacked;
    return lightBlade(Lit(bladeColor(b.hue, b.lightness * lighter, v, lacked, s.uv), f.normal, n,
                          unitOr(-position, 1e-6, n), position, fromRoot, pose.facing, pose.upright,
                          groundSlope(s.ground, species.maskRadius), mix(species.rootOpen, 1.0, v), s.density, 1.0),
                      s.uv);
}

void main() {
    Blade b = bladeHere();
    Stand s = standHere(b);
    lit = vec4(0.0);
    sunned = vec4(0.0);
    turned = vec3(0.0);
    maskAt = vec2(0.0);
    strip = vec3(0.0);
    grain = 0u;
    moved = vec3(0.0);
    gl_Position =
        vec4(0.0, 0.0, 0.5, 1.0);  // dropped: no area. Not beyond a plane: then software clips the whole batch
    if (!exists(s)) return;

    float lighter;
    BladePose pose = poseHere(b, s, lighter);
    float width = b.width * frame.widening;
    bool plain = isPlain(s, width), straight = s.cell.middleLacked > 0.49;
    vec3 fromRoot = cornerOf(pose, s, width, plain), n;
    vec3 side = plain ? vec3(0.0) : vec3(-pose.facing.y, 0.0, pose.facing.x) * (s.across * width);
    BladeLight light = lightOn(b, s, pose, straight ? 1.0 : s.v, lighter, side, n);
    if (straight)
        light =
            straightLight(lightOn(b, s, pose, species.lightRow, lighter, side, n), light, plain ? plainRow(s.v) : s.v);
    lit = light.lit, sunned = light.sunned, turned = light.turned, maskAt = light.maskAt;
    if (viewMode() == VIEW_NORMALS) lit.rgb = n * 0.5 + 0.5;
    strip = vec3(plain ? -1.0 : s.across + 0.5, s.v, s.opacity);
    grain = floatBitsToUint(b.dither);
    if (TEMPORAL) moved = fromRoot - cornerOf(poseBefore(b, s), s, width, plain);
    vec3 position = s.root + fromRoot;
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
