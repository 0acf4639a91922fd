// Flights over a small wood across each transition of a forest's volumes: from meshes, held against meshes, as blades
// are in a hybrid; among volumes, against the traced truth beside other trees of the same forest. Nothing may pop, nor
// stand still. Shared by tests (a few pictures) and bench (300).
#pragma once
#include <string>

#include "cost/transitions.h"
#include "scene/forest.h"
#include "tests/grass/comparison.h"

namespace sward::test {

struct Flight {
    const char* name;
    glm::dvec3 from, target, way;  // way: metres a frame, of both
};
// Over a wood of 100 m: ground comes to be seen at more than 60 degrees, where slices no longer face the eye; slabs
// join by pairs from afar.
inline constexpr Flight kFlights[] = {
    {"facing slices to level ones", {50, 120, 130}, {50, 5, 60}, {0, 0, -0.5}},
    {"slabs to pairs of them", {0, 90, 250}, {0, 5, 50}, {0.7, 0.5, 1}},
};
// Trees become volumes at 90 m.
inline constexpr Flight kToVolumes{"meshes to volumes", {50, 25, 145}, {50, 5, 50}, {0, 0, -0.05}};
inline constexpr float kVolumesFrom = 90;
inline Project smallWood() {
    Project p;
    Terrain ground;
    ground.size = {100, 100};
    give(p, "ground", ground);
    Forest f;
    f.species[0].kind = TreeKind::Broadleaf;
    f.species[0].leaves = 400;
    give(p, "trees", f);
    give(p, "sun", Light{});
    give(p, "sky", Sky{});
    give(p, "haze", Fog{});
    return p;
}
// The changes of all tiles over so many frames to which meshes are drawn up to a distance.
inline TileChanges flown(Renderer& r, Project& p, const Flight& f, float meshesTo, int frames) {
    p.registry.get<Forest>(findEntity(p, "trees"))->meshesTo = meshesTo;
    return flight(r, p, {f.from, f.target, 40, 0}, f.way, frames, sized(160, 112));
}
// As trees become volumes, against all of them as meshes with all leaves, which flicker alike. Those are lit through
// the air of the volumes, as near ones are.
inline Restless flightToVolumes(Renderer& r, int frames) {
    Project p = smallWood();
    p.registry.get<Forest>(findEntity(p, "trees"))->meshDetail = 1e6f;
    const TileChanges volumes = flown(r, p, kToVolumes, kVolumesFrom, frames),
                      meshes = flown(r, p, kToVolumes, 1e5f, frames);
    return restless(volumes, meshes);
}

// A flight as it is seen, and one of which every picture shows the first one: it must not pass.
struct Flown {
    Transitions seen, frozen;
    static double popping(const Transitions& t) { return t.drawn.mean / t.floor.mean; }  // of other trees'
};
// A flight of 300 pictures, or its first ones, by volumes alone.
inline Result<Flown> flight(Renderer& renderer, const Tables& tables, const Flight& f, int pictures) {
    constexpr int kAll = 300;
    Project p = smallWood();
    p.registry.get<Forest>(findEntity(p, "trees"))->meshesTo = 0;
    const glm::dvec3 far = f.way * double(kAll - 1);
    give(p, "flight", CameraPath{{{"from", 0, f.from, f.target, 40}, {"to", 1, f.from + far, f.target + far, 40}}, 0});
    TransitionPlan plan;
    plan.path = "flight", plan.pictures = pictures;
    plan.width = 160, plan.height = 112, plan.samples = 32;
    plan.to = (pictures - 1.0) / (kAll - 1);
    auto walk = beginWalk(p, tables, plan);
    if (!walk) return walk.error();
    while (!isDrawn(**walk))
        if (Status s = drawNextOf(**walk, renderer); !s) return s.error();
    JobControl control;
    while (!isTraced(**walk))
        if (Status s = traceNextOf(**walk, tables, control); !s) return s.error();
    auto seen = judgeWalk(**walk);
    if (!seen) return seen.error();
    std::fill((*walk)->drawn.begin(), (*walk)->drawn.end(), Picture((*walk)->drawn.front()));
    auto frozen = judgeWalk(**walk);
    if (!frozen) return frozen.error();
    return Flown{std::move(*seen), std::move(*frozen)};
}

}  // namespace sward::test
