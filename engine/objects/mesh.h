// Objects: every StaticMesh whose file can be read, lit by sun, sky and lamps, in the haze.
// One vertex buffer a file, however many entities show it; what the view does not touch is not drawn, but may cast
// shadows. Does not: read glTF (mesh/mesh_io.h), shade (objects/shadow.h). Cost: one draw for each material of each
// file.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "objects/mesh" (techniques.cpp): runs in scenes with Objects.
const EffectRow& meshEffect();
}  // namespace sward
