// Solids as meshes: closed, and of the volume that their sizes say.
#include "mesh/mesh_shapes.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(MeshShapes, SolidsAreClosedAndFaceOutwards) {
    const Solid solids[] = {{.size = {2, 3, 4}},
                            {.kind = SolidKind::Cylinder, .size = {1, 2, 0.5f}, .sides = 64},
                            {.kind = SolidKind::Ball, .size = {1, 1, 1}}};
    const double volumes[] = {24, 3.14159265 * 2 * (1 + 0.5 + 0.25) / 3, 4.18879};
    for (size_t i = 0; i < 3; ++i) {
        const Mesh m = makeMesh({&solids[i], 1});
        double volume = 0;  // by the divergence theorem: right only if the mesh is closed and every face looks outwards
        for (size_t k = 0; k + 2 < m.indices.size(); k += 3) {
            const glm::dvec3 a(m.vertices[m.indices[k]].position), b(m.vertices[m.indices[k + 1]].position),
                c(m.vertices[m.indices[k + 2]].position);
            volume += glm::dot(a, glm::cross(b, c)) / 6;
        }
        EXPECT_NEAR(volume / volumes[i], 1, 0.02) << kSolidKinds[solids[i].kind];
    }
}

}  // namespace
}  // namespace sward
