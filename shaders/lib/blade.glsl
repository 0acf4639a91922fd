// Blades: whether one exists where it stands (density, distance), how it is posed (mirror, paint, clumps, wind,
// forces). No fragment shaders. Needs, of the cell that it stands in: ivec2 cell; vec2 cellCorner (relative to the
// eye); vec2 mirror, shift (numerics/population.h, CellVersion), as strip.glsl or tess.glsl declare them; const bool
// TERRAIN_HEIGHTS, GRASS_CLUMPS and those of cover.glsl, wind.glsl, force.glsl; frame.glsl, heights.glsl, cover.glsl;
// numerics basics, hash, bilinear, lod, opacity, blade, clump, population.
#include "lib/wind.glsl"
#include "lib/force.glsl"
#include "shared/grass.h"
layout(std430, binding = SSBO_BLADES) readonly buffer BladeBlock { Blade blades[]; };
layout(std140, binding = UBO_SPECIES) uniform SpeciesBlock { SpeciesGlobals species; };
// Where a vertex's blade stands.
struct Stand {
    vec2 inCell, ground, uv;  // its root in the cell, relative to the terrain's corner (m), and on maps (mapPlace)
    vec3 root;                // relative to the eye
    float v, across;          // along the blade, 0 to 1; across it, -1/2 or 1/2
    float density, opacity;
};

float density(vec2 uv) {
    if (!GRASS_DENSITY) return 1.0;
    ivec2 size = textureSize(densityMap[0], 0);
    float tiling = cover.species[species.index].tiling;
    BilinearTap t;
    if (tiling > 0.0)
        t = bilinearTapRepeat(uv.x * tiling, uv.y * tiling, size.x, size.y);
    else
        t = bilinearTap(uv.x, uv.y, size.x, size.y);
    return bilinearMix(texelFetch(densityMap[0], ivec2(t.x0, t.y0), 0).r,
                       texelFetch(densityMap[0], ivec2(t.x1, t.y0), 0).r,
                       texelFetch(densityMap[0], ivec2(t.x0, t.y1), 0).r,
                       texelFetch(densityMap[0], ivec2(t.x1, t.y1), 0).r, t.fx, t.fy);
}

Stand standAt(Blade b, float v, float across) {
    Stand s;
    s.v = v;
    s.across = across;
    s.inCell = rootInCell(b.root, mirror, shift, species.cellSize);
    s.ground = vec2(cell) * species.cellSize + s.inCell;
    s.uv = mapPlace(s.ground);
    s.root = vec3(cellCorner.x + s.inCell.x, groundHeight(s.ground), cellCorner.y + s.inCell.y);
    s.density = density(s.uv);
    float weight = lodRamp(length(s.root), cover.minGeom, cover.geomInv);
    s.opacity = geometryOpacity(s.density, weight, b.threshold, species.fade);
    return s;
}
bool exists(Stand s) {
    vec2 share = s.ground * frame.terrainShare;
    return s.opacity > 0.0 && share.x <= 1.0 && share.y <= 1.0;
}

// Lean and scale that the place adds to the patch's blade. Where blades are pressed down none stands in another's
// light: the density by which they shade each other falls with the press.
BladePose poseHere(Blade b, inout Stand s, out float lighter) {
    vec3 clump = vec3(0.0);
    if (GRASS_CLUMPS && species.clumpSize > 0.0)
        clump = clumpValues(cell.x, cell.y, s.inCell, species.cellSize, species.clumpSize, species.seed);
    BladePlace p = bladePlace(paintedLean(s.uv), species.leanAtFull, clump,
                              vec3(species.clumpLean, species.clumpHeight, species.clumpLightness));
    if (WIND) p.lean += windLeanAt(s.root.xz, b.dither, cover.species[species.index].gusts);
    if (FORCES || FORCE_MAP) {
        vec3 pressed = forceHere(s.root.xz, s.uv);
        p.lean = forcedLean(p.lean, pressed.xy, pressed.z, b.facing * mirror);
        s.density *= 1.0 - pressed.z;
    }
    if (GRASS_HEIGHTS) p.scale *= bladeShare(s.uv);
    lighter = p.lighter;
    return poseBlade(b.control, b.tip, b.facing, mirror, p.lean, p.scale);
}
