// Shows a painted map as a translucent colour over whatever stands on the terrain, seen from above: amounts from violet
// (0) to yellow (1), directions as hues with arrows, forces as hues that are darker where they press, with arrows,
// colours as themselves. Over painted forces it shows those around the eye (grass/forces.h) too, also where none are
// painted. Does not: light it, nor write depth. Nothing without a map in ViewSettings::overlay, or where that is
// absent. Cost: one full-screen fragment each pixel with two to three texel fetches.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "post/map-overlay" (techniques.cpp): runs in scenes with Terrain.
const EffectRow& mapOverlayEffect();
}  // namespace sward
