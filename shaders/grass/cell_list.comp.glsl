// Lists the chosen cells' blades in pieces, without gaps and always in the same order: cells that lie in view as a
// whole, then those that its edge cuts, because a software rasteriser takes a slow way with batches of vertices of
// which one must be clipped. One group, by exclusive prefix sums: each invocation counts a run of cells, one sums the
// runs up, each writes its own.
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/hash.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/blade.h"
#include "numerics/population.h"
#include "numerics/tess.h"
#include "numerics/cells.h"
#include "lib/cull.glsl"
#include "shared/tess.h"
const uint kRuns = 256u;
layout(local_size_x = 256) in;
layout(std430, binding = SSBO_CHOSEN) readonly buffer ChosenBlock { ChosenCell chosen[]; };
layout(std430, binding = SSBO_CELLS) writeonly buffer TessCellBlock { TessCell cells[]; };
layout(std430, binding = SSBO_LIST) coherent buffer ListBlock { uint list[]; };
layout(location = 0) uniform uvec4 job;
layout(location = 1) uniform uint pointDraws;
uint chosenCount = job.x, batchVertices = job.y,
     batchCount = job.z;  // vertices: at most, of the pieces that begin in a batch
uint drawPoints = job.w;  // at most, of a command

// Of all before: pieces, blades, vertices.
shared uvec3 sums[2u * kRuns];
shared uint blades;  // all

uint piecesOf(ChosenCell c) { return (bladesOf(c) + cull.pieceBlades - 1u) / cull.pieceBlades; }
uint verticesOf(ChosenCell c) { return isSet(c, CHOSEN_PLAIN) ? 3u : 2u * (levelOfCell(c) + 1u); }
uvec3 sizeOf(ChosenCell c) { return uvec3(piecesOf(c), bladesOf(c), bladesOf(c) * verticesOf(c)); }

// The batch's arguments once the piece before it is known.
void beginBatch(uint batch, uint piece) { list[LIST_BATCHES + 4u * batch + 3u] = piece; }

void write(ChosenCell c, uvec3 at) {
    uint count = bladesOf(c), pieces = piecesOf(c), each = (count + pieces - 1u) / pieces;
    CellVersion v = cellVersion(c.cell.x, c.cell.y, cull.seed);
    if (cull.unique != 0) v.mirror = vec2(1.0), v.shift = vec2(0.0);
    vec2 corner = cellCorner(cullGrid(), c.cell.x, c.cell.y);
    for (uint i = 0u; i < pieces; ++i) {
        uint done = i * each, vertex = at.z + done * verticesOf(c),
             next = at.z + min(done + each, count) * verticesOf(c);
        cells[at.x + i] = TessCell(c.cell, corner, v.mirror, v.shift, c.first + done, at.y + done,
                                   isSet(c, CHOSEN_PLAIN) ? 0u : levelOfCell(c), vertex);
        for (uint b = vertex / batchVertices + 1u; b <= min(next / batchVertices, batchCount); ++b)
            beginBatch(b, at.x + i + 1u);
    }
}

void sumUp() {
    uvec3 sum = uvec3(0u);
    for (uint i = 0u; i < 2u * kRuns; ++i) {
        uvec3 run = sums[i];
        sums[i] = sum;
        sum += run;
    }
    cells[sum.x].slot = sum.y;  // which ends the last piece
    list[LIST_PIECES] = sum.x;
    blades = sum.y;
    beginBatch(0u, 0u);
    for (uint b = sum.z / batchVertices + 1u; b <= batchCount; ++b) beginBatch(b, sum.x);
}

void writeArguments(uint batch) {
    uint w = LIST_BATCHES + 4u * batch;
    list[w] = (list[w + 7u] - list[w + 3u] + LIST_GROUP - 1u) / LIST_GROUP;
    list[w + 1u] = list[w + 2u] = 1u;
}

void writePoints(uint draw) {
    uint w = LIST_BATCHES + 4u * (batchCount + 1u + draw), first = draw * drawPoints;
    list[w] = first < blades ? min(blades - first, drawPoints) : 0u;
    list[w + 1u] = 1u;
    list[w + 2u] = first;
    list[w + 3u] = 0u;
}

void main() {
    uint run = gl_LocalInvocationIndex, length = (chosenCount + kRuns - 1u) / kRuns;
    uint from = run * length, upTo = min(from + length, chosenCount);
    uvec3 whole = uvec3(0u), cut = uvec3(0u);
    for (uint i = from; i < upTo; ++i) {
        ChosenCell c = chosen[i];
        if (isSet(c, CHOSEN_WHOLE))
            whole += sizeOf(c);
        else
            cut += sizeOf(c);
    }
    sums[run] = whole;
    sums[kRuns + run] = cut;
    memoryBarrierShared();
    barrier();
    if (run == 0u) sumUp();
    memoryBarrierShared();
    barrier();
    whole = sums[run];
    cut = sums[kRuns + run];
    for (uint i = from; i < upTo; ++i) {
        ChosenCell c = chosen[i];
        if (bladesOf(c) == 0u) continue;
        bool inside = isSet(c, CHOSEN_WHOLE);
        write(c, inside ? whole : cut);
        if (inside)
            whole += sizeOf(c);
        else
            cut += sizeOf(c);
    }
    memoryBarrierBuffer();
    barrier();
    for (uint b = run; b < batchCount; b += kRuns) writeArguments(b);
    for (uint d = run; d < pointDraws; d += kRuns) writePoints(d);
}
