// Why each thing runs: a plan told to people (text) or programs (JSON, in the shape of the README's "explain").
#pragma once
#include <string>

#include "frame/plan.h"
#include "gpu/gpu.h"
#include "scene/project.h"

namespace sward {
// Ends with a line feed. Reads the project's components and the GPU's ledger; draws nothing.
std::string explainPlan(const FramePlan& plan, const Project& project, const Tables& tables, const Gpu& gpu, bool json);
}  // namespace sward
