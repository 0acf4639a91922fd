// Where blades are planted on meshes: on the surface, in the cells of the texture coordinates, as the density lets
// them.
#include "grass/mesh_planting.h"

#include <gtest/gtest.h>

#include "fields.h"
#include "objects.h"
#include "reference/mesh_blades.h"
#include "scenes.h"

namespace sward::test {
namespace {

// A ball that carries a field, with what planting takes.
struct Planted {
    TempDir dir;
    Project project;
    MeshCarrier carrier;
    explicit Planted(float density = 1) : project(lawn()) {
        project.dir = dir.path;
        FlatField f = flatField(project);
        f.grows.onTerrain = false, f.cellSize = 0.25f;
        f.species[0].bladesPerM2 = 9000;
        const Solid ball{.kind = SolidKind::Ball, .size = {0.5f, 0.5f, 0.5f}, .unwrap = true};
        putObject(project, "rock", {ball}, {10, 2, 10});
        put(project, "rock", MeshGrass{.density = field(filled({8, 8, 1, PixelType::U8}, density))});
        carrier = carrierOf(makeMesh({&ball, 1}));
    }
    std::vector<MeshRoot> roots(double uvLength = 0) {
        const std::vector<GrassyMesh> on = grassyMeshes(project);
        const GrassField& grows = flatField(project).grows;
        const MeshPlanting p{carrier, on[0], grows, uvLength > 0 ? uvLength : uvLengthOf(*on[0].grows, carrier, 1)};
        const auto cells = cellsOf(p);
        EXPECT_TRUE(cells) << cells.error().text();
        const Patch patch = makePatch(grows.species[0], grows.cellSize, static_cast<uint32_t>(grows.seed));
        std::vector<MeshRoot> out;
        if (cells)
            EXPECT_TRUE(plantOn(p, *cells, grows.species[0], patch, JobControl{},
                                [&](const MeshRoot& r) { out.push_back(r); }));
        return out;
    }
};

TEST(MeshPlanting, PutsEachBladeOnTheSurfaceInItsCell) {
    Planted ball;
    const double cell = 0.25, uvLength = lengthOfUv(ball.carrier);
    const std::vector<MeshRoot> roots = ball.roots();
    ASSERT_GT(roots.size(), 20'000u);
    double farthest = 0, offPlace = 0, notUpright = 0;
    for (const MeshRoot& r : roots) {
        const double radius = glm::length(r.position);
        farthest = std::max(farthest, std::abs(radius - 0.5));
        notUpright = std::max(notUpright, 1 - glm::dot(glm::normalize(r.normal), r.position / radius));
        const glm::dvec2 at = glm::dvec2(r.cellX, r.cellZ) * cell + glm::dvec2(r.inCell);
        offPlace = std::max(offPlace, glm::length(at - glm::dvec2(r.uv) * uvLength));
        EXPECT_GE(r.density, r.sownAt);
    }
    EXPECT_LT(farthest, 0.01) << "a ball of triangles";
    EXPECT_LT(notUpright, 0.01);
    EXPECT_LT(offPlace, 1e-5);
}

TEST(MeshPlanting, PlantsAsManyAsTheTruthHasAndAsAreAskedFor) {
    for (const float density : {1.0f, 0.35f}) {
        Planted ball(density);
        const std::vector<MeshRoot> roots = ball.roots();
        const auto traced = MeshBlades::make(ball.project, 0, JobControl{});
        ASSERT_TRUE(traced);
        EXPECT_EQ(roots.size(), traced->count());
        const std::vector<GrassyMesh> on = grassyMeshes(ball.project);
        const MeshPlanting p{ball.carrier, on[0], flatField(ball.project).grows, lengthOfUv(ball.carrier)};
        EXPECT_NEAR(static_cast<double>(roots.size()) / bladesAsked(p), static_cast<double>(density), 0.01);
    }
}

TEST(MeshPlanting, RefusesTextureCoordinatesOverTooManyCells) {
    Planted ball;
    const std::vector<GrassyMesh> on = grassyMeshes(ball.project);
    const auto cells = cellsOf({ball.carrier, on[0], flatField(ball.project).grows, 1e7});
    ASSERT_FALSE(cells);
    EXPECT_NE(cells.error().text().find("rock.MeshGrass: its texture coordinates run over too many cells"),
              std::string::npos)
        << cells.error().text();
}

TEST(MeshPlanting, StopsWhenCancelled) {
    Planted ball;
    JobControl control;
    control.cancel();
    const std::vector<GrassyMesh> on = grassyMeshes(ball.project);
    const GrassField& grows = flatField(ball.project).grows;
    const MeshPlanting p{ball.carrier, on[0], grows, lengthOfUv(ball.carrier)};
    const Patch patch = makePatch(grows.species[0], grows.cellSize, static_cast<uint32_t>(grows.seed));
    const auto cells = cellsOf(p);
    ASSERT_TRUE(cells);
    size_t planted = 0;
    EXPECT_FALSE(plantOn(p, *cells, grows.species[0], patch, control, [&](const MeshRoot&) { ++planted; }));
    EXPECT_EQ(planted, 0u);
}

}  // namespace
}  // namespace sward::test
