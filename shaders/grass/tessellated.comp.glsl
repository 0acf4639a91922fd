// Blades as vertices of strips, ready to be drawn: one invocation a blade poses it, chooses its level, and writes and lights its rows.
// A cell's blades have as many rows as the greatest level among them; rows beyond a blade's own lie on its tip. Plain triangles, in
// cells that have none but those (FAR), are three vertices. Light is taken in the middle of a row, for both its ends.
#include "lib/tess.glsl"
#include "lib/tess_cells.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = SSBO_VERTICES) writeonly buffer VertexBlock { uint words[]; };

// Words of a vertex: clip position (4); light, as halves (2); across, along, opacity (1); grain (1); where blades shade blades,
// what the sun adds, as halves (2), and where in the mask (1).
const uint kWords = BLADE_SHADOWS && CASTING_LIGHTS ? 11u : 8u;

void place(uint vertex, vec4 at) {
    uint w = vertex * kWords;
    words[w] = floatBitsToUint(at.x);
    words[w + 1u] = floatBitsToUint(at.y);
    words[w + 2u] = floatBitsToUint(at.z);
    words[w + 3u] = floatBitsToUint(at.w);
}
void look(uint vertex, BladeLight l, vec4 strip, uint grain) {
    uint w = vertex * kWords + 4u;
    vec4 lit = min(l.lit, vec4(kBrightest)), sunned = min(l.sunned, vec4(kBrightest));
    words[w] = packHalf2x16(lit.xy);
    words[w + 1u] = packHalf2x16(lit.zw);
    words[w + 2u] = packUnorm4x8(strip);
    words[w + 3u] = grain;
    if (kWords == 8u) return;
    words[w + 4u] = packHalf2x16(sunned.xy);
    words[w + 5u] = packHalf2x16(sunned.zw);
    words[w + 6u] = packHalf2x16(l.maskAt);
}

const vec4 kDropped = vec4(0.0, 0.0, 2.0, 1.0);  // behind the near plane

BladeLight rowLight(TessBlade t, float v, out vec3 middle) {
    BladeFrame f = bladeFrameFacing(t.pose.control, t.pose.tip, t.pose.facing, v);
    vec3 shown;
    middle = t.root + f.position;
    return lightPoint(t, f.position, f.normal, v, shown);
}

// Three vertices: both ends of the root, and the tip.
void writeTriangle(TessBlade t, uint vertex) {
    if (t.level == 0) {
        for (uint i = 0u; i < 3u; ++i) place(vertex + i, kDropped);
        return;
    }
    vec3 middle, end = vec3(-t.pose.facing.y, 0.0, t.pose.facing.x) * (0.5 * t.width);
    BladeLight root = rowLight(t, 0.0, middle);
    for (uint i = 0u; i < 2u; ++i) {
        place(vertex + i, frame.viewProj * vec4(i == 0u ? middle - end : middle + end, 1.0));
        look(vertex + i, root, vec4(0.0, 0.0, t.opacity, 1.0), t.grain);
    }
    BladeLight tip = rowLight(t, 1.0, middle);
    place(vertex + 2u, frame.viewProj * vec4(middle, 1.0));
    look(vertex + 2u, tip, vec4(0.0, 1.0, t.opacity, 1.0), t.grain);
}

void writeStrip(TessBlade t, uint vertex, int rows) {
    vec3 side = vec3(-t.pose.facing.y, 0.0, t.pose.facing.x) * (0.5 * t.width);
    for (int row = 0; row <= rows; ++row) {
        uint at = vertex + 2u * uint(row);
        if (t.level == 0) {
            place(at, kDropped);
            place(at + 1u, kDropped);
            continue;
        }
        float v = float(min(row, t.level)) / float(t.level);
        vec3 middle, end = t.plain ? side * (1.0 - v) : side;
        BladeLight l = rowLight(t, v, middle);
        for (uint i = 0u; i < 2u; ++i) {
            place(at + i, frame.viewProj * vec4(i == 0u ? middle - end : middle + end, 1.0));
            look(at + i, l, vec4(float(i), v, t.opacity, t.plain ? 1.0 : 0.0), t.grain);
        }
    }
}

void main() {
    uint slot = work.z + gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x;
    if (slot >= work.w) return;
    TessCell c = cells[cellOf(slot)];
    uint own = slot - c.slot;
    TessBlade t = tessBlade(c, c.first + own);
    if (FAR) writeTriangle(t, c.vertex + 3u * own);
    else writeStrip(t, c.vertex + 2u * (c.level + 1u) * own, int(c.level));
}
