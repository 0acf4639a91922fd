// Chooses the cells that draw blades: one invocation a cell of the nodes in view, by the formulas of grass/cells.cpp.
// Jahrmann and Wimmer 2013, section 6.1; Boulanger, Pattanaik and Bouatouch 2006, section 3.4.
#include "lib/cull.glsl"
#include "numerics/cells.h"
#include "numerics/sowing.h"
#include "numerics/tess.h"
#include "shared/bindings.h"
#include "shared/cells.h"

layout(local_size_x = 64) in;  // kNodeSide squared
layout(std430, binding = SSBO_NODES) readonly buffer NodeListBlock { NodeOfCells nodes[]; };
layout(std430, binding = SSBO_CHOSEN) writeonly buffer ChosenBlock { ChosenCell chosen[]; };
layout(std430, binding = SSBO_UP_TO) readonly buffer UpToBlock {
    uint upTo[];
};  // blades of the patch with thresholds up to k / 255
layout(std430, binding = SSBO_COUNTS) buffer CountBlock { ChosenCounts counts; };  // sums, which no order changes
layout(binding = TEX_DENSITY) uniform sampler2D densityMap;

bool visible(CellBox b, float reach) {
    bool all = true;
    for (int i = 0; i < 6; ++i) all = all && boxTouches(cull.planes[i], b, reach);
    return all;
}
bool within(CellBox b, float reach) {
    bool all = true;
    for (int i = 0; i < 6; ++i) all = all && boxWithin(cull.planes[i], b, reach);
    return all;
}

// The least and the most density in a cell.
vec2 densityIn(ivec2 cell) {
    if (!GRASS_DENSITY) return vec2(1.0);
    ivec2 size = textureSize(densityMap, 0);
    CellTexels across = cellTexels(cell.x, cull.texels.x, size.x), down = cellTexels(cell.y, cull.texels.y, size.y);
    vec2 d = vec2(texelFetch(densityMap, ivec2(across.first, down.first), 0).r);
    for (int y = down.first; y <= down.last && (d.x > 0.0 || d.y < 1.0); ++y)
        for (int x = across.first; x <= across.last; ++x) {
            float here = texelFetch(densityMap, ivec2(x, y), 0).r;
            d = vec2(min(d.x, here), max(d.y, here));
        }
    return d;
}
int quadsAt(float distance) {
    if (cull.smoothness > 0.0)
        return tessMost(cull.smoothness, distance, cull.maxDistance, cull.quadsAtOneMetre, cull.levelReach);
    return chordQuads(cull.sagittaPixels, distance, cull.mostQuads);
}

uint bitsOf(CellBox b, uint count) {
    float nearest = sqrt(boxNearest2(b));
    int quads = quadsAt(nearest);
    bool seen = cull.shadowReach > 0.0 ? visible(b, cull.reach) : true, plain = quads == 1 && nearest > cull.plainFrom;
    return count | uint(quads) << CHOSEN_LEVEL | uint(within(b, cull.reach)) << CHOSEN_WHOLE |
           uint(seen) << CHOSEN_SEEN | uint(plain) << CHOSEN_PLAIN;
}

void count(ChosenCell c) {
    if (!isSet(c, CHOSEN_SEEN) || cull.counts == 0) return;
    precise float drawn = float(bladesOf(c)) * cull.drawn;
    atomicAdd(counts.cells, 1u);
    atomicAdd(counts.blades, uint(ceil(drawn)));
}

void main() {
    NodeOfCells n = nodes[gl_WorkGroupID.x];
    CellGrid grid = cullGrid();
    ChosenCell c;
    c.cell = nodeCell(grid, n.cell.x, n.cell.y, int(gl_LocalInvocationIndex));
    c.first = c.bits = 0u;
    CellBox b = cellBox(grid, c.cell.x, c.cell.y, 1, n.heights.x, n.heights.y);
    bool inField = c.cell.x < cull.cells.x && c.cell.y < cull.cells.y;
    if (inField && boxNearest2(b) < cull.farthest2 && visible(b, cull.reach + cull.shadowReach)) {
        CellRule rule;
        rule.fade = cull.fade;
        rule.thinning.missing = cull.missing;
        rule.thinning.allTo = cull.allTo;
        rule.rangeMin = cull.rangeMin;
        rule.rangeInv = cull.rangeInv;
        rule.unspread = cull.unspread;
        rule.unstep = cull.unstep;
        vec2 d = densityIn(c.cell);
        float chance = cellChance(c.cell.x, c.cell.y, cull.sowSeed);
        CellShare share = cellShare(rule, sqrt(boxNearest2(b)), d.x, d.y, chance);
        uint first = upTo[share.low], last = upTo[share.high];
        if (d.y > 0.0 && first < last) {
            precise float drawn = float(last - first) * cull.detail;
            c.first = first;
            c.bits = bitsOf(b, uint(ceil(drawn)));
            count(c);
        }
    }
    chosen[gl_WorkGroupID.x * gl_WorkGroupSize.x + gl_LocalInvocationIndex] = c;
}
