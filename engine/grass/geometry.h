// Grass as geometry: every blade of the near cells a strip of quads, instanced from one patch a species.
// Source: Boulanger, Pattanaik and Bouatouch 2006, sections 3.1, 3.2, 3.4 and 4.2; B-11 to B-13, B-18, B-19, B-24.
// One multi-draw a species whatever the field's size: a cell is one indirect command over a contiguous index range, or
// over those of its blades that can be seen where the driver shades vertices on the CPU (blade_list.h). Does not: what
// grows where (field.h), slices (slices.h). Cost: about 0.3 us a vertex on a software renderer.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "grass/geometry" (techniques.cpp): runs in scenes with GrassGeometry, Grass and Terrain.
const EffectRow& geometryEffect();
}  // namespace sward
