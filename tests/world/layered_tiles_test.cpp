// Layers over colours and amounts: what lies over what, and what is said where it cannot.
#include "world/layered_tiles.h"

#include "core/numerics.h"
#include "scene/ground_path.h"
#include "tests/rows.h"
#include "tests/world/layered.h"

namespace sward {
namespace {

using namespace test;

constexpr glm::vec3 kSand{0.54f, 0.39f, 0.19f};

const Map& ground(const Project& p) { return findGround(p).terrain->terrainMap.map; }
MapLayer colourLayer(const std::string& name, std::vector<MapMask> masks) {
    MapLayer layer = ruleLayer(name, std::move(masks), LayerOperation::Replace);
    layer.map = "Terrain.terrainMap";
    return layer;
}
// Sand below 1 m, fading over half a metre.
MapLayer sand() { return colourLayer("sand", {maskBy(MaskBy::Height, -1000, 1, 0.5f)}); }
MapLayers& layGround(Project& p, std::vector<MapLayer> layers) {
    return put(p, "ground", MapLayers{std::move(layers)});
}
glm::vec4 texel(const Map& map, double x, double z) {
    return {at(map, x, z), map.sample(x / 20, z / 20, 1), map.sample(x / 20, z / 20, 2), map.sample(x / 20, z / 20, 3)};
}
// sRGB of a linear colour, to a step of eight bits.
void expectColour(const glm::vec4& texel, const glm::vec3& linear, float opacity) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(texel[c], f32::srgbEncode(linear[c]), 0.6f / 255) << c;
    EXPECT_NEAR(texel.w, opacity, 0.6f / 255);
}
// A colour map of 256 x 256 texels, all of one colour in sRGB and its opacity.
MapField colours(const glm::vec4& all) {
    Map map({256, 256, 4, PixelType::U8});
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (int c = 0; c < 4; ++c) map.set(x, y, c, all[c]);
    return field(std::move(map), "maps/ground.png");
}

TEST(LayeredTiles, SandBelowOneMetreIsLaidWhereNobodyPainted) {
    Project p = rampLawn(20);
    layGround(p, {sand()});
    MapStacks stacks;
    const Project& shown = stacks.shown(p, rows());
    expectColour(texel(ground(shown), 5, 5), kSand, 1);
    EXPECT_EQ(texel(ground(shown), 18, 5).w, 0) << "2.9 m high";
    const double half = 10 + 1.25 / std::tan(glm::radians(20.0));  // 1.25 m high
    EXPECT_NEAR(texel(ground(shown), half, 5).w, 0.5f, 0.03f);
    expectColour(texel(ground(shown), 18, 5), kSand, 0);  // filters find no black at its edge
    EXPECT_FALSE(terrain(p).terrainMap.present()) << "nothing was painted";
    EXPECT_TRUE(stacks.notes().empty());
}

TEST(LayeredTiles, AColourLiesOverThePaintedOneAndLeavesIt) {
    Project p = rampLawn(20);
    const glm::vec4 moss(0.2f, 0.4f, 0.2f, 0.6f);
    terrain(p).terrainMap = colours(moss);
    const Map before = terrain(p).terrainMap.map;
    MapLayers& layers = layGround(p, {sand()});
    layers.layers[0].opacity = 0.5f;
    const std::optional<Project> shown = withLayers(p, rows());
    const float under = 0.6f * 0.5f, opacity = under + 0.5f;
    const glm::vec3 light(f32::srgbDecode(0.2f), f32::srgbDecode(0.4f), f32::srgbDecode(0.2f));
    expectColour(texel(ground(*shown), 5, 5), (0.5f * kSand + under * light) / opacity, opacity);
    expectColour(texel(ground(*shown), 18, 5), light, 0.6f);
    EXPECT_TRUE(terrain(p).terrainMap.map.sameTiles(before));
    layers.layers[0].muted = true;
    EXPECT_FALSE(withLayers(p, rows()));
}

TEST(LayeredTiles, OrderDecidesWhichColourIsSeen) {
    Project p = rampLawn(20);
    MapLayer rock = colourLayer("rock", {});  // everywhere
    rock.color = {0.2f, 0.2f, 0.2f};
    layGround(p, {rock, sand()});
    expectColour(texel(ground(*withLayers(p, rows())), 5, 5), kSand, 1);
    expectColour(texel(ground(*withLayers(p, rows())), 18, 5), rock.color, 1);
    layGround(p, {sand(), rock});
    expectColour(texel(ground(*withLayers(p, rows())), 5, 5), rock.color, 1);
}

TEST(LayeredTiles, TakeAwayOpacityAndLeaveColours) {
    struct Row {
        LayerOperation operation;
        float expected;  // of an opacity of 0.8 below and 0.3
    };
    for (const Row& row : {Row{LayerOperation::Multiply, 0.24f}, Row{LayerOperation::Subtract, 0.5f},
                           Row{LayerOperation::Minimum, 0.3f}}) {
        Project p = rampLawn(0);
        terrain(p).terrainMap = colours({0.2f, 0.4f, 0.2f, 0.8f});
        MapLayer less = colourLayer("less", {});
        less.kind = LayerKind::Painted;
        less.operation = row.operation;
        less.amounts = field(filled({256, 256, 1, PixelType::U16}, 0.3f), "maps/less.png");
        MapLayers& layers = layGround(p, {less});
        EXPECT_NEAR(texel(ground(*withLayers(p, rows())), 3, 3).w, row.expected, 1 / 255.f)
            << kLayerOperations[row.operation];
        EXPECT_NEAR(texel(ground(*withLayers(p, rows())), 3, 3).y, 0.4f, 1 / 255.f);
        layers.layers[0].opacity = 0.5f;
        EXPECT_NEAR(texel(ground(*withLayers(p, rows())), 3, 3).w, (0.8f + row.expected) / 2, 1 / 255.f);
    }
}

TEST(LayeredTiles, PathsAndPicturesLayColoursToo) {
    Project p = rampLawn(0);
    put(p, "way", GroundPath{.points = {{"a", {2, 10}}, {"b", {18, 10}}}, .width = 2, .falloff = 0});
    MapLayer along = colourLayer("along", {});
    along.kind = LayerKind::Path, along.path = "way", along.color = {0.1f, 0.1f, 0.3f};
    MapLayer picture = colourLayer("picture", {});
    picture.kind = LayerKind::Image;
    picture.amounts = field(Map({2, 1, 1, PixelType::U8}), "maps/picture.png");
    picture.amounts.map.set(1, 0, 0, 1);
    layGround(p, {picture, along});
    const std::optional<Project> shown = withLayers(p, rows());
    expectColour(texel(ground(*shown), 10, 10.5), along.color, 1);
    expectColour(texel(ground(*shown), 18, 3), kSand, 1);
    EXPECT_EQ(texel(ground(*shown), 2, 3).w, 0);
}

TEST(LayeredTiles, LieOverTheBladesColours) {
    Project p = rampLawn(20);
    MapLayer dry = ruleLayer("dry", {maskBy(MaskBy::Height, 1, kInf)}, LayerOperation::Replace);
    dry.map = "GrassField.vegetation";
    lay(p, {dry});
    const std::optional<Project> shown = withLayers(p, rows());
    const Map& vegetation = shown->registry.get<GrassField>(findEntity(*shown, "grass"))->vegetation.map;
    expectColour(texel(vegetation, 18, 5), kSand, 1);
    EXPECT_EQ(texel(vegetation, 5, 5).w, 0);
}

TEST(LayeredTiles, AreEvaluatedWhereSomethingChangedAlone) {
    Project p = rampLawn(20);
    terrain(p).terrainMap = colours({0.2f, 0.4f, 0.2f, 0.6f});
    MapLayers& layers = layGround(p, {sand()});
    MapStacks stacks;
    stacks.shown(p, rows());
    EXPECT_EQ(stacks.evaluatedTiles(), 8u) << "four of the rule and four of the map";
    stacks.shown(p, rows());
    EXPECT_EQ(stacks.evaluatedTiles(), 0u);
    terrain(p).terrainMap.map.set(10, 10, 3, 0);
    stacks.shown(p, rows());
    EXPECT_EQ(stacks.evaluatedTiles(), 1u);
    layers.layers[0].color = {0, 0, 1};
    expectColour(texel(ground(stacks.shown(p, rows())), 5, 5), {0, 0, 1}, 1);
    EXPECT_EQ(stacks.evaluatedTiles(), 4u) << "another colour is laid anew";
    EXPECT_EQ(ground(stacks.shown(p, rows())).hash(), ground(*withLayers(p, rows())).hash());
}

TEST(LayeredTiles, SayWhatCannotBe) {
    struct Said {
        const char* what;
        void (*change)(Project&, MapLayer&);
        const char* message;
        bool skipped;
    };
    const Said kSaid[] = {
        {"add", [](Project&, MapLayer& l) { l.operation = LayerOperation::Add; }, "lays its own by replace", true},
        {"maximum", [](Project&, MapLayer& l) { l.operation = LayerOperation::Maximum; }, "choose one of them", true},
        {"repeats", [](Project& p, MapLayer&) { terrain(p).terrainMapTiling = 2; }, "repeats, and layers lie", true},
        {"channels",
         [](Project& p, MapLayer&) {
             terrain(p).terrainMap = field(filled({64, 64, 1, PixelType::U8}, 1), "maps/grey.png");
         },
         "ground.Terrain.terrainMap has 1 channels, not 4", true},
        {"nowhere", [](Project&, MapLayer& l) { l.masks[0].from = 500, l.masks[0].to = 600; },
         "it is 0 everywhere and changes nothing", false},
        {"hides all",
         [](Project&, MapLayer& l) {
             l.masks[0].from = 500, l.masks[0].to = 600;
             l.operation = LayerOperation::Multiply;
         },
         "hides all of the map", false},
    };
    for (const Said& row : kSaid) {
        Project p = rampLawn(20);
        MapLayer layer = sand();
        row.change(p, layer);
        layGround(p, {layer});
        MapStacks stacks;
        stacks.shown(p, rows());
        ASSERT_EQ(stacks.notes().size(), 1u) << row.what;
        EXPECT_EQ(stacks.notes()[0].layer, "ground.MapLayers.layers[sand]");
        EXPECT_NE(stacks.notes()[0].message.find(row.message), std::string::npos) << stacks.notes()[0].message;
        EXPECT_EQ(stacks.notes()[0].skipped, row.skipped) << row.what;
    }
}

TEST(LayeredTiles, KindsAreAmountsAndColours) {
    EXPECT_TRUE(layeredKind(MapKind::Amounts) && layeredKind(MapKind::Colours));
    EXPECT_FALSE(layeredKind(MapKind::Directions) || layeredKind(MapKind::Forces) || layeredKind(MapKind::Heights));
}

}  // namespace
}  // namespace sward
