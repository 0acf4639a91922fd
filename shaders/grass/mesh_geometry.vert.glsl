// One vertex of one blade that stands on an object: posed in the axes of the surface at its root as it would be on
// level ground, and lit there (lib/on_mesh.glsl). Boulanger, Pattanaik and Bouatouch 2006, sections 3.1-3.5.
#include "lib/blade.glsl"
#include "lib/blade_light.glsl"
#include "lib/field.glsl"
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/object_light.glsl"
#include "lib/on_mesh.glsl"
#include "lib/wind.glsl"
#include "numerics/basics.h"
#include "numerics/blade.h"
#include "numerics/clump.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/population.h"
#include "numerics/shadow.h"
#include "numerics/stand.h"
#include "shared/bindings.h"
#include "shared/grass.h"

layout(std430, binding = SSBO_CELLS) readonly buffer RootBlock { MeshBladeRoot roots[]; };
layout(location = 4) uniform float uvLength;        // metres that one unit of texture coordinates is
layout(location = 5) uniform int quads;             // of strips
layout(location = 6) uniform float pixelsPerMetre;  // at one metre
layout(location = 10) uniform vec4 rows[3];         // from the mesh to positions relative to the eye
layout(location = 13) uniform float scale;          // metres that the mesh's unit is
layout(location = 14) uniform uint firstLight;      // number of the mesh's first vertex

// As grass/geometry.vert.glsl has them.
centroid out vec4 lit;
centroid out vec4 sunned;
centroid out vec2 sunward;
centroid out vec3 maskAt;
centroid out vec3 strip;
flat out uint grain;
out vec3 moved;

vec3 turned(vec3 v) { return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v)) / scale; }

// The surface's axes at the root, in the world: columns tangent, normal, bitangent.
mat3 axesOf(MeshBladeRoot r) {
    vec4 q = normalize(vec4(unpackSnorm2x16(r.turn.x), unpackSnorm2x16(r.turn.y)));
    vec3 t = vec3(1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.z * q.w), 2.0 * (q.x * q.z - q.y * q.w)),
         n = vec3(2.0 * (q.x * q.y - q.z * q.w), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.x * q.w));
    vec3 b = cross(t, n) * ((r.blade & MIRRORED_ROOT) != 0u ? -1.0 : 1.0);
    return mat3(turned(t), turned(n), turned(b));
}

// What the place has for the blade, without the wind.
BladeStand standOn(MeshBladeRoot r, vec2 inCell) {
    BladeStand s = emptyStand();
    if (GRASS_ORIENTATION) {
        vec2 texel = textureLod(orientationMap, r.uv, 0.0).rg;
        s.paint = paintOf(texel.x, texel.y);
    }
    s.leanAtFull = species.leanAtFull;
    if (GRASS_CLUMPS && species.clumpSize > 0.0)
        s.clump = clumpValues(r.cell.x, r.cell.y, inCell, species.cellSize, species.clumpSize, species.seed);
    s.clumpLean = species.clumpLean;
    s.clumpHeight = species.clumpHeight;
    s.clumpLightness = species.clumpLightness;
    return s;
}
vec2 leantBy(vec2 blown, mat3 toField) { return (toField * vec3(blown.x, 0.0, blown.y)).xz; }

vec3 aroundAt(uvec4 corners) {
    vec2 weights = unpackUnorm2x16(corners.w);
    return objectLightAt(firstLight, corners.x) * weights.x + objectLightAt(firstLight, corners.y) * weights.y +
           objectLightAt(firstLight, corners.z) * (1.0 - weights.x - weights.y);
}

OnMesh onMeshAt(mat3 axes, vec3 foot, vec3 bend, vec3 around) {
    OnMesh on;
    on.toField = transpose(axes);
    on.normal = axes[1];
    on.around = around;
    on.foot = foot;
    on.uvLength = uvLength;
    on.sun = on.toField * frame.sunDirection;
    on.sunBend = max(bendTo(bend, on.sun, 4.0 / max(species.maskHeight, 1e-4)), 0.0);
    // Most leaves stand in the lower half of the mask's height: what lies higher keeps little light off.
    on.sunOver = sunOverLevel(on.sun, on.sunBend, 0.5 * species.maskHeight);
    return on;
}

