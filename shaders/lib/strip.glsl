// Blades as indexed strips, instanced by cell: which blade a vertex belongs to (gl_VertexID), and where it is on it.
// Vertex shaders only.
layout(location = 0) in ivec2 cell;
layout(location = 1) in vec2 cellCorner;  // relative to the eye
layout(location = 2) in vec2 mirror;      // of the cell's version of the patch (numerics/population.h)
layout(location = 3) in vec2 shift;
layout(location = 4) in int quads;  // CellInstance.quads
#include "lib/blade.glsl"
#include "shared/grass.h"

CellInstance cellHere() { return CellInstance(cell, cellCorner, mirror, shift, quads, 0.0); }
Blade bladeHere() { return blades[gl_VertexID / (2 * (species.segments + 1))]; }
// quads: of the strip that is drawn, of equal height; the blade's further vertices are none of it.
Stand standHere(Blade b, int quads) {
    int corner = gl_VertexID % (2 * (species.segments + 1));
    return standAt(cellHere(), b, float(corner / 2) / float(quads), float(corner & 1) - 0.5);
}
