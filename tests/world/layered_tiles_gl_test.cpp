// Layers over colours in the pictures: those of maps that were painted so, by every technique and by the truth.
#include "reference/reference.h"
#include "tests/rows.h"
#include "tests/world/layered.h"
#include "world/layered_tiles.h"

namespace sward {
namespace {

using namespace test;

// Bare ground on the left, grass on the right; both coloured by rules, with nothing painted.
Project coloured() {
    Project p = rampLawn(15);
    Map& grass = painted(p);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 128; ++x) grass.set(x, y, 0, 0);
    MapLayer sand = ruleLayer("sand", {maskBy(MaskBy::Height, -10, 0.5f, 0.2f)}, LayerOperation::Replace);
    sand.map = "Terrain.terrainMap";
    put(p, "ground", MapLayers{{sand}});
    MapLayer dry = ruleLayer("dry", {maskBy(MaskBy::Height, 1, 100, 0.5f)}, LayerOperation::Replace);
    dry.map = "GrassField.vegetation", dry.color = {0.5f, 0.05f, 0.05f};
    lay(p, {dry});
    return p;
}
// The same without layers, its maps painted as they leave them.
Project paintedSo() {
    Project p = snapshot(*withLayers(coloured(), rows()), rows());
    p.registry.remove<MapLayers>(findEntity(p, "grass"));
    p.registry.remove<MapLayers>(findEntity(p, "ground"));
    return p;
}
Project without(const char* entity) {
    Project p = coloured();
    p.registry.remove<MapLayers>(findEntity(p, entity));
    return p;
}
Project by(Project p, const std::string& technique) {
    p.registry.get<GrassField>(findEntity(p, "grass"))->technique = technique;
    return p;
}
std::vector<uint8_t> layeredPicture(Renderer& r, const Project& p) {
    const Status drawn = r.draw(p, above(), small());
    EXPECT_TRUE(drawn) << drawn.error().text();
    return r.readImage();
}
std::vector<float> layeredTrace(const Project& p) {
    ReferenceSettings s;
    s.width = 48, s.height = 32, s.samples = 2;
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene);
    return scene->trace(above(), s, control)->color;
}

TEST(LayeredColours, AreThoseOfMapsThatWerePaintedSoByEveryTechnique) {
    const NoGlErrors none;
    for (const TechniqueRow& technique : tables().techniques) {
        Renderer a(gpu(), tables()), b(gpu(), tables());
        const std::vector<uint8_t> shown = layeredPicture(a, by(coloured(), technique.name));
        EXPECT_EQ(shown, layeredPicture(b, by(paintedSo(), technique.name))) << technique.name;
        EXPECT_NE(shown, layeredPicture(b, by(without("ground"), technique.name)))
            << technique.name << ": the sand is seen";
        EXPECT_NE(shown, layeredPicture(b, by(without("grass"), technique.name)))
            << technique.name << ": dry blades are seen";
    }
}

TEST(LayeredColours, HaveTheTruthOfMapsThatWerePaintedSo) {
    const std::vector<float> truth = layeredTrace(coloured());
    EXPECT_EQ(truth, layeredTrace(paintedSo()));
    EXPECT_NE(truth, layeredTrace(without("ground")));
    EXPECT_NE(truth, layeredTrace(without("grass")));
}

}  // namespace
}  // namespace sward
