#include "frame/plan.h"

#include <map>
#include <set>

namespace sward {
namespace {

// True if a must run before b: b reads what a writes, and not the other way round.
bool before(const Pass& a, const Pass& b) { return (a.writes & b.reads) && !(b.writes & a.reads); }

// Repeatedly takes the first pass that nothing left must precede; a cycle falls back to the table's order.
std::vector<PlannedPass> sortByUse(std::vector<PlannedPass> left) {
    std::vector<PlannedPass> out;
    while (!left.empty()) {
        auto free = std::find_if(left.begin(), left.end(), [&](const PlannedPass& p) {
            return std::none_of(left.begin(), left.end(),
                                [&](const PlannedPass& q) { return q.pass != p.pass && before(*q.pass, *p.pass); });
        });
        if (free == left.end()) free = left.begin();
        out.push_back(*free);
        left.erase(free);
    }
    return out;
}

constexpr Stage kSolid[] = {Stage::Simulate,     Stage::Bake,   Stage::Shadow, Stage::Reflect, Stage::Depth,
                            Stage::Opaque,       Stage::Blades, Stage::Slices, Stage::Rays,    Stage::Ground,
                            Stage::GroundShadow, Stage::Sky,    Stage::Water,  Stage::Post,    Stage::Overlay};
constexpr Stage kBlended[] = {Stage::Simulate, Stage::Bake,         Stage::Shadow, Stage::Reflect, Stage::Depth,
                              Stage::Ground,   Stage::GroundShadow, Stage::Opaque, Stage::Sky,     Stage::Blades,
                              Stage::Slices,   Stage::Rays,         Stage::Water,  Stage::Post,    Stage::Overlay};
static_assert(std::size(kSolid) == static_cast<size_t>(Stage::Count) && std::size(kBlended) == std::size(kSolid));

}  // namespace

FramePlan planFrame(const FeatureSet& features, unsigned views, std::span<const EffectRow> effects) {
    FramePlan plan;
    plan.features = features;
    plan.views = views;
    std::map<Stage, std::vector<PlannedPass>> stages;
    for (const EffectRow& effect : effects) {
        if ((features & effect.needs) != effect.needs) continue;
        plan.effects.push_back(&effect);
        const bool served = effect.passes.empty() || std::any_of(effect.passes.begin(), effect.passes.end(),
                                                                 [&](const Pass& p) { return p.views & views; });
        if (served)
            for (const System& system : effect.systems) plan.systems.emplace_back(&effect, &system);
        for (const Pass& pass : effect.passes)
            if (pass.views & views) stages[pass.stage].push_back({&effect, &pass});
    }
    for (const Stage stage : has(features, Feature::GrassBlended) ? kBlended : kSolid)
        for (const PlannedPass& p : sortByUse(std::move(stages[stage]))) plan.passes.push_back(p);
    return plan;
}

FeatureSet coarseFeatures(FeatureSet scene) {
    if (has(scene, Feature::GrassSlices)) scene &= ~featureSet(Feature::GrassGeometry);
    return scene & ~featureSet(Feature::GroundShadows);
}

std::vector<std::string> FramePlan::programs() const {
    std::set<std::string> names;
    for (const PlannedPass& p : passes)
        for (const ProgramRow& program : p.pass->programs) names.insert(program.name);
    return {names.begin(), names.end()};
}

std::vector<std::string> FramePlan::systemNames() const {
    std::vector<std::string> names;
    for (const auto& [effect, system] : systems) names.push_back(system->name);
    return names;
}

std::string featureConstants(const FeatureSet& declared, const FeatureSet& scene) {
    std::string out;
    for (size_t f = 0; f < declared.size(); ++f)
        if (declared.test(f))
            out += fmt::format("const bool {} = {};\n", featureConstant(static_cast<Feature>(f)), scene.test(f));
    return out;
}

}  // namespace sward