void main() {
    int own = 2 * (species.segments + 1), corner = gl_VertexID % own;
    MeshBladeRoot r = roots[gl_VertexID / own];
    Blade b = blades[r.blade & ~MIRRORED_ROOT];
    float v = float(corner / 2) / float(quads), across = float(corner & 1) - 0.5;
    lit = vec4(0.0);
    sunned = vec4(0.0);
    sunward = vec2(0.0);
    maskAt = vec3(0.0);
    strip = vec3(0.0);
    grain = 0u;
    moved = vec3(0.0);
    gl_Position =
        vec4(0.0, 0.0, 0.5, 1.0);  // dropped: no area. Not beyond a plane: then software clips the whole batch
    vec4 at = vec4(r.position, 1.0);
    vec3 foot = vec3(dot(rows[0], at), dot(rows[1], at), dot(rows[2], at));
    vec2 bendAndDensity = unpackHalf2x16(r.bend.y);
    float opacity = geometryOpacity(bendAndDensity.y, lodRamp(length(foot), field.minGeom, field.geomInv),
                                    thresholdHere(r.cell, b.threshold), species.fade);
    // Blades narrower than half a pixel: one stands for several.
    float wider = shadowWidening(shadowsOfOne(b.width, length(foot) / pixelsPerMetre),
                                 shadowChance(floatBitsToUint(b.dither), r.cell.x, r.cell.y));
    if (!(opacity > 0.0 && wider > 0.0)) return;

    mat3 axes = axesOf(r);
    OnMesh on = onMeshAt(axes, foot, vec3(unpackHalf2x16(r.bend.x), bendAndDensity.x) / scale, aroundAt(r.corners));
    CellVersion version = cellVersion(r.cell.x, r.cell.y, species.seed);
    BladeStand stand = standOn(r, rootInCell(b.root, version.mirror, version.shift, species.cellSize));
    float gusts = field.species[species.index].gusts;
    stand.wind = leantBy(windLeanAt(foot.xz, b.dither, gusts), on.toField);
    BladeLean lean = leanOf(stand, b.facing * version.mirror);
    BladePose pose = poseBlade(b.control, b.tip, b.facing, version.mirror, lean.lean, lean.scale);
    float lacked = middleLacked(quads);
    float width = b.width * wider * frame.widening;
    BladeFrame f = bladeFrameFacing(pose.control, pose.tip, pose.facing, v);
    vec3 fromRoot = f.position + f.side * (across * width);
    vec3 position = foot + axes * fromRoot, toEye = on.toField * -position;
    vec3 n = dot(f.normal, toEye) < 0.0 ? -f.normal : f.normal;  // the side that faces the eye
    BladeLight light = lightOnMesh(
        on,
        Lit(bladeColor(b.hue, b.lightness * lean.lighter, v, lacked, r.uv), n, unitOr(toEye, 1e-6, n), position,
            fromRoot, b.dither, pose.upright, vec2(0.0), mix(species.rootOpen, 1.0, v), bendAndDensity.y, 1.0, 1.0),
        r.uv);
    lit = light.lit, sunned = light.sunned, sunward = light.sunward, maskAt = light.maskAt;
    // The sun's shade is looked up as high as the curve lies in the mean.
    maskAt.y += overChords(pose, quads).y / max(species.maskHeight, 1e-4);
    if (viewMode() == VIEW_NORMALS) lit.rgb = axes * n * 0.5 + 0.5;
    strip = vec3(across + 0.5, v, opacity);
    grain = floatBitsToUint(b.dither);
    if (TEMPORAL) {
        stand.wind = leantBy(windLeanBefore(foot.xz, b.dither, gusts), on.toField);
        BladeLean was = leanOf(stand, b.facing * version.mirror);
        BladePose before = poseBlade(b.control, b.tip, b.facing, version.mirror, was.lean, was.scale);
        BladeFrame g = bladeFrameFacing(before.control, before.tip, before.facing, v);
        moved = axes * (fromRoot - (g.position + g.side * (across * width)));
    }
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
