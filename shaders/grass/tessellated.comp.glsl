// Blades as vertices of strips, ready to be drawn: one invocation takes a piece of a cell, poses its blades, chooses
// their levels, and writes and lights the rows of those that cover a sample, without gaps, and the command that draws
// them. A piece's blades have as many rows as the greatest level among them; rows beyond a blade's own lie on its tip.
// Plain triangles, in pieces that have none but those, are three vertices. Light is taken in the middle of a row, for
// both its ends.
#include "lib/blade_light.glsl"
#include "lib/frame.glsl"
#include "lib/tess.glsl"
#include "lib/tess_cells.glsl"
#include "numerics/chance.h"
#include "shared/bindings.h"
#include "shared/tess.h"

const uint kVector = 8u;  // invocations that a software rasteriser runs at once: they take pieces that are neighbours
const float kSnap = 1.0 / 64.0;  // pixels by which a rasteriser may move a vertex: llvmpipe by more than 1 / 200
layout(local_size_x = LIST_GROUP) in;
layout(std430, binding = SSBO_VERTICES) writeonly buffer VertexBlock { uint words[]; };
layout(std430, binding = SSBO_COMMANDS) writeonly buffer CommandBlock {
    uint commands[];
};                                       // of strips five words, then of triangles four
layout(location = 0) uniform uvec4 job;  // in one call; by name below
uint batch = job.x;                      // its number
uint batchVertex = job.y;                // its first
uint batchPieces = job.z;                // at most
uint pieceBlades = job.w;                // at most

// Words of a vertex: clip position (4); light, as halves (2); along and opacity, as 16 bits each: coverage by chance
// turns on their last bits (1); grain, whose first two bits are across and whether it is plain (1); where blades shade
// blades, the sun's light as halves (2), how it faces the sun, as 16 bits and a half (1), and where in the
// mask, as 16 bits, 8 bits and 8 bits (1); where frames add up, metres that it moved since the frame before, as halves
// (2).
const uint kLitWords = BLADE_SHADOWS && CASTING_LIGHTS ? 12u : 8u, kWords = kLitWords + (TEMPORAL ? 2u : 0u);

void place(uint vertex, vec4 at) {
    uint w = vertex * kWords;
    words[w] = floatBitsToUint(at.x);
    words[w + 1u] = floatBitsToUint(at.y);
    words[w + 2u] = floatBitsToUint(at.z);
    words[w + 3u] = floatBitsToUint(at.w);
}
// fromRoot: of the vertex itself; only its place in the shadow mask is its own, the rest of the light the row's.
void look(uint vertex, TessBlade t, BladeLight l, vec3 fromRoot, vec3 strip) {
    uint w = vertex * kWords + 4u;
    vec4 lit = min(l.lit, vec4(kBrightest)), sunned = min(l.sunned, vec4(kBrightest));
    words[w] = packHalf2x16(lit.xy);
    words[w + 1u] = packHalf2x16(lit.zw);
    words[w + 2u] = packUnorm2x16(strip.yz);
    words[w + 3u] = t.grain | (strip.x > 0.5 ? 1u << 31 : 0u) | (t.plain ? PLAIN_BLADE : 0u);
    if (TEMPORAL) {
        vec3 moved = movedAt(t, strip.y);
        words[vertex * kWords + kLitWords] = packHalf2x16(moved.xy);
        words[vertex * kWords + kLitWords + 1u] = packHalf2x16(vec2(moved.z, 0.0));
    }
    if (kLitWords == 8u) return;
    words[w + 4u] = packHalf2x16(sunned.xy);
    words[w + 5u] = packHalf2x16(sunned.zw);
    words[w + 6u] = packSnorm2x16(vec2(l.sunward.x, 0.0)) & 0xFFFFu |
                    packHalf2x16(vec2(0.0, min(l.sunward.y, kBrightest))) & 0xFFFF0000u;
    vec3 at = t.plain ? l.maskAt : maskOf(t, fromRoot);
    words[w + 7u] =
        packSnorm2x16(vec2(at.x / MASK_TURNS, 0.0)) & 0xFFFFu | packUnorm4x8(vec4(0.0, 0.0, at.yz)) & 0xFFFF0000u;
}

