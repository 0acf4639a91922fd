// The light that a field of grass stands in, and how its blades take it: what means of its blades and of its slices'
// images are told (grass/appearance.h, grass/image_light.h). Does not: find it (grass/slice_gains.cpp).
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "grass/among.h"
#include "grass/slice_settings.h"
#include "grass/traced.h"

namespace sward {

// How a species' blades shade each other, made by grass/mask. Texture 0: they do not.
struct BladeShade {
    GLuint texture = 0;
    float radius = 0, top = 0;  // of the mask's cylinder, metres
    float reach = 0;            // how far from a blade stands what shades it, metres
    int layers = 1;             // of the mask
    std::vector<float> rows;    // mean of the mask's rows at density 1, layer by layer, each from the ground up
};

// The light that a field stands in.
struct FieldLight {
    glm::vec3 sky, ground;                                // as FrameGlobals
    std::vector<std::pair<glm::vec3, glm::vec3>> suns;    // towards the light (unit), colour
    float roughness = 0.5f, gloss = 0, translucency = 0;  // of the leaves
    const TracedLight* traced = nullptr;                  // light from blade to blade; null: none
    const BladeShade* shade = nullptr;  // how blades shade blades in direct light; null: depth below the tips does
    std::vector<Among> among;           // what else stands among its blades; empty where these do not shade each other
    LightWeighting weighting = LightWeighting::Cosine;  // how slices weigh their images
    float density = 1;                                  // of the field there
    bool painted = false;                               // whether its density is: gains of thin grass are wanted
    float lean = 0;          // that paint or wind gives, m per m: where their change is taken; 0: neither is there
    bool tinted = false;     // whether its colour is painted
    bool pressed = false;    // whether something may press blades down
    bool lampsCast = false;  // whether lamps do, so that blades shade blades in their light
};

}  // namespace sward
