// A new Scatter and one made into entities: one undo step each, or nothing.
#include "model/scatter_edits.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "support.h"
#include "techniques.h"
#include "world/placement.h"
#include "world/scatter.h"

namespace sward {
namespace {

class ScatterEdits : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(doc.create(dir / "p")); }
    void putMesh(const std::string& file) {
        const Solid ball{SolidKind::Ball, glm::vec3(1), glm::vec3(0)};
        test::writeText(dir / "p" / file, *encodeGlb(makeMesh({&ball, 1})));
    }
    const Scatter& rule(const std::string& name) {
        return *doc.project().registry.get<Scatter>(findEntity(doc.project(), name));
    }
    test::TempDir dir;
    Document doc{tables()};
};

TEST_F(ScatterEdits, ItScattersTheChosenMeshesElseAllOfTheProject) {
    EXPECT_FALSE(addScatter(doc, {})) << "there is no mesh";
    EXPECT_FALSE(doc.canUndo());
    putMesh("models/a.glb"), putMesh("models/b.glb");
    const auto all = addScatter(doc, {});
    ASSERT_TRUE(all);
    ASSERT_EQ(rule(*all).meshes.size(), 2u);
    EXPECT_EQ(rule(*all).meshes[1].file, "models/b.glb");
    EXPECT_EQ(rule(*all).meshes[1].name, "b");
    ASSERT_TRUE(doc.addEntity("stone"));
    ASSERT_TRUE(doc.addComponent("stone", "StaticMesh"));
    ASSERT_TRUE(doc.setField("stone.StaticMesh.file", "models/b.glb"));
    const auto one = addScatter(doc, std::vector<std::string>{"stone"});
    ASSERT_TRUE(one);
    EXPECT_EQ(*one, "scatter-2");
    ASSERT_EQ(rule(*one).meshes.size(), 1u);
    EXPECT_TRUE(doc.undo());
    EXPECT_EQ(findEntity(doc.project(), *one), kNoEntity);
}

TEST_F(ScatterEdits, ObjectsOfItStandWhereTheyStood) {
    putMesh("models/a.glb");
    const std::string name = *addScatter(doc, {});
    ASSERT_TRUE(doc.setField(name + ".Scatter.perHectare", "100"));
    ASSERT_TRUE(doc.setField(name + ".Scatter.alignToGround", "1"));
    const Scattering before = scatterOver(rule(name), findGround(doc.project()));
    const size_t steps = doc.stepsDone();
    ASSERT_FALSE(before.objects.empty());
    ASSERT_LE(before.objects.size(), kMostObjectsMade);
    const auto made = makeObjectsOf(doc, name);
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_EQ(made->size(), before.objects.size());
    EXPECT_EQ(doc.stepsDone(), steps + 1);
    EXPECT_EQ(findEntity(doc.project(), name), kNoEntity) << "it had nothing else";
    for (size_t i = 0; i < made->size(); ++i) {
        const PlacedMesh now = placeMesh(doc.project(), findEntity(doc.project(), (*made)[i]));
        EXPECT_LT(glm::distance(now.at, before.objects[i].at), 1e-9);
        EXPECT_EQ(now.mesh->scale, before.objects[i].scale);
        for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(now.turn[c], glm::dvec3(before.objects[i].turn[c])), 1e-6);
    }
    EXPECT_TRUE(doc.undo());
    EXPECT_EQ(scatterOver(rule(name), findGround(doc.project())).hash, before.hash);
}

TEST_F(ScatterEdits, TooManyOrNoneAreRefused) {
    putMesh("models/a.glb");
    const std::string name = *addScatter(doc, {});
    ASSERT_TRUE(doc.setField(name + ".Scatter.distance", "0"));
    ASSERT_TRUE(doc.setField(name + ".Scatter.perHectare", "100000"));
    const size_t entities = doc.project().entities.size(), steps = doc.stepsDone();
    EXPECT_FALSE(makeObjectsOf(doc, name));
    EXPECT_FALSE(makeObjectsOf(doc, "nobody"));
    EXPECT_EQ(doc.project().entities.size(), entities);
    EXPECT_EQ(doc.stepsDone(), steps);
    ASSERT_TRUE(doc.addComponent(name, "Transform"));
    ASSERT_TRUE(doc.setField(name + ".Scatter.perHectare", "50"));
    ASSERT_TRUE(makeObjectsOf(doc, name));
    EXPECT_NE(findEntity(doc.project(), name), kNoEntity) << "it keeps its other part";
}

}  // namespace
}  // namespace sward