// Whether a span of the picture, in pixels times samples, holds the middle of a row or column of samples. Samples of
// each pixel lie one in each of as many rows and columns by convention; other numbers of them have none to count on.
bool holdsSample(float low, float high) { return floor(high - 0.5) >= ceil(low - 0.5); }
bool samplesAreRegular(float n) { return n == 1.0 || n == 2.0 || n == 4.0 || n == 8.0; }

// Whether any sample may lie within a triangle with these corners (pixels times samples): row by row. margin: by which
// a rasteriser may move a corner. Of one sample a pixel it is exact but for that.
const float kMostRows = 24.0;
bool coversTriangle(vec2 a, vec2 b, vec2 c, float margin) {
    float low = min(min(a.y, b.y), c.y), high = max(max(a.y, b.y), c.y);
    float first = ceil(low - margin - 0.5), last = floor(high + margin - 0.5);
    if (last - first >= kMostRows) return true;
    vec2 from[3] = vec2[3](a, b, c), to[3] = vec2[3](b, c, a);
    for (float row = first; row <= last; row += 1.0) {
        float y = clamp(row + 0.5, low, high), left = 1e9, right = -1e9;
        for (int i = 0; i < 3; ++i) {
            vec2 p = from[i], end = to[i], way = end - p;
            if ((y - p.y) * (y - end.y) > 0.0) continue;
            float share = abs(way.y) > 1e-6 ? (y - p.y) / way.y : 0.5,
                  aside = margin * (1.0 + abs(way.x) / max(abs(way.y), 1e-6));
            float x = p.x + share * way.x;
            left = min(left, max(x - aside, min(p.x, end.x) - margin));
            right = max(right, min(x + aside, max(p.x, end.x) + margin));
        }
        if (holdsSample(left, right)) return true;
    }
    return false;
}

// Whether any sample of the picture may lie within the blade: its box on screen, widened by half its width, holds a row
// and a column of samples, and a plain triangle holds one itself.
bool covers(TessBlade t) {
    PlainBlade p = plainBlade(t.pose, t.width);
    vec3 foot = t.plain ? p.base : middleOfRow(t, 0.0), end = t.plain ? p.apex : middleOfRow(t, 1.0);
    vec4 root = frame.viewProj * vec4(t.root + foot, 1.0), tip = frame.viewProj * vec4(t.root + end, 1.0);
    vec4 control = t.plain ? root : frame.viewProj * vec4(t.root + t.pose.control, 1.0);
    float width = t.plain ? p.width : t.width;
    float nearest = min(min(root.w, tip.w), control.w);
    if (!(nearest > tess.near)) return true;
    vec2 a = root.xy / root.w, b = tip.xy / tip.w, c = control.xy / control.w;
    float margin = 0.5 * width * tess.pixelsPerMetre / nearest + kSnap;
    vec2 low = (min(min(a, b), c) * 0.5 + 0.5) * frame.pixels - margin,
         high = (max(max(a, b), c) * 0.5 + 0.5) * frame.pixels + margin;
    if (any(lessThan(high, vec2(0.0))) || any(greaterThan(low, frame.pixels))) return false;
    float n = float(frame.samples);
    if (!samplesAreRegular(n)) return true;
    if (!holdsSample(n * low.x, n * high.x) || !holdsSample(n * low.y, n * high.y)) return false;
    if (!t.plain) return true;
    vec4 aside = frame.viewProj * vec4(vec3(-t.pose.facing.y, 0.0, t.pose.facing.x) * (0.5 * width), 0.0);
    vec4 one = root - aside, other = root + aside;
    if (!(min(one.w, other.w) > tess.near)) return true;
    vec2 size = 0.5 * n * frame.pixels;
    return coversTriangle(size * (one.xy / one.w + 1.0), size * (other.xy / other.w + 1.0), size * (b + 1.0),
                          n * kSnap);
}

