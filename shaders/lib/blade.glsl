// Blades: whether one exists where it stands (density, distance), how it is posed (mirror, paint, clumps, wind,
// forces). No fragment shaders. Needs: const bool GRASS_CLUMPS, GRASS_DENSITY, GRASS_HEIGHTS, WIND, FORCES, FORCE_MAP,
// TEMPORAL.
#include "lib/field.glsl"
#include "lib/density.glsl"
#include "lib/force.glsl"
#include "lib/frame.glsl"
#include "lib/heights.glsl"
#include "lib/wind.glsl"
#include "numerics/bilinear.h"
#include "numerics/clump.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/population.h"
#include "numerics/sowing.h"
#include "numerics/stand.h"
#include "lib/species.glsl"
#include "shared/bindings.h"
#include "shared/grass.h"

layout(std430, binding = SSBO_BLADES) readonly buffer BladeBlock { Blade blades[]; };
// Where a vertex's blade stands.
struct Stand {
    CellInstance cell;        // in which it stands
    vec2 inCell, ground, uv;  // its root in the cell, relative to the terrain's corner (m), and on maps (mapPlace)
    vec3 root;                // relative to the eye
    float v, across;          // along the blade, 0 to 1; across it, -1/2 or 1/2
    float density, opacity;
    float threshold;  // of the blade in this cell
};

float density(vec2 uv) {
    if (!GRASS_DENSITY) return 1.0;
    ivec2 size = textureSize(densityMap, 0);
    float tiling = field.species[species.index].tiling;
    BilinearTap t;
    if (tiling > 0.0)
        t = bilinearTapRepeat(uv.x * tiling, uv.y * tiling, size.x, size.y);
    else
        t = bilinearTap(uv.x, uv.y, size.x, size.y);
    return bilinearMix(texelFetch(densityMap, ivec2(t.x0, t.y0), 0).r, texelFetch(densityMap, ivec2(t.x1, t.y0), 0).r,
                       texelFetch(densityMap, ivec2(t.x0, t.y1), 0).r, texelFetch(densityMap, ivec2(t.x1, t.y1), 0).r,
                       t.fx, t.fy);
}

// The blade's threshold in its cell.
float thresholdHere(ivec2 cell, float threshold) {
    if (!(species.step > 0.0)) return threshold;
    Sown s = Sown(species.spread, species.step, species.sownShare);
    return thresholdIn(threshold, s, cellChance(cell.x, cell.y, species.sowSeed));
}

Stand standAt(CellInstance cell, Blade b, float v, float across) {
    Stand s;
    s.cell = cell;
    s.v = v;
    s.across = across;
    s.inCell = rootInCell(b.root, cell.mirror, cell.shift, species.cellSize);
    s.ground = vec2(cell.cell) * species.cellSize + s.inCell;
    s.uv = mapPlace(s.ground);
    s.root = vec3(cell.corner.x + s.inCell.x, groundHeight(s.ground), cell.corner.y + s.inCell.y);
    s.density = density(s.uv);
    float weight = lodRamp(length(s.root), field.minGeom, field.geomInv);
    s.threshold = thresholdHere(cell.cell, b.threshold);
    s.opacity = geometryOpacity(s.density, weight, s.threshold, species.fade);
    return s;
}
bool exists(Stand s) {
    vec2 share = s.ground * frame.terrainShare;
    return s.opacity > 0.0 && share.x <= 1.0 && share.y <= 1.0;
}

// What the place has for the blade.
BladeStand standOf(Blade b, Stand s) {
    BladeStand p = emptyStand();
    p.paint = paintedLean(s.uv);
    p.leanAtFull = species.leanAtFull;
    if (GRASS_CLUMPS && species.clumpSize > 0.0)
        p.clump =
            clumpValues(s.cell.cell.x, s.cell.cell.y, s.inCell, species.cellSize, species.clumpSize, species.seed);
    p.clumpLean = species.clumpLean;
    p.clumpHeight = species.clumpHeight;
    p.clumpLightness = species.clumpLightness;
    if (WIND) p.wind = windLeanAt(s.root.xz, b.dither, field.species[species.index].gusts);
    if (FORCES || FORCE_MAP) {
        vec3 force = forceHere(s.root.xz, s.uv);
        p.push = force.xy;
        p.press = force.z;
    }
    p.tall = bladeShare(s.uv);
    return p;
}

// The patch's blade as it stands here. Blades that are pressed down do not stand in each other's light: the density by
// which they shade each other falls with the press (those that lie: numerics/lying.h). lighter: factor of its colour.
BladePose poseHere(Blade b, inout Stand s, out float lighter) {
    BladeStand p = standOf(b, s);
    BladeLean l = leanOf(p, b.facing * s.cell.mirror);
    s.density *= 1.0 - p.press;
    lighter = l.lighter;
    return poseBlade(b.control, b.tip, b.facing, s.cell.mirror, l.lean, l.scale);
}
// The pose that it had here in the frame before: by the wind of then.
BladePose poseBefore(Blade b, Stand s) {
    BladeStand p = standOf(b, s);
    if (WIND) p.wind = windLeanBefore(s.root.xz, b.dither, field.species[species.index].gusts);
    BladeLean l = leanOf(p, b.facing * s.cell.mirror);
    return poseBlade(b.control, b.tip, b.facing, s.cell.mirror, l.lean, l.scale);
}
