// Triangular tiles of forest that fit together however they are laid (Decaudin and Neyret 2004, section 7), and how
// foliage of leaves in all directions is lit.
// The lattice: vertex (i, j) lies at edge * (i + j/2, j * sqrt(3)/2); its cell has two triangles, `up` with the corners
// (i, j), (i+1, j), (i, j+1) and `down` with (i+1, j+1), (i, j+1), (i+1, j). Each edge has one of two colours. Edges
// come in three families: along rows, H; from (i, j) to (i, j+1), S; from (i+1, j) to (i, j+1), D.

#ifndef __cplusplus
#include "numerics/glsl.h"
#include "numerics/hash.h"
#endif

// Colours of a triangle's edges, 0 or 1.
struct EdgeColors {
    int row;     // H
    int slant;   // S
    int across;  // D
};

// A vertex's bits, as many as colours (a power of two) have. Colours of edges are differences of these; the paper draws
// each edge's, for which half of all triangles have none of its eight tiles (measured: 0.499).
FN int latticeBits(int i, int j, uint seed, int colors) { return int(cellHash(i, j, seed)) & (colors - 1); }

// Colours around a triangle of cell (i, j). With the column's parity on the two slanted families the differences of all
// three are 0 in triangles that point up and 1 in the others: two colours make the paper's eight tiles fit everywhere,
// four make 32 tiles do.
FN EdgeColors edgeColors(int i, int j, bool up, uint seed, int colors) {
    int right = latticeBits(i + 1, j, seed, colors);
    int above = latticeBits(i, j + 1, seed, colors);
    EdgeColors c;
    c.across = right ^ above ^ (i & 1);
    if (up) {
        int corner = latticeBits(i, j, seed, colors);
        c.row = corner ^ right;
        c.slant = corner ^ above ^ (i & 1);
    } else {
        int corner = latticeBits(i + 1, j + 1, seed, colors);
        c.row = above ^ corner;
        c.slant = right ^ corner ^ ((i + 1) & 1);
    }
    return c;
}

// The tiles lie in 2 x 2 cells that repeat, or in 4 x 4, so that hardware wraps them. In cell (x, y) of these the edges
// have the colours S = y, D = x ^ (y without its last bit), and H = x ^ (y & 1) below and the other one above: each of
// the eight triplets once, or of the 32. The cell that holds the tile of these colours, be it up or down:
FN vec2 tileCell(EdgeColors c) { return vec2(real(c.across ^ (c.slant & ~1)), real(c.slant)); }

// Lattice coordinates of a place (x, z; metres) and back.
FN vec2 toLattice(vec2 place, real edge) {
    real v = place.y / (edge * real(0.8660254037844386));
    return vec2(place.x / edge - real(0.5) * v, v);
}
FN vec2 fromLattice(vec2 uv, real edge) {
    return vec2(edge * (uv.x + real(0.5) * uv.y), edge * real(0.8660254037844386) * uv.y);
}

// Share of the light from one side that leaves lying in all directions send back to the eye, against a white surface
// that faces the light: the mean over what the eye sees of them (Lambert's law over a sphere of normals, as of
// a matt ball). cosine: between the ways to the light and to the eye. 2/3 where the eye looks with the light, 0 against
// it.
FN real foliagePhase(real cosine) {
    real c = clamp(cosine, real(-1.0), real(1.0));
    real s = sqrt(max(1.0f - c * c, real(0.0)));
    // The angle by its half, which keeps its digits where the cosine has lost them.
    real angle = real(2.0) * atan(sqrt(max(1.0f - c, real(0.0))), sqrt(max(1.0f + c, real(0.0))));
    return real(0.2122065907891938) * (s + (real(3.141592653589793) - angle) * c);
}

// Light (irradiance divided by pi) that the leaves around throw on a place among them, of all orders. Light that falls
// on a leaf is scattered by the share `scatter` and meets another leaf with the probability p = 1 - open, again and
// again, so that p scatter / (1 - p scatter) of it comes back (photon recollision: Knyazikhin et al. 1998; Smolander
// and Stenberg, "Simple parameterizations of the radiation budget of uniform broadleaved and coniferous canopies",
// 2005). sun: what faces it here receives; above, below: what level ground and a ceiling do; all divided by pi, past
// the leaves. A leaf in the mean of all directions has half its outline towards the sun. open: share of all directions
// free of leaves.
FN vec3 lightFromLeaves(vec3 scatter, vec3 sun, vec3 above, vec3 below, real open) {
    real p = 1.0f - clamp(open, real(0.0), real(1.0));
    vec3 met = sun * real(0.25) + (above + below) * real(0.5);
    return vec3(p * scatter.x / (1.0f - p * scatter.x) * met.x, p * scatter.y / (1.0f - p * scatter.y) * met.y,
                p * scatter.z / (1.0f - p * scatter.z) * met.z);
}
