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

// What distances follow: nothing, they are metres; or what the picture shows of a blade, by its size and the eye's
// field of view.
enum class TiersBy { Metres, Pixels };
inline constexpr auto kTiersBy = enumNames<TiersBy>("metres", "pixels");

// Distances from the eye, metres.
struct HybridTiers {
    float minGeom = 4;   // blades are all there up to here ...
    float maxGeom = 12;  // ... and gone from here; infinite: never fades
    float minBTF = 25;   // vertical slices are all there up to here ...
    float maxBTF = 40;   // ... and gone from here
    MiddleTier middleTier = MiddleTier::Slices;
    TiersBy tiersBy = TiersBy::Metres;
    float bladePixels = 0.5f;  // by pixels: blades are gone where one is so wide; minGeom keeps its share of maxGeom
    float slicePixels = 2;     // by pixels: slices are gone where grass is so high; minBTF keeps its share of maxBTF
};

// A field's distances as a picture has them in which a metre, one metre away, is so many pixels wide
// (`pixelsPerMetre` of frame/renderer.h). By pixels: those that are 0 or infinite stay so, and slices end a little
// beyond blades at least.
HybridTiers tiersSeen(const FieldEntity& field, float pixelsPerMetre);
// Metres that a blade of the field is wide and high, in the mean of its species by their number; 0 of a field without.
struct BladeSize {
    float width = 0, height = 0;
};
BladeSize bladeSize(const GrassField& field);

// The field table of HybridTiers; repairs distances that are swapped or equal.
ComponentRow hybridTiersRow();
// "hybrid", and "geometry", "slices", "flat": one of its tiers everywhere.
std::span<const TechniqueRow> hybridTechniques();

}  // namespace sward
