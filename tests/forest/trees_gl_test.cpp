// Trees as meshes: those nearer than meshesTo, each once, with fewer triangles farther away.
#include "forest/trees.h"

#include "scenes.h"
#include "world/forest_stand.h"

namespace sward::test {
namespace {

Project wood(float meshesTo) {
    Project p = lawn();
    removeEntity(p, "grass");
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {120, 120};
    put<Forest>(p, "trees", {.species = {{.leaves = 1500}}, .meshesTo = meshesTo, .castShadows = false});
    return p;
}
const PassStats* passNamed(const Renderer& r, const std::string& name) {
    for (const PassStats& p : r.stats().passes)
        if (p.name == name) return &p;
    return nullptr;
}
ViewSettings measured() {
    ViewSettings s = small();
    s.measure = true;
    return s;
}
const ViewCamera kAbove{{60, 160, 61}, {60, 0, 60}, 80, 0};  // sees all of the terrain

TEST(ForestTrees, AreDrawnWhereVolumesAreNot) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    for (const float to : {120.0f, 165.0f, 1000.0f}) {
        const Project p = wood(to);
        const Forest& f = *p.registry.get<Forest>(findEntity(p, "trees"));
        size_t near = 0;
        const StandingForest all = standingForest(f, findGround(p));
        for (const StandingTree& t : all.trees) near += isMesh(f, t, glm::distance(t.at, kAbove.eye));
        ASSERT_TRUE(renderer.draw(p, kAbove, measured()));
        const PassStats* pass = passNamed(renderer, "forest/trees");
        ASSERT_TRUE(pass);
        EXPECT_EQ(pass->instances, 4 * near) << "of bark and three tints, at " << to;
    }
}

TEST(ForestTrees, TakeFewerTrianglesFarAway) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    const Project p = wood(std::numeric_limits<float>::infinity());
    const auto verticesATree = [&](double height) {
        EXPECT_TRUE(renderer.draw(p, {{60, height, 61}, {60, 0, 60}, 100, 0}, measured()));
        const PassStats* pass = passNamed(renderer, "forest/trees");
        return static_cast<double>(pass->vertices) / static_cast<double>(pass->instances);
    };
    const double near = verticesATree(16), far = verticesATree(150);
    EXPECT_LT(far, 0.6 * near) << "bark stays as it is";
}

}  // namespace
}  // namespace sward::test
