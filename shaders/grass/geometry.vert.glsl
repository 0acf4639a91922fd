// One vertex of one blade of one cell: which blade (gl_VertexID), whether it exists (density, distance), how it is posed
// (mirror, paint, clumps), how it is lit (per vertex). Boulanger, Pattanaik and Bouatouch 2006, sections 3.1-3.4.
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
#include "lib/mask.glsl"
#include "lib/cover.glsl"

struct Blade {
    vec4 place;      // root x, z; width; threshold
    vec4 control;    // w: hue
    vec4 tip;        // w: lightness
    vec4 facing;     // z: dither
};
layout(std430, binding = SSBO_BLADES) readonly buffer BladeBlock { Blade blades[]; };
layout(std140, binding = UBO_SPECIES) uniform SpeciesBlock { SpeciesGlobals species; };
layout(location = 0) in ivec2 cell;
layout(location = 1) in vec2 cellCorner;  // relative to the eye
layout(location = 2) in vec2 mirror;      // +1 or -1

// At a covered sample: blades are thinner than pixels, and from the pixel's centre their light would be extrapolated.
centroid out vec4 lit;   // radiance; w: share of it that is haze
centroid out vec4 sunned;    // radiance where the sun reaches between the neighbours; w: density. Only where blades shade blades
centroid out vec2 maskAt;    // where in their shadow mask
centroid out vec4 strip;         // across, along; opacity; dither

float density(vec2 uv) {
    if (!GRASS_DENSITY) return 1.0;
    ivec2 size = textureSize(densityMap[0], 0);
    BilinearTap t = bilinearTap(uv.x, uv.y, size.x, size.y);
    return bilinearMix(texelFetch(densityMap[0], ivec2(t.x0, t.y0), 0).r, texelFetch(densityMap[0], ivec2(t.x1, t.y0), 0).r,
                       texelFetch(densityMap[0], ivec2(t.x0, t.y1), 0).r, texelFetch(densityMap[0], ivec2(t.x1, t.y1), 0).r, t.fx, t.fy);
}

// Lean and scale that the place adds to the patch's blade.
BladePose poseHere(Blade b, vec2 mirror, vec2 rootInCell, vec2 uv, out float lighter) {
    vec2 lean = paintedLean(uv) * species.midColor.w;
    float scale = 1.0;
    lighter = 1.0;
    if (GRASS_CLUMPS && species.tipColor.w > 0.0) {
        vec3 c = clumpValues(cell.x, cell.y, rootInCell, species.clumps.w, species.tipColor.w, uint(species.counts.y));
        lean += c.xy * species.clumps.x;
        scale += c.z * species.clumps.y;
        lighter += c.z * species.clumps.z;
    }
    return poseBlade(b.control.xyz, b.tip.xyz, b.facing.xy, mirror, lean, scale);
}

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
    return leafLight(p.color, species.looks.xyz, p.normal, p.toEye, frame.sunDirection.xyz, frame.sunLight.rgb);
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
    float share = hazeShare(length(p.position));
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
    int perBlade = 2 * (int(species.counts.x) + 1);
    Blade b = blades[gl_VertexID / perBlade];
    int corner = gl_VertexID % perBlade;
    float v = float(corner / 2) / species.counts.x;
    vec2 root = mix(vec2(species.clumps.w) - b.place.xy, b.place.xy, step(vec2(0.0), mirror));
    vec2 ground = vec2(cell) * species.clumps.w + root;
    vec2 uv = ground * frame.terrain.zw;
    vec3 at = vec3(cellCorner.x + root.x, groundHeight(ground), cellCorner.y + root.y);
    float weight = lodRamp(length(at), cover.tiers.y, cover.tiers.z);
    float here = density(uv);
    float opacity = geometryOpacity(here, weight, b.place.w, species.counts.z);
    lit = vec4(0.0);
    sunned = vec4(0.0);
    maskAt = vec2(0.0);
    strip = vec4(0.0);
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // dropped: behind the near plane
    if (!(opacity > 0.0) || uv.x > 1.0 || uv.y > 1.0) return;

    float lighter;
    BladePose pose = poseHere(b, mirror, root, uv, lighter);
    BladeFrame f = bladeFrameFacing(pose.control, pose.tip, pose.facing, v);
    float across = float(corner & 1) - 0.5;
    vec3 position = at + f.position + f.side * (across * b.place.z * frame.mode.w);
    vec3 n = dot(f.normal, position) > 0.0 ? -f.normal : f.normal;  // the side that faces the eye
    lightBlade(Lit(colorHere(b, v, lighter, uv), n, unitOr(-position, 1e-6, n), position, position - at, pose.facing, mix(species.rootColor.w, 1.0, v), here), uv);
    if (viewMode() == VIEW_NORMALS) lit.rgb = n * 0.5 + 0.5;
    strip = vec4(across + 0.5, v, opacity, b.facing.z);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
