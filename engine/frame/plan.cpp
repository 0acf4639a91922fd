#include "frame/plan.h"

#include <map>
#include <set>
#include <tuple>

namespace sward {
namespace {

// Three groups of stages: the scene, what is blended with it, and what is made of the picture.
int groupOf(const Step& s, const FeatureSet& scene) {
    if (!s.pass) return 0;
    return s.pass->stage >= Stage::Water ? 2 : (scene & s.pass->blendedWith).any() ? 1 : 0;
}
Stage stageOf(const Step& s) {
    return s.pass ? s.pass->stage : s.within ? Stage::Within : s.system->once ? Stage::Once : Stage::View;
}

// A step on its way into the plan.
struct Waiting {
    Step step;
    int group;
    Stage stage;
    std::string_view name;
    auto key() const { return std::tie(group, stage, name); }
};

[[noreturn]] void stopAtCircle(const std::vector<Waiting>& left) {
    std::string names;
    for (const Waiting& a : left)
        for (const Waiting& b : left)
            if (const SlotSet s = handedOver(a.step.uses(), b.step.uses()); s.any() && a.name != b.name)
                names += fmt::format("\n  {} before {} ({})", a.name, b.name, slotNames(s));
    checkFailed(__FILE__, __LINE__, "steps that wait for each other:" + names);
}

// What comes first by its key must not wait for what comes later.
void checkStages(const std::vector<Waiting>& sorted) {
    for (size_t i = 1; i < sorted.size(); ++i) {
        const Waiting &a = sorted[i - 1], &b = sorted[i];
        if (std::tie(b.group, b.stage) < std::tie(a.group, a.stage))
            checkFailed(__FILE__, __LINE__,
                        fmt::format("{} waits for a slot that a later stage makes; {} runs before it", b.name, a.name));
    }
}

// Takes, again and again, of those that wait for nothing left the first by its key.
std::vector<Step> inOrder(std::vector<Waiting> left) {
    std::sort(left.begin(), left.end(), [](const Waiting& a, const Waiting& b) { return a.key() < b.key(); });
    std::vector<Waiting> sorted;
    while (!left.empty()) {
        const auto next = std::find_if(left.begin(), left.end(), [&](const Waiting& w) {
            return std::none_of(left.begin(), left.end(), [&](const Waiting& other) {
                return &other != &w && handedOver(other.step.uses(), w.step.uses()).any();
            });
        });
        if (next == left.end()) stopAtCircle(left);
        sorted.push_back(*next);
        left.erase(next);
    }
    checkStages(sorted);
    std::vector<Step> steps;
    for (const Waiting& w : sorted) steps.push_back(w.step);
    return steps;
}

// What an effect runs for the views.
std::vector<Step> stepsOf(const EffectRow& effect, unsigned views) {
    std::vector<Step> steps;
    for (const Pass& pass : effect.passes)
        if (pass.views & views) steps.push_back({.effect = &effect, .pass = &pass});
    const bool served = effect.passes.empty() || !steps.empty(), main = views & kViewMain;
    for (const System& system : effect.systems)
        if (served && (main || !system.once)) steps.push_back({.effect = &effect, .system = &system});
    if (effect.within && main) steps.push_back({.effect = &effect, .within = effect.within});
    return steps;
}

}  // namespace

const char* Step::name() const { return pass ? pass->name : system ? system->name : effect->name; }
const SlotUse& Step::uses() const { return pass ? pass->uses : system ? system->uses : within->uses; }

FramePlan planFrame(const FeatureSet& features, unsigned views, std::span<const EffectRow> effects) {
    FramePlan plan;
    plan.features = features;
    plan.constants = featureConstants(features);
    plan.views = views;
    std::vector<Waiting> steps;
    for (const EffectRow& effect : effects) {
        if ((features & effect.needs) != effect.needs) continue;
        plan.effects.push_back(&effect);
        for (const Step& s : stepsOf(effect, views)) steps.push_back({s, groupOf(s, features), stageOf(s), s.name()});
    }
    std::sort(plan.effects.begin(), plan.effects.end(),
              [](const EffectRow* a, const EffectRow* b) { return std::string_view(a->name) < b->name; });
    plan.steps = inOrder(std::move(steps));
    for (const Pass* p : plan.passes()) {
        plan.stencil |= p->stencil;
        plan.motion |= p->follows;
    }
    return plan;
}

std::vector<const Pass*> FramePlan::passes() const {
    std::vector<const Pass*> out;
    for (const Step& s : steps)
        if (s.pass) out.push_back(s.pass);
    return out;
}

std::vector<std::string> FramePlan::programs() const {
    std::set<std::string> names;
    for (const Pass* p : passes())
        for (const ProgramRow& program : p->programs) names.insert(program.name);
    return {names.begin(), names.end()};
}

std::vector<std::string> FramePlan::systemNames() const {
    std::vector<std::string> names;
    for (const Step& s : steps)
        if (s.system) names.push_back(s.system->name);
    return names;
}

std::string featureConstants(const FeatureSet& scene) {
    std::string out;
    for (const FeatureRow& row : featureRows())
        out += fmt::format("const bool {} = {};\n", featureConstant(row.feature), has(scene, row.feature));
    return out;
}

}  // namespace sward
