// Layers are made on another thread: what was drawn before is a draft until then, and in the end it is the same.
#include "frame/drawn_beside.h"

#include <gtest/gtest.h>

#include <thread>

#include "project/project_files.h"
#include "scene/map_layers.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

// A density of many texels, and the rule over it that nothing grows where it is steep.
class LayersBeside : public testing::Test {
  protected:
    void SetUp() override {
        auto made = newProject(dir / "p", tables().components);
        ASSERT_TRUE(made);
        p = std::move(*made);
        map("lawn.GrassField.species[lawn].density") = uniform(0.8f);
        Map hills({512, 512, 1, PixelType::F32});
        for (int y = 0; y < 512; ++y)
            for (int x = 0; x < 512; ++x) hills.set(x, y, 0, static_cast<float>((x * 7 + y * 3) % 40) * 0.1f);
        map("ground.Terrain.height") = hills;
    }
    static Map uniform(float value) {
        constexpr int kSide = 2048;
        Map m({kSide, kSide, 1, PixelType::U16});
        for (int y = 0; y < kTileSize; ++y)
            for (int x = 0; x < kTileSize; ++x) m.set(x, y, 0, value);
        for (int ty = 0; ty < m.tilesY(); ++ty)
            for (int tx = 0; tx < m.tilesX(); ++tx) m.setTile(tx, ty, m.tile(0, 0));
        return m;
    }
    Map& map(const std::string& path) {
        auto& field = *static_cast<MapField*>(findField(p, tables().components, path)->value);
        if (field.file.empty()) field.file = "maps/some.png";
        return field.map;
    }
    static const Map& densityOf(const Project& drawn) {
        const auto f = findField(drawn, tables().components, "lawn.GrassField.species[lawn].density");
        return static_cast<const MapField*>(f->value)->map;
    }
    void addRule() {
        MapLayers layers;
        layers.layers.emplace_back();
        layers.layers[0].map = "GrassField.species[lawn].density";
        layers.layers[0].masks.emplace_back();
        p.registry.add<MapLayers>(findEntity(p, "lawn"), layers);
    }
    const Project& soon() { return beside.soon(p, tables().components); }
    // Draws until nothing is being made.
    void finish() {
        for (std::vector<JobNews> news{{}}; !news.empty();) {
            news.clear();
            beside.news(news);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            if (!news.empty() && news[0].finished) soon();
        }
    }
    test::TempDir dir;
    Project p;
    DrawnBeside beside;
};

TEST_F(LayersBeside, WithoutLayersItIsTheProjectItself) {
    EXPECT_EQ(&soon(), &p);
    EXPECT_EQ(&beside.now(p, tables().components), &p);
}

TEST_F(LayersBeside, TheMapAsPaintedIsShownUntilItsLayersAreMade) {
    addRule();
    const Map painted = densityOf(p);
    ASSERT_TRUE(densityOf(soon()).sameTiles(painted)) << "millions of texels are not made in 30 ms";
    std::vector<JobNews> news;
    beside.news(news);
    ASSERT_EQ(news.size(), 1u);
    EXPECT_EQ(news[0].label, "layers");
    finish();
    const uint64_t made = densityOf(soon()).hash();
    DrawnBeside other;
    EXPECT_EQ(densityOf(other.now(p, tables().components)).hash(), made);
    EXPECT_NE(made, painted.hash());
}

TEST_F(LayersBeside, WhatWasShownBeforeIsShownUntilTheChangeIsMade) {
    addRule();
    soon();
    finish();
    const uint64_t first = densityOf(soon()).hash();
    p.registry.get<MapLayers>(findEntity(p, "lawn"))->layers[0].invert = true;
    EXPECT_EQ(densityOf(soon()).hash(), first);
    finish();
    EXPECT_NE(densityOf(soon()).hash(), first);
    p.registry.remove<MapLayers>(findEntity(p, "lawn"));
    EXPECT_EQ(&soon(), &p);
}

// A stroke below layers is in the next picture.
TEST_F(LayersBeside, AFewTilesAreMadeAtOnce) {
    addRule();
    soon();
    finish();
    map("lawn.GrassField.species[lawn].density").set(5, 5, 0, 0.1f);
    DrawnBeside other;
    const uint64_t wanted = densityOf(other.now(p, tables().components)).hash();
    for (int i = 0; i < 20 && densityOf(soon()).hash() != wanted; ++i) finish();  // on a busy machine it may be later
    EXPECT_EQ(densityOf(soon()).hash(), wanted);
}

}  // namespace
}  // namespace sward
