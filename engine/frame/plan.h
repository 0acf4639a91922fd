// From features to what runs: the planner. Pure: no GL, no registry.
// What no feature asks for is not in the plan, so it is not ticked, not drawn, not compiled, and holds no memory.
#pragma once
#include <string>
#include <vector>

#include "scene/rows.h"

namespace sward {

// One thing that runs in a frame: of its system, its view and its pass, one is there.
struct Step {
    const EffectRow* effect = nullptr;
    const System* system = nullptr;
    const ViewRow* within = nullptr;
    const Pass* pass = nullptr;
    const char* name() const;
    const SlotUse& uses() const;
};
struct FramePlan {
    FeatureSet features;
    std::string constants;  // featureConstants(features)
    unsigned views = 0;
    bool stencil = false;                   // a pass needs one
    bool motion = false;                    // a pass follows what moves
    std::vector<const EffectRow*> effects;  // by name
    std::vector<Step> steps;                // in the order in which they run
    std::vector<const Pass*> passes() const;
    std::vector<std::string> programs() const;     // names, sorted, once each
    std::vector<std::string> systemNames() const;  // in running order
    bool operator==(const FramePlan& o) const { return features == o.features && views == o.views; }
};

// Effects whose needs the features meet, and what they run for one of the views. Systems of an effect whose passes all
// serve other views do not tick; those that tick once, and views within the view, are the main view's.
// The order follows from what steps do to slots, then from their stages, then from their names: never from the order of
// `effects`. Stops the program, with the names of those at fault, where slots ask for a circle or for a step before
// one of an earlier stage.
FramePlan planFrame(const FeatureSet& features, unsigned views, std::span<const EffectRow> effects);

// "const bool NAME = true;" or false for every feature, by what the scene has (Programs::get takes those it names).
std::string featureConstants(const FeatureSet& scene);

}  // namespace sward
