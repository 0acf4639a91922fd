// Effect maps of small scenes: what changes pixels, what does not, and how measuring stops.
#include "cost/effect_probe.h"

#include "scenes.h"

namespace sward::test {
namespace {

EffectRequest request() {
    EffectRequest r;
    r.camera = eyeHeight();
    r.width = 64, r.height = 48, r.msaa = 1, r.pairs = 2;
    return r;
}
Project foggy(float visibility) {
    Project p = lawn();
    p.registry.get<Fog>(findEntity(p, "haze"))->visibility = visibility;
    return p;
}
Result<EffectMap> probe(const Project& p) {
    return probeEffects(request(), p, tables(), gpu(), [](const std::string&, double) { return true; });
}
const EffectFound& foundOf(const EffectMap& map, Feature f) {
    const auto at =
        std::find_if(map.effects.begin(), map.effects.end(), [&](const EffectFound& e) { return e.feature == f; });
    EXPECT_NE(at, map.effects.end()) << featureName(f);
    return *at;
}

TEST(EffectMapDrawn, FogFarBeyondTheSceneChangesNothingAndNearFogMuch) {
    NoGlErrors errors;
    const auto far = probe(foggy(9e7f)), near = probe(foggy(20));
    ASSERT_TRUE(far) << far.error().text();
    ASSERT_TRUE(near) << near.error().text();
    const EffectFound &clear = foundOf(*far, Feature::Fog), &thick = foundOf(*near, Feature::Fog);
    EXPECT_EQ(clear.changed, 0u);
    EXPECT_LT(clear.greatest, kSeenChange);
    EXPECT_GT(thick.share, 0.3);
    EXPECT_EQ(thick.changed, static_cast<uint64_t>(std::count_if(thick.where.begin(), thick.where.end(),
                                                                 [](uint8_t c) { return c >= kSeenChange; })));
    EXPECT_DOUBLE_EQ(thick.share, static_cast<double>(thick.changed) / (64 * 48));
    EXPECT_GT(thick.greatest, 20);
    EXPECT_EQ(thick.off.at(0).told(), "haze.Fog.visibility = inf");
    EXPECT_EQ(far->noise, 0u) << "both renderers draw the same scene alike";
    for (const EffectFound& e : near->effects) {
        EXPECT_EQ(e.error, "") << featureName(e.feature);
        EXPECT_EQ(e.ms.pairs, 2) << featureName(e.feature);
        EXPECT_EQ(e.where.size(), 64u * 48);
    }
}

TEST(EffectMapDrawn, ListsWhatTheSceneAsksForAndWhatGoesWithIt) {
    NoGlErrors errors;
    Project p = lawn();
    put<Wind>(p, "wind");
    const auto map = probe(p);
    ASSERT_TRUE(map) << map.error().text();
    EXPECT_EQ(map->effects.size(), effectsOf(p, tables()).size());
    EXPECT_TRUE(has(foundOf(*map, Feature::Wind).alsoOff, Feature::Gusts));
    EXPECT_FALSE(has(foundOf(*map, Feature::Wind).alsoOff, Feature::Wind));
    EXPECT_TRUE(foundOf(*map, Feature::Gusts).alsoOff.none()) << "waves blow instead";
    EXPECT_GT(foundOf(*map, Feature::Sun).share, 0.3);
    EXPECT_EQ(map->picture.size(), 64u * 48 * 3);
}

TEST(EffectMapDrawn, StopsBetweenAnyTwoFrames) {
    NoGlErrors errors;
    const Project p = lawn();
    for (const int patience : {1, 2, 3, 5}) {
        int calls = 0;
        double last = -1;
        const auto map = probeEffects(request(), p, tables(), gpu(), [&](const std::string&, double share) {
            EXPECT_GE(share, last) << "never less";
            last = share;
            return ++calls < patience;
        });
        ASSERT_FALSE(map);
        EXPECT_EQ(map.error().code, ExitCode::Interrupted);
        EXPECT_EQ(calls, patience);
    }
}

// Without its density map this lawn has more blades than are drawn one by one: that effect says so, the others stand.
TEST(EffectMapDrawn, AnEffectThatCannotBeLeftOutSaysWhyAndTheOthersStand) {
    Project p = lawn();
    GrassField& f = *p.registry.get<GrassField>(findEntity(p, "grass"));
    f.technique = "geometry";
    f.population = Population::Unique;
    f.species[0].bladesPerM2 = 12000;
    f.species[0].density = field(filled({64, 64, 1, PixelType::U16}, 0.001f));
    const auto map = probe(p);
    ASSERT_TRUE(map) << map.error().text();
    EXPECT_NE(foundOf(*map, Feature::GrassDensity).error, "");
    EXPECT_EQ(map->effects.back().feature, Feature::GrassDensity) << "last";
    EXPECT_EQ(foundOf(*map, Feature::Fog).error, "");
}

}  // namespace
}  // namespace sward::test
