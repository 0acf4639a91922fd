// Objects come into a project's folder whole, under names of their own, or not at all.
#include "model/assets.h"

#include <gtest/gtest.h>

#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "support.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

std::string glb(float size) {
    Solid box;
    box.size = glm::vec3(size);
    return *encodeGlb(makeMesh({&box, 1}));
}

class Assets : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(project);
        fs::create_directories(desktop);
    }
    test::TempDir dir;
    fs::path project = dir / "p", desktop = dir / "desktop";
};

TEST_F(Assets, AGlbIsCopiedOnceAndAnotherOfItsNameBesideIt) {
    test::writeText(desktop / "bench.glb", glb(1));
    EXPECT_EQ(*importAsset(project, desktop / "bench.glb"), "models/bench.glb");
    EXPECT_EQ(*importAsset(project, desktop / "bench.glb"), "models/bench.glb") << "the same bytes";
    test::writeText(desktop / "bench.glb", glb(2));
    EXPECT_EQ(*importAsset(project, desktop / "bench.glb"), "models/bench-2.glb");
    EXPECT_EQ(projectAssets(project), (std::vector<std::string>{"models/bench-2.glb", "models/bench.glb"}));
    EXPECT_EQ(*importAsset(project, project / "models/bench.glb"), "models/bench.glb") << "it is there already";
    EXPECT_EQ(projectAssets(project).size(), 2u);
}

TEST_F(Assets, AGltfBringsWhatItRefersTo) {
    std::string numbers(36, '\0');
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::memcpy(numbers.data(), corners, sizeof corners);
    test::writeText(desktop / "data" / "leaf.bin", numbers);
    test::writeText(desktop / "leaf.gltf", R"({"asset": {"version": "2.0"},
        "buffers": [{"byteLength": 36, "uri": "data/leaf.bin"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0})");
    const auto asset = importAsset(project, desktop / "leaf.gltf");
    ASSERT_TRUE(asset) << asset.error().text();
    EXPECT_EQ(*asset, "models/leaf/leaf.gltf");
    EXPECT_TRUE(readMesh(project, *asset));
    EXPECT_TRUE(fs::exists(project / "models/leaf/data/leaf.bin"));
}

TEST_F(Assets, WhatIsNoObjectIsRefusedWithTheReasonAndNothingIsCopied) {
    test::writeText(desktop / "photo.png", "no object");
    test::writeText(desktop / "broken.glb", "glTF?");
    for (const char* name : {"photo.png", "broken.glb", "none.glb"}) {
        const auto asset = importAsset(project, desktop / name);
        ASSERT_FALSE(asset) << name;
        EXPECT_NE(asset.error().text().find(name), std::string::npos) << asset.error().text();
    }
    EXPECT_NE(importAsset(project, desktop / "photo.png").error().text().find("glTF"), std::string::npos);
    EXPECT_FALSE(fs::exists(project / "models"));
    EXPECT_TRUE(projectAssets(project).empty());
}

}  // namespace
}  // namespace sward
