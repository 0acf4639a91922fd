// From features to what runs: the planner. Pure: no GL, no registry.
// What no feature asks for is not in the plan, so it is not ticked, not drawn, not compiled, and holds no memory.
#pragma once
#include <string>
#include <vector>

#include "scene/rows.h"

namespace sward {

struct PlannedPass {
    const EffectRow* effect;
    const Pass* pass;
};
struct FramePlan {
    FeatureSet features;
    std::string constants;  // featureConstants(features)
    unsigned views = 0;
    std::vector<const EffectRow*> effects;  // in table order
    std::vector<PlannedPass> passes;        // in drawing order
    std::vector<std::pair<const EffectRow*, const System*>> systems;
    std::vector<std::string> programs() const;     // names, sorted, once each
    std::vector<std::string> systemNames() const;  // in running order
    bool operator==(const FramePlan& o) const { return features == o.features && views == o.views; }
};

// Effects whose needs the features meet; their passes that serve one of the views, sorted by stage and, within a
// stage, writers of a resource before its readers; ties keep the table's order.
// Nothing is lit that is not seen: the ground's depth comes first, then grass from near to far, and last the ground and
// the sky, lit where they show. Grass that is blended needs what it is blended with: it comes after both. Systems of an
// effect whose passes all serve other views do not tick.
FramePlan planFrame(const FeatureSet& features, unsigned views, std::span<const EffectRow> effects);

// What a coarse view draws of a scene: blades not one by one where vertical slices stand for them, and no shadow of
// each blade.
FeatureSet coarseFeatures(FeatureSet scene);

// "const bool NAME = true;" or false for every feature, by what the scene has (Programs::get takes those it names).
std::string featureConstants(const FeatureSet& scene);

}  // namespace sward
