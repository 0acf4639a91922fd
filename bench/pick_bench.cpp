// What a click among many objects takes: after an edit of something else, and after one of the objects themselves.
#include <algorithm>
#include <filesystem>

#include "core/file.h"
#include "limits.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "project/project_files.h"
#include "scene/scatter.h"
#include "tools/scene_objects.h"

namespace {
using namespace sward;

std::filesystem::path folderWithBall() {
    const std::filesystem::path dir = std::filesystem::path(SWARD_BINARY_DIR) / "bench-pick";
    std::filesystem::create_directories(dir);
    const Solid ball{SolidKind::Ball, glm::vec3(0.5f), glm::vec3(0)};
    const Result<std::string> bytes = encodeGlb(makeMesh({&ball, 1}));
    CHECK(bool(bytes));
    CHECK(bool(writeFileAtomic(dir / "ball.glb", *bytes)));
    return dir;
}

// Each time another revision of the project, as after an edit; the least of many, since other work only adds.
double leastPick(SceneObjects& objects, const Project& p, uint64_t& revision, const std::function<void()>& edit) {
    std::vector<double> ms;
    for (int i = 0; i < 15; ++i) {
        edit();
        ++revision;
        ms.push_back(1e3 * seconds([&] { (void)objects.closest(p, revision, {500, 60, 500}, {0.8, -0.3, 0.5}); }));
    }
    return *std::min_element(ms.begin(), ms.end());
}

SWARD_LIMITS("pick", [] {
    Project p;
    p.dir = folderWithBall();
    Terrain t;
    t.size = {1000, 1000};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    p.registry.add<Scatter>(*addEntity(p, "balls"),
                            {.meshes = {{"ball", "ball.glb"}}, .perHectare = 500, .distance = 1});
    SceneObjects objects;
    uint64_t revision = 1;
    (void)objects.closest(p, revision, {500, 60, 500}, {0.8, -0.3, 0.5});
    reportLimit("pick among 50,000 scattered objects after an edit", leastPick(objects, p, revision, [] {}), 5, "ms");
    p.registry.remove<Scatter>(findEntity(p, "balls"));
    for (int i = 0; i < 50000; ++i) {
        const Entity e = *addEntity(p, fmt::format("ball-{}", i));
        p.registry.add<Transform>(e, {{4.0 * (i % 250), 0, 4.0 * (i / 250)}});
        p.registry.add<StaticMesh>(e, {.file = "ball.glb", .onGround = false});
    }
    reportLimit("pick among 50,000 entities with objects after one moved",
                leastPick(objects, p, revision,
                          [&] { p.registry.get<Transform>(findEntity(p, "ball-7"))->position.x += 0.01; }),
                5, "ms");
});

}  // namespace
