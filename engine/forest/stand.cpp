#include "forest/stand.h"

#include <algorithm>

#include "core/log.h"
#include "forest/foliage.h"
#include "mesh/facing.h"
#include "world/placement.h"

namespace sward {
namespace {

std::vector<std::string> versionsOf(const Project& p, const Forest& f) {
    std::vector<std::string> out;
    for (const TreeSpecies& s : f.species) out.push_back(s.file.empty() ? "" : fileVersion(p.dir, s.file));
    return out;
}

bool standsStill(const ForestHere& h, const Forest& f, const Ground& ground) {
    return h.stand && sameForest(h.rule, f) && h.origin == ground.origin &&
           h.terrain.has_value() == (ground.terrain != nullptr) &&
           (!h.terrain || sameGround(*h.terrain, *ground.terrain));
}

void stand(ForestHere& h, const Ground& ground) {
    h.terrain = ground.terrain ? std::optional(*ground.terrain) : std::nullopt;
    h.origin = ground.origin;
    h.stand = std::make_shared<const StandingForest>(standingForest(h.rule, ground));
}

void grow(ForestHere& h, const Project& p) {
    h.meshes.clear(), h.colors.clear(), h.leaves.clear();
    for (const TreeSpecies& s : h.rule.species) {
        Result<Mesh> mesh = stands(s) ? treeMesh(p.dir, s) : Mesh{};
        if (!mesh) logWarning(mesh.error().text() + "; its trees are not drawn");
        h.meshes.push_back(mesh ? std::move(*mesh) : Mesh{});
        h.colors.push_back(leafColor(h.meshes.back())), h.leaves.push_back(leafPart(h.meshes.back()));
    }
    const ForestTiles& t = h.stand->tiles;
    if (t.placed < 0.9 * t.asked)
        logWarning(
            fmt::format("{}.Forest: {:.0f} of {:.0f} trees find room in the eight tiles (lower distance, crowns or "
                        "perHectare, or change tileSize)",
                        h.entity, t.placed, t.asked));
}

void update(ForestHere& h, const Project& p, const Ground& ground, const Forest& f, uint64_t& times) {
    std::vector<std::string> files = versionsOf(p, f);
    const bool still = standsStill(h, f, ground), grown = h.stand && sameTiles(h.rule, f) && h.files == files;
    h.rule = f;
    h.light = h.lightGlobals = 0;  // those of the last frame may be gone
    if (!still) stand(h, ground), h.stood = ++times;
    if (!grown) grow(h, p), h.grown = ++times;
    h.files = std::move(files);
    h.scatter.clear();
    for (size_t i = 0; i < h.meshes.size(); ++i) h.scatter.push_back(scatterOf(h.colors[i], f.species[i].translucency));
}

void follow(DrawContext& ctx) {
    ForestsState& state = ctx.own<ForestsState>();
    const Ground ground = findGround(ctx.project);
    std::vector<std::unique_ptr<ForestHere>> now;
    for (const auto& [entity, forest] : forestsOf(ctx.project)) {
        const auto known = std::find_if(state.all.begin(), state.all.end(),
                                        [&, &name = entity](const auto& h) { return h && h->entity == name; });
        now.push_back(known != state.all.end() ? std::move(*known) : std::make_unique<ForestHere>());
        now.back()->entity = entity;
        update(*now.back(), ctx.project, ground, *forest, state.times);
    }
    state.all = std::move(now);
    ctx.shared.forests = &state;
}

const System kSystems[] = {{"forest/stand", {.writes = {Slot::Forests}}, follow, true}};

}  // namespace

const EffectRow& forestEffect() {
    static const EffectRow row{
        "forest/stand",
        featureSet(Feature::Forest, Feature::Terrain),
        kSystems,
        {},
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<ForestsState>(); },
        "trees stand in a forest"};
    return row;
}

}  // namespace sward
