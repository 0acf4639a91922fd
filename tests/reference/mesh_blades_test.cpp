// The grass on meshes as rays meet it: how much of it there is, where it stands, and what it refuses.
#include "reference/mesh_blades.h"

#include <gtest/gtest.h>

#include "fields.h"
#include "grass/mesh_grass_settings.h"
#include "objects.h"

namespace sward::test {
namespace {

// A field that grows on the entity "rock" alone.
Project rockWith(const TempDir& dir, const Solid& solid, float bladesPerM2 = 4000) {
    Project p = lawn();
    p.dir = dir.path;
    FlatField f = flatField(p);
    f.grows.onTerrain = false;
    f.cellSize = 0.25f;
    f.species[0].bladesPerM2 = bladesPerM2, f.species[0].height = 0.05f, f.species[0].width = 0.004f;
    f.species[0].clumpSize = 0;
    putObject(p, "rock", {solid}, {10, 2, 10});
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->onGround = false;
    put<MeshGrass>(p, "rock");
    return p;
}
const Solid kBall{.kind = SolidKind::Ball, .size = {0.5f, 0.5f, 0.5f}, .unwrap = true};

Result<MeshBlades> bladesOf(const Project& p) {
    JobControl control;
    return MeshBlades::make(p, 0, control);
}
size_t countOf(const Project& p) {
    const auto blades = bladesOf(p);
    EXPECT_TRUE(blades) << blades.error().text();
    return blades ? blades->count() : 0;
}

TEST(MeshBlades, AreAsManyAsTheAreaAndTheDensityCallFor) {
    const TempDir dir;
    Project p = rockWith(dir, kBall);
    const double area = 4 * 3.14159265 * 0.25 * 0.99;  // less what the triangles cut off
    const double all = static_cast<double>(countOf(p));
    EXPECT_NEAR(all / (4000 * area), 1, 0.02);
    put(p, "rock", MeshGrass{.density = field(filled({8, 8, 1, PixelType::U8}, 0.4f))});
    EXPECT_NEAR(static_cast<double>(countOf(p)) / all, 0.4, 0.01);
    put(p, "rock", MeshGrass{.density = field(filled({8, 8, 1, PixelType::U8}, 0))});
    EXPECT_EQ(countOf(p), 0u);
    // Twice as large: four times the blades, by the metres that it has then.
    put<MeshGrass>(p, "rock");
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->scale = 2;
    EXPECT_NEAR(static_cast<double>(countOf(p)) / all, 4, 0.05);
    // A unit of texture coordinates that is half as long holds a quarter of the patch's blades.
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->scale = 1;
    const Mesh mesh = makeMesh({&kBall, 1});
    put(p, "rock", MeshGrass{.uvLength = static_cast<float>(0.5 * lengthOfUv(carrierOf(mesh)))});
    EXPECT_NEAR(static_cast<double>(countOf(p)) / all, 0.25, 0.01);
}

TEST(MeshBlades, StandOnTheSurfaceAndLeaveItAlongItsNormal) {
    const TempDir dir;
    Project p = rockWith(dir, kBall, 20000);
    const auto blades = bladesOf(p);
    ASSERT_TRUE(blades);
    const glm::dvec3 middle(10, 2, 10);
    int met = 0, above = 0;
    for (uint32_t i = 0; i < 4000; ++i) {
        const double a = i * 2.399963, y = 1 - 2 * (i + 0.5) / 4000, r = std::sqrt(1 - y * y);
        const glm::dvec3 out(r * std::cos(a), y, r * std::sin(a)),
            side = glm::normalize(glm::cross(out, glm::dvec3(0.3, 0.9, 0.2)));
        // Past the ball, two centimetres above it, and seven: above all blades.
        const auto past = [&](double high) {
            const glm::dvec3 from = middle + out * (0.5 + high) - side * 2.0;
            return blades->closest({from, side, 0, 4, i});
        };
        if (const auto hit = past(0.02)) {
            ++met;
            const double far = glm::length(hit->at - middle);
            EXPECT_GT(far, 0.49);
            EXPECT_LT(far, 0.57);
            EXPECT_TRUE(hit->onMesh);
            EXPECT_LE(glm::dot(glm::dvec3(hit->normal), side), 1e-6);
            EXPECT_TRUE(blades->blocks({middle + out * 0.52 - side * 2.0, side, 0, 4, i}));
        }
        above += past(0.075).has_value();
    }
    EXPECT_GT(met, 3600);
    EXPECT_EQ(above, 0);
}

TEST(MeshBlades, LeanWithTheWindAndThePaintOnTheMesh) {
    const TempDir dir;
    const Solid plate{.size = {2, 0.1f, 2}, .unwrap = true};
    // Rays straight down on the plate: leaning blades hide more of it.
    const auto hidden = [&](const Project& p) {
        const auto blades = bladesOf(p);
        EXPECT_TRUE(blades);
        int met = 0;
        for (uint32_t i = 0; i < 4000; ++i)
            met += blades->blocks({{9.2 + 1.6 * (i % 64) / 64, 4, 9.2 + 1.6 * (i / 64) / 64.0}, {0, -1, 0}, 0, 4, i});
        return met;
    };
    Project p = rockWith(dir, plate);
    Species& s = flatField(p).species[0];
    s.leanDeg = 40, s.leanVariationDeg = 0, s.bend = 0;
    const int calm = hidden(p);
    put<Wind>(p, "wind").strength = 1;
    EXPECT_GT(hidden(p), calm * 13 / 10);
    p.registry.get<Wind>(findEntity(p, "wind"))->strength = 0;
    put(p, "rock", MeshGrass{.orientation = field(filled({4, 4, 2, PixelType::U16}, 1))});
    EXPECT_GT(hidden(p), calm * 13 / 10);
}

TEST(MeshBlades, RefuseWhatCannotCarryThemAndTooMany) {
    const TempDir dir;
    const auto bare = bladesOf(rockWith(dir, {.kind = SolidKind::Ball, .size = {0.5f, 0.5f, 0.5f}}));
    ASSERT_FALSE(bare);
    EXPECT_NE(bare.error().text().find("rock.MeshGrass: rock.glb has no texture coordinates"), std::string::npos)
        << bare.error().text();
    EXPECT_EQ(bare.error().code, ExitCode::Unsound);
    Project p = rockWith(dir, kBall, 900000);
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->scale = 4;
    const auto many = bladesOf(p);
    ASSERT_FALSE(many);
    EXPECT_NE(many.error().text().find("million blades stand on meshes"), std::string::npos);
}

TEST(MeshGrass, IsOfAFieldThatIsThere) {
    const TempDir dir;
    Project p = rockWith(dir, kBall);
    EXPECT_EQ(grassyMeshes(p).size(), 1u);
    EXPECT_EQ(grassyMeshes(p).front().field, "grass");
    const auto asks = [&] { return has(sceneFeatures(p.registry, tables()), Feature::GrassOnMeshes); };
    EXPECT_TRUE(asks());
    EXPECT_FALSE(has(sceneFeatures(p.registry, tables()), Feature::GrassFar)) << "nothing grows on the terrain";
    p.registry.get<MeshGrass>(findEntity(p, "rock"))->field = "hay";
    EXPECT_TRUE(grassyMeshes(p).empty());
    EXPECT_FALSE(asks());
    EXPECT_FALSE(has(sceneFeatures(p.registry, tables()), Feature::Grass));
    std::vector<ComponentFault> faults;
    findComponent(tables().components, "MeshGrass")->check(p.registry, findEntity(p, "rock"), "rock.MeshGrass", faults);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NE(faults[0].message.find("\"hay\" is no entity with a GrassField"), std::string::npos);
    p.registry.get<MeshGrass>(findEntity(p, "rock"))->field = "grass";
    p.registry.remove<StaticMesh>(findEntity(p, "rock"));
    EXPECT_FALSE(asks());
    EXPECT_EQ(virtualBlades(p), 0) << "of the terrain's population";
}

}  // namespace
}  // namespace sward::test
