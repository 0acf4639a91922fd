// Why each thing runs: a plan told to people (text) or programs (JSON, in the shape of the README's "explain").
#pragma once
#include <string>

#include "frame/plan.h"
#include "gpu/gpu.h"
#include "gpu/program.h"
#include "scene/project.h"
#include "world/map_stacks.h"

namespace sward {
// What is explained: a plan, the project as it is shown, and what there is to know of its layers over maps.
struct Explained {
    const FramePlan& plan;
    const Project& project;
    const std::vector<LayerNote>& layerNotes;
};
// A program runs because of a feature if its effect needs it, or if its sources name it: `programs` reads them.
std::string explainPlan(const Explained& what, const Tables& tables, const Gpu& gpu, Programs& programs, bool json);
}  // namespace sward
