// Why each thing runs: a plan told to people (text) or programs (JSON, in the shape of the README's "explain").
#pragma once
#include <string>

#include "frame/plan.h"
#include "gpu/gpu.h"
#include "scene/project.h"

namespace sward {
std::string explainPlan(const FramePlan& plan, const Project& project, const Tables& tables, const Gpu& gpu, bool json);
}  // namespace sward
