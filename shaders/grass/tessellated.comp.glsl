// Blades as vertices of strips, ready to be drawn: one invocation a blade poses it, chooses its level, and writes and lights its rows.
// A cell's blades have as many rows as the greatest level among them; rows beyond a blade's own lie on its tip. Plain triangles, in
// cells that have none but those (FAR), are three vertices. Light is taken in the middle of a row, for both its ends.
// Blades that cover no sample are not lit, and lie in a point. Strips are drawn by commands that their groups write.
#include "lib/tess.glsl"
layout(std430, binding = SSBO_CELLS) readonly buffer TessCellBlock { TessCell cells[]; };  // of this batch, and one beyond
const uint kGroup = 256u;        // as kPieceBlades in grass/tessellated.cpp
const float kSnap = 1.0 / 64.0;  // pixels by which a rasteriser may move a vertex
layout(local_size_x = 256) in;
layout(std430, binding = SSBO_VERTICES) writeonly buffer VertexBlock { uint words[]; };
layout(std430, binding = SSBO_COMMANDS) writeonly buffer CommandBlock { uint commands[]; };  // five words each

// Words of a vertex: clip position (4); light, as halves (2); along and opacity, as 16 bits each: coverage by chance turns
// on their last bits (1); grain, whose first two bits are across and whether it is plain (1); where blades shade blades,
// what the sun adds, as halves (2), and where in the mask (1).
const uint kWords = BLADE_SHADOWS && CASTING_LIGHTS ? 11u : 8u;

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
    words[w + 3u] = t.grain | (strip.x > 0.5 ? 1u << 31 : 0u) | (t.plain ? 1u << 30 : 0u);
    if (kWords == 8u) return;
    words[w + 4u] = packHalf2x16(sunned.xy);
    words[w + 5u] = packHalf2x16(sunned.zw);
    words[w + 6u] = packHalf2x16(maskOf(t, fromRoot));
}

// Whether any sample of the picture may lie within the blade: its box on screen, widened by half its width, holds a row and a column
// of samples. Rows and columns are where samples of each pixel are by convention; other numbers of them have none to count on.
bool covers(TessBlade t) {
    vec4 root = frame.viewProj * vec4(t.root, 1.0), tip = frame.viewProj * vec4(t.root + t.pose.tip, 1.0);
    vec4 control = t.plain ? root : frame.viewProj * vec4(t.root + t.pose.control, 1.0);
    float nearest = min(min(root.w, tip.w), control.w);
    if (!(nearest > tess.level.z)) return true;
    vec2 a = root.xy / root.w, b = tip.xy / tip.w, c = control.xy / control.w;
    float margin = 0.5 * t.width * tess.level.w / nearest + kSnap;
    vec2 low = (min(min(a, b), c) * 0.5 + 0.5) * frame.viewport.xy - margin, high = (max(max(a, b), c) * 0.5 + 0.5) * frame.viewport.xy + margin;
    if (any(lessThan(high, vec2(0.0))) || any(greaterThan(low, frame.viewport.xy))) return false;
    float n = frame.mode.z;
    bool regular = n == 1.0 || n == 2.0 || n == 4.0 || n == 8.0;
    return !regular || all(greaterThanEqual(floor(high * n - 0.5), ceil(low * n - 0.5)));
}

// All of a blade's vertices in one point: triangles without an area. Within the view, because a software rasteriser takes a slow way
// with every vertex of a batch of which one must be clipped.
const vec4 kDropped = vec4(0.0, 0.0, 0.5, 1.0);
void drop(uint vertex, uint count) {
    for (uint i = 0u; i < count; ++i) place(vertex + i, kDropped);
}

// middle: relative to the root.
BladeLight rowLight(TessBlade t, float v, out vec3 middle) {
    BladeFrame f = bladeFrameFacing(t.pose.control, t.pose.tip, t.pose.facing, v);
    vec3 shown;
    middle = f.position;
    return lightPoint(t, middle, f.normal, v, shown);
}
void writeVertex(uint vertex, TessBlade t, BladeLight l, vec3 fromRoot, vec3 strip) {
    place(vertex, frame.viewProj * vec4(t.root + fromRoot, 1.0));
    look(vertex, t, l, fromRoot, strip);
}

// Three vertices: both ends of the root, and the tip.
void writeTriangle(TessBlade t, uint vertex) {
    vec3 middle, end = vec3(-t.pose.facing.y, 0.0, t.pose.facing.x) * (0.5 * t.width);
    BladeLight root = rowLight(t, 0.0, middle);
    writeVertex(vertex, t, root, -end, vec3(0.0, 0.0, t.opacity));
    writeVertex(vertex + 1u, t, root, end, vec3(0.0, 0.0, t.opacity));
    BladeLight tip = rowLight(t, 1.0, middle);
    writeVertex(vertex + 2u, t, tip, middle, vec3(0.0, 1.0, t.opacity));
}

void writeStrip(TessBlade t, uint vertex, int rows) {
    vec3 side = vec3(-t.pose.facing.y, 0.0, t.pose.facing.x) * (0.5 * t.width);
    for (int row = 0; row <= rows; ++row) {
        uint at = vertex + 2u * uint(row);
        float v = float(min(row, t.level)) / float(t.level);
        vec3 middle, end = t.plain ? side * (1.0 - v) : side;
        BladeLight l = rowLight(t, v, middle);
        writeVertex(at, t, l, middle - end, vec3(0.0, v, t.opacity));
        writeVertex(at + 1u, t, l, middle + end, vec3(1.0, v, t.opacity));
    }
}

// The command that draws `count` strips of this group, of c.level quads each.
void command(TessCell c, uint count) {
    uint w = 5u * gl_WorkGroupID.x;
    commands[w] = 6u * c.level * count;
    commands[w + 1u] = 1u;
    commands[w + 2u] = 3u * c.level * (c.level - 1u) * kGroup;
    commands[w + 3u] = c.vertex;
    commands[w + 4u] = 0u;
}

// A group writes one piece of a cell. Its cell's number hangs on nothing but the group's, so that compilers load it once a group.
void main() {
    TessCell c = cells[gl_WorkGroupID.x];
    uint own = gl_LocalInvocationIndex, count = cells[gl_WorkGroupID.x + 1u].slot - c.slot, each = FAR ? 3u : 2u * (c.level + 1u);
    if (!FAR && own == 0u) command(c, count);
    if (own >= count) return;
    TessBlade t = tessBlade(c, c.first + own);
    uint vertex = c.vertex + each * own;
    if (!(t.level > 0 && covers(t))) drop(vertex, each);
    else if (FAR) writeTriangle(t, vertex);
    else writeStrip(t, vertex, int(c.level));
}
