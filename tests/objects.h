// Scenes with objects, in a folder of their own.
#pragma once
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "scenes.h"
#include "support.h"
#include "world/view_camera.h"

namespace sward::test {

// Writes the solids as a .glb of the project.
inline void putObject(Project& p, const std::string& entity, std::vector<Solid> solids, const glm::dvec3& at) {
    const std::string file = entity + ".glb";
    const auto bytes = encodeGlb(makeMesh(solids));
    ASSERT_TRUE(bytes);
    writeText(p.dir / file, *bytes);
    put<StaticMesh>(p, entity, {.file = file});
    put<Transform>(p, entity, {at});
}

// Bare level ground of 20 x 20 m with a cube of 2 m on it at (10, 10), the sun in the south (+z) at 45 degrees.
inline Project cubeScene(const std::filesystem::path& dir) {
    Project p;
    p.dir = dir;
    Terrain t;
    t.size = {20, 20};
    put(p, "ground", t);
    put<Light>(p, "sun", {.azimuthDeg = 180, .elevationDeg = 45});
    put<Sky>(p, "sky");
    putObject(p, "cube", {{.size = {2, 2, 2}, .color = {0.1f, 0.1f, 0.1f}}}, {10, 0, 10});
    return p;
}

// Mean of a few pixels' linear light where a point of the world is seen.
inline glm::vec3 lightAt(const Renderer& r, const ViewCamera& c, const ViewSettings& s, const glm::dvec3& point) {
    const glm::vec4 clip = viewProjection(c, s.width, s.height) * glm::vec4(glm::vec3(point - c.eye), 1);
    const std::vector<float> pixels = r.readLinear();
    const int x = static_cast<int>((clip.x / clip.w * 0.5f + 0.5f) * static_cast<float>(s.width)),
              y = static_cast<int>((0.5f - clip.y / clip.w * 0.5f) * static_cast<float>(s.height));
    glm::vec3 sum(0);
    int n = 0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            if (x + dx < 0 || y + dy < 0 || x + dx >= s.width || y + dy >= s.height) continue;
            const float* at =
                &pixels[(static_cast<size_t>(y + dy) * static_cast<size_t>(s.width) + static_cast<size_t>(x + dx)) * 3];
            sum += glm::vec3(at[0], at[1], at[2]);
            ++n;
        }
    EXPECT_GT(n, 0) << "the point is not in the picture";
    return sum / static_cast<float>(std::max(n, 1));
}

}  // namespace sward::test
