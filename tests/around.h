// A wide plain under an even sky, and light that comes from all around on it.
#pragma once
#include "objects.h"
#include "reference/around_tracer.h"
#include "techniques.h"

namespace sward::test {

inline constexpr float kPlainAlbedo = 0.4f;

// An even sky over a wide plain of one reflectance.
inline Project plain(const TempDir& dir) {
    Project p = cubeScene(dir.path);
    removeEntity(p, "cube");
    Terrain& ground = *p.registry.get<Terrain>(findEntity(p, "ground"));
    ground.size = {4000, 4000};
    ground.groundColor = glm::vec3(kPlainAlbedo);
    p.registry.get<Sky>(findEntity(p, "sky"))->model = SkyModel::Uniform;
    return p;
}
inline AroundTracer tracerOf(const Project& p) {
    auto made = AroundTracer::make(p, tables(), 0, JobControl{});
    EXPECT_TRUE(made) << made.error().text();
    return std::move(*made);
}
// Mean of many paths.
inline AroundFactors meanAt(const AroundTracer& t, const glm::dvec3& at, const glm::vec3& n) {
    AroundFactors sum;
    constexpr int kMany = 64;
    for (uint32_t i = 0; i < kMany; ++i) {
        const AroundFactors f = t.at(at, n, i);
        sum.sky += f.sky / float(kMany), sum.sun += f.sun / float(kMany), sum.ground += f.ground / float(kMany);
    }
    return sum;
}

}  // namespace sward::test
