// The technique "tessellated": blades one by one, each as finely as its distance asks, fewer and wider the farther they
// are. Source: Jahrmann and Wimmer 2013; J-5 to J-7. Does not: draw (grass/tessellated.h).
#pragma once
#include <span>

#include "core/enum_names.h"
#include "scene/technique.h"

namespace sward {

// By what a blade is tessellated: its distance (equation 4) or its length on screen (equation 5).
enum class LevelBy { Distance, Pixels };
inline constexpr auto kLevelsBy = enumNames<LevelBy>("distance", "pixels");
// Who tessellates: the GPU's tessellation stages; a compute pass that writes strips; whichever is the faster here.
enum class Tessellation { Auto, Stages, Strips };
inline constexpr auto kTessellations = enumNames<Tessellation>("auto", "stages", "strips");
// What is drawn where tessellated blades end: the hybrid's horizontal slice; or, as published, bare ground.
enum class Beyond { Slice, Nothing };
inline constexpr auto kBeyonds = enumNames<Beyond>("slice", "nothing");

struct TessellatedBlades {
    float maxDistance = 25;  // metres from which no blade is drawn
    LevelBy levelBy = LevelBy::Distance;
    float pixelsPerQuad = 8;  // that a quad of a blade is long, by pixels
    float thinning = 0.75f;   // share of the blades that is missing at maxDistance; linear in the distance
    float leastPixels = 0;    // where blades would be thinner on screen they are fewer, each so wide; 0: nowhere
    bool widening = true;     // those that are left are wider, so as to cover as much
    float lowerFrom = 0.8f;   // share of maxDistance from which blades get lower, to nothing at its end; 1: they do not
    Beyond beyond = Beyond::Slice;
    Tessellation tessellation = Tessellation::Auto;
};

// The field table of TessellatedBlades.
ComponentRow tessellatedBladesRow();
// "tessellated".
TechniqueRow tessellatedTechnique();

}  // namespace sward
