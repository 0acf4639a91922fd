// The technique "raytraced": rays through the vertical slices, pixel by pixel, at a cost that follows pixels instead of
// blades. Source: Habel, Wimmer and Jeschke 2007; H-1 to H-9. Does not: draw (grass/raytraced.h).
#pragma once
#include <span>

#include "core/enum_names.h"
#include "scene/technique.h"

namespace sward {

// What stands for the slices that a ray has not come to when its steps are over: what they would send in the mean; the
// next slice, as if it were opaque (the paper's filling); or nothing, so that the ground shows.
enum class RayRest { Mean, Opaque, Nothing };
inline constexpr auto kRayRests = enumNames<RayRest>("mean", "opaque", "nothing");

// How grass and what stands in it hide each other (section 3): by the depth at which a share of a ray's opacity is
// reached; or each ray ends where the scene that was drawn before it stands (the paper's "correct" way).
enum class RayVisibility { Depth, Scene };
inline constexpr auto kRayVisibilities = enumNames<RayVisibility>("depth", "scene");

struct RaytracedGrass {
    int steps = 24;  // slices that a ray crosses, at most
    float footprint =
        2;  // pixels; where slices lie nearer to each other, rays take fewer steps, in proportion; 0: never
    float cutOff = 0.98f;  // opacity at which a ray ends
    float depthAt = 0.5f;  // share of its opacity at which a ray's depth is taken
    RayRest rest = RayRest::Mean;
    RayVisibility visibility = RayVisibility::Depth;
    float maxDistance = 60;  // metres from which the horizontal slice alone is drawn; infinite: never
};

// The field table of RaytracedGrass.
ComponentRow raytracedGrassRow();
// "raytraced".
TechniqueRow raytracedTechnique();

}  // namespace sward
