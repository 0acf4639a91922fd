// The hybrid technique: blades near the eye, vertical slices of their images farther away, one horizontal slice beyond;
// and its tiers alone. Source: Boulanger, Pattanaik and Bouatouch 2006, section 4.1.
// Does not: draw; grass/geometry and grass/slices do. How its images are made: grass/slice_settings.h.
#pragma once
#include <span>

#include "core/enum_names.h"
#include "scene/technique.h"

namespace sward {

// What is drawn at middle distance: vertical slices as quads, or rays through them, pixel by pixel (grass/raytraced.h).
enum class MiddleTier { Slices, Raytraced };
inline constexpr auto kMiddleTiers = enumNames<MiddleTier>("slices", "raytraced");

// Distances from the eye, metres.
struct HybridTiers {
    float minGeom = 4;   // blades are all there up to here ...
    float maxGeom = 12;  // ... and gone from here; infinite: never fades
    float minBTF = 25;   // vertical slices are all there up to here ...
    float maxBTF = 40;   // ... and gone from here
    MiddleTier middleTier = MiddleTier::Slices;
};

// The field table of HybridTiers; repairs distances that are swapped or equal.
ComponentRow hybridTiersRow();
// "hybrid", and "geometry", "slices", "flat": one of its tiers everywhere.
std::span<const TechniqueRow> hybridTechniques();

}  // namespace sward
