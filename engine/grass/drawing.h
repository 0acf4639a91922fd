// How a field's blades and their images are drawn, whatever its technique: part-covered pixels, who chooses cells, and
// how blades shade each other and the ground. Does not: say where which of them are drawn; the techniques' settings do.
// Source: Boulanger, Pattanaik and Bouatouch 2006, sections 3.2, 3.5 and 4.2.
#pragma once
#include "core/enum_names.h"
#include "scene/components.h"
#include "scene/rows.h"

namespace sward {

// How part-covered pixels are drawn (section 4.2, figure 21).
enum class Transparency { Coverage, Both, Test, Blend };
inline constexpr auto kTransparencies = enumNames<Transparency>("coverage", "both", "test", "blend");
// Whether layers let through what was drawn before them, so that what is farther comes first.
inline bool blends(Transparency t) { return t == Transparency::Both || t == Transparency::Blend; }
// Who chooses the cells of which blades are drawn: the CPU; the GPU, from the quadtree's nodes; whichever is the faster
// of them here.
enum class Culling { Auto, Cpu, Gpu };
inline constexpr auto kCullings = enumNames<Culling>("auto", "cpu", "gpu");

struct GrassDrawing {
    Transparency transparency = Transparency::Coverage;
    Culling culling = Culling::Auto;
    float fade = 0.4f;          // omega: half the width of the opacity ramp over density; 0: a step
    int shadowMask = 64;        // texels around a blade of what shades it (section 3.5); 0: blades do not shade blades
    bool groundShadows = true;  // blades shade the ground
    // How blades light each other: by their shadow mask and the depth below the tips alone; or by factors of light that
    // was traced through the species' blades.
    BakeLight bakeLight = BakeLight::Traced;
};

// The field table of GrassDrawing.
ComponentRow grassDrawingRow();

}  // namespace sward