void writeVertex(uint vertex, TessBlade t, BladeLight l, vec3 fromRoot, vec3 strip) {
    place(vertex, frame.viewProj * vec4(t.root + fromRoot, 1.0));
    look(vertex, t, l, fromRoot, strip);
}

// Three vertices: both ends of the base, and the apex.
void writeTriangle(TessBlade t, uint vertex) {
    PlainBlade p = plainBlade(t.pose, t.width);
    vec3 end = vec3(-t.pose.facing.y, 0.0, t.pose.facing.x) * (0.5 * p.width);
    StraightLights lights = straightLights(t);
    BladeLight base = straightRowLight(t, lights, 0.0);
    writeVertex(vertex, t, base, p.base - end, vec3(0.0, 0.0, t.opacity));
    writeVertex(vertex + 1u, t, base, p.base + end, vec3(0.0, 0.0, t.opacity));
    writeVertex(vertex + 2u, t, straightRowLight(t, lights, 1.0), p.apex, vec3(0.0, 1.0, t.opacity));
}

void writeStrip(TessBlade t, uint vertex, int rows) {
    vec3 side = vec3(-t.pose.facing.y, 0.0, t.pose.facing.x);
    PlainBlade p = plainBlade(t.pose, t.width);
    StraightLights lights;
    if (t.level <= 1) lights = straightLights(t);
    for (int row = 0; row <= rows; ++row) {
        uint at = vertex + 2u * uint(row);
        float v = float(min(row, t.level)) / float(t.level);
        vec3 middle = t.plain ? mix(p.base, p.apex, v) : middleOfRow(t, v),
             end = side * (0.5 * (t.plain ? p.width * (1.0 - v) : t.width));
        BladeLight l;
        if (t.level > 1)
            l = bentRowLight(t, v);
        else
            l = straightRowLight(t, lights, v);
        writeVertex(at, t, l, middle - end, vec3(0.0, v, t.opacity));
        writeVertex(at + 1u, t, l, middle + end, vec3(1.0, v, t.opacity));
    }
}

// What draws `count` of a piece's blades.
void command(uint number, TessCell c, uint count) {
    uint vertex = c.vertex - batchVertex, w = c.level > 0u ? 5u * number : 5u * batchPieces + 4u * number;
    commands[w + 1u] = 1u;
    if (c.level == 0u) {
        commands[w] = 3u * count;
        commands[w + 2u] = vertex;
        return;
    }
    commands[w] = 6u * c.level * count;
    commands[w + 2u] = 3u * c.level * (c.level - 1u) * pieceBlades;
    commands[w + 3u] = vertex;
}

bool shows(TessBlade t) {
    if (!(t.level > 0 && covers(t))) return false;
    return !(ALL_OR_NOTHING && t.plain) || chanceCovers(t.opacity, t.grain, frame.chanceShift);
}

// Number of the piece that an invocation takes: vectors of neighbours, and of each group from all over the batch, so
// that groups have about as much to do.
uint pieceNumber() {
    uint vector = gl_LocalInvocationIndex / kVector * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    return vector * kVector + gl_LocalInvocationIndex % kVector;
}

void main() {
    uint number = pieceNumber(), piece = list[LIST_BATCHES + 4u * batch + 3u] + number;
    if (piece >= list[LIST_BATCHES + 4u * batch + 7u]) return;
    TessCell c = cells[piece];
    uint count = cells[piece + 1u].slot - c.slot, each = c.level == 0u ? 3u : 2u * (c.level + 1u), shown = 0u;
    for (uint i = 0u; i < count; ++i) {
        TessBlade t = tessBlade(c, c.first + i);
        if (!shows(t)) continue;
        uint vertex = c.vertex - batchVertex + each * shown;
        if (c.level == 0u)
            writeTriangle(t, vertex);
        else
            writeStrip(t, vertex, int(c.level));
        ++shown;
    }
    command(number, c, shown);
}
