// One vertex of one blade of one cell: which and where (lib/blade.glsl), and how it is lit (per vertex).
// Boulanger, Pattanaik and Bouatouch 2006, sections 3.1-3.5.
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/hash.h"
#include "numerics/bilinear.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/blade.h"
#include "numerics/clump.h"
#include "numerics/population.h"
#include "numerics/leaf.h"
#include "numerics/weights.h"
#include "numerics/shadow.h"
#include "lib/heights.glsl"
#include "lib/light.glsl"
#include "lib/lamps.glsl"
#include "lib/leaf.glsl"
#include "lib/shadow.glsl"
#include "lib/mask.glsl"
#include "lib/cover.glsl"
#include "lib/blade.glsl"

// At a covered sample: blades are thinner than pixels, and from the pixel's centre their light would be extrapolated.
centroid out vec4 lit;   // radiance; w: share of it that is haze
centroid out vec4 sunned;    // radiance where the sun reaches between the neighbours; w: density. Only where blades shade blades
centroid out vec2 maskAt;    // where in their shadow mask
centroid out vec3 strip;         // across, along; opacity
flat out uint grain;             // a random number of the blade

vec3 colorHere(Blade b, float v, float lighter, vec2 uv) {
    vec3 c = bladeTint(bladeGradient(species.rootColor.rgb, species.midColor.rgb, species.tipColor.rgb, v), b.control.w, b.tip.w * lighter);
    if (!GRASS_VEGETATION) return c;
    vec4 paint = textureLod(vegetationMap, uv * cover.tiling.y, 0.0);
    return mix(c, paint.rgb, paint.a);
}

// A vertex that is lit: reflectance; the side of the blade that the eye sees; where it is; where the blade faces; what of
// the light is left so near to the root, where no mask says it.
struct Lit {
    vec3 color, normal, toEye, position, fromRoot;
    vec2 facing;
    float open, density;
};
vec3 sunOn(Lit p) {
    if (!SUN) return vec3(0.0);
    return leafLight(p.color, species.looks.xyz, p.normal, p.toEye, frame.sunDirection.xyz, frame.sunLight.rgb) * sunVisible(p.position, vec3(0.0));
}
// Lamps that cast shadows are shaded here, by the vertex: unlike the sun there may be many.
vec3 lampsOn(Lit p) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampAt(i, p.position);
        float share = p.open;
        if (BLADE_SHADOWS && i < castingLamps()) share = maskLightAtVertex(maskPoint(p.fromRoot, p.facing, l.direction, species.mask.xy).xy, p.density);
        sum += leafLight(p.color, species.looks.xyz, p.normal, p.toEye, l.direction, l.light) * share;
    }
    return sum;
}
// Light on a blade: what no mask holds back into lit, what it may into sunned.
void lightBlade(Lit p, vec2 uv) {
    float distance = length(p.position), share = hazeShare(distance);
    p.color *= darkened(distance);
    vec3 sun = sunOn(p);
    vec3 rest = p.color * ambientLight(p.normal) * (skyShare(uv) * p.open) + lampsOn(p);
    if (BLADE_SHADOWS && CASTING_LIGHTS && frame.sunLight.w > 0.0) {
        sunned = vec4(sun * (1.0 - share), p.density);
        maskAt = maskPoint(p.fromRoot, p.facing, frame.sunDirection.xyz, species.mask.xy).xy;
    } else {
        rest += sun * p.open;
    }
    lit = vec4(rest, share);
    if (FOG) lit.rgb = mix(lit.rgb, horizonColor(p.position.xz), share);
}

void main() {
    Blade b = bladeHere();
    Stand s = standHere(b);
    lit = vec4(0.0);
    sunned = vec4(0.0);
    maskAt = vec2(0.0);
    strip = vec3(0.0);
    grain = 0u;
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // dropped: behind the near plane
    if (!exists(s)) return;

    float lighter;
    BladePose pose = poseHere(b, s, lighter);
    BladeFrame f = bladeFrameFacing(pose.control, pose.tip, pose.facing, s.v);
    vec3 fromRoot = f.position + f.side * (s.across * b.place.z * frame.mode.w);
    vec3 position = s.root + fromRoot;
    vec3 n = dot(f.normal, position) > 0.0 ? -f.normal : f.normal;  // the side that faces the eye
    lightBlade(Lit(colorHere(b, s.v, lighter, s.uv), n, unitOr(-position, 1e-6, n), position, fromRoot, pose.facing, mix(species.rootColor.w, 1.0, s.v), s.density), s.uv);
    if (viewMode() == VIEW_NORMALS) lit.rgb = n * 0.5 + 0.5;
    strip = vec3(s.across + 0.5, s.v, s.opacity);
    grain = floatBitsToUint(b.facing.z);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
