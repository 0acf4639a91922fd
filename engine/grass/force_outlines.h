// Forces in the shape of objects' outlines, drawn into the map around the eye (grass/forces.h), which must run too.
// Source: Jahrmann and Wimmer 2013, section 5.2. Outlines: mesh/footprint.h; formula: numerics/gust.h outlineForce.
// Does not: find outlines (world/forces.h does), nor clear the map.
// Cost: 256 KB an outline, one draw of its square a force.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "grass/force-outlines" (techniques.cpp): runs in scenes with ForceOutlines, Forces, Grass and
// Terrain.
const EffectRow& forceOutlinesEffect();
}  // namespace sward
