// Forests as a renderer keeps them: named by explain, and left out where a tree's file cannot be read.
#include "forest/stand.h"

#include "scenes.h"
#include "support.h"

namespace sward::test {
namespace {

Project wood() {
    Project p = lawn();
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {60, 60};
    put<Forest>(p, "trees", {.meshesTo = 20});
    return p;
}

TEST(ForestStandGl, ExplainNamesWhatRunsAndForWhom) {
    Renderer renderer(gpu(), tables());
    const std::string text = renderer.explain(wood(), false);
    for (const char* part : {"forest/stand", "forest/trees", "forest/texcells", "because of trees"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(ForestStandGl, OfAFileThatCannotBeReadTheOtherTreesStand) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    const TempDir dir;
    Project p = wood();
    p.dir = dir.path;
    p.registry.get<Forest>(findEntity(p, "trees"))->species.push_back({.name = "lost", .file = "none.glb", .share = 1});
    ASSERT_TRUE(renderer.draw(p, {{30, 3, -10}, {30, 4, 30}, 55, 0}, small()));
    const std::vector<uint8_t> with = renderer.readImage();
    p.registry.get<Forest>(findEntity(p, "trees"))->perHectare = 0;
    ASSERT_TRUE(renderer.draw(p, {{30, 3, -10}, {30, 4, 30}, 55, 0}, small()));
    EXPECT_NE(with, renderer.readImage());
}

}  // namespace
}  // namespace sward::test
