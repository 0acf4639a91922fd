// Blades as indexed strips, instanced by cell: which blade a vertex belongs to (gl_VertexID), and where it is on it.
// Vertex shaders only. Needs: what blade.glsl needs.
layout(location = 0) in ivec2 cell;
layout(location = 1) in vec2 cellCorner;  // relative to the eye
layout(location = 2) in vec2 mirror;      // of the cell's version of the patch (numerics/population.h)
layout(location = 3) in vec2 shift;
#include "lib/blade.glsl"

Blade bladeHere() { return blades[gl_VertexID / (2 * (species.segments + 1))]; }
Stand standHere(Blade b) {
    int corner = gl_VertexID % (2 * (species.segments + 1));
    return standAt(b, float(corner / 2) / float(species.segments), float(corner & 1) - 0.5);
}
