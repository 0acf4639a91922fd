// Grass on a mesh, as tests draw and trace it: rays through slices unless the technique is changed.
#pragma once
#include "fields.h"
#include "grass/mesh_grass_settings.h"
#include "objects.h"
#include "pixels.h"
#include "reference/reference.h"
#include "scenes.h"
#include "support.h"

namespace sward::test {

// Soil, and a field of green blades that grows where it is told.
inline Project meshMeadow(const TempDir& dir) {
    Project p = lawn();
    p.dir = dir.path;
    FlatField f = flatField(p);
    f.technique = nameOf(Technique::Raytraced);
    f.species[0].bladesPerM2 = 5000, f.species[0].height = 0.08f, f.species[0].width = 0.006f;
    f.sliceWidth = f.farSize = 128, f.sliceHeight = 32, f.slices = 10;
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = {0.2f, 0.05f, 0.05f};
    p.registry.remove<Fog>(findEntity(p, "haze"));
    return p;
}
inline Project grassOnMesh(const TempDir& dir, Solid solid, const glm::dvec3& at = {10, 0, 10}) {
    Project p = meshMeadow(dir);
    flatField(p).grows.onTerrain = false;
    solid.color = {0.2f, 0.05f, 0.05f};
    putObject(p, "rock", {solid}, at);
    put<MeshGrass>(p, "rock");
    return p;
}
inline const Solid kGrassBall{.kind = SolidKind::Ball, .size = {0.5f, 0.5f, 0.5f}, .at = {0, 0.6f, 0}, .unwrap = true};
inline const Solid kGrassPlate{.size = {20, 0.02f, 20}, .unwrap = true};

inline ViewSettings meshSized(int width = 160, int height = 120, int msaa = 4) {
    ViewSettings s;
    s.width = width, s.height = height, s.msaa = msaa;
    return s;
}
inline ViewCamera viewOfBall() { return {{10, 1.1, 8}, {10, 0.6, 10}, 45, 0}; }

inline std::vector<float> meshPicture(const Project& p, const ViewCamera& camera,
                                      const ViewSettings& settings = meshSized()) {
    Renderer r(gpu(), tables());
    const Status drawn = r.draw(p, camera, settings);
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    return r.readLinear();
}
inline std::vector<float> meshTruth(const Project& p, const ViewCamera& camera) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene) << scene.error().text();
    ReferenceSettings settings;
    settings.width = 160, settings.height = 120, settings.samples = 8;
    return scene->trace(camera, settings, control)->color;
}

// Pixels of sky in one picture and not in the other, as a share of those that are no sky in the first.
inline double skyExchanged(const std::vector<float>& a, const std::vector<float>& b) {
    const auto isSky = [](const std::vector<float>& image, size_t i) { return image[i + 2] > 0.2f; };
    double off = 0, all = 0;
    for (size_t i = 0; i < a.size(); i += 3) off += isSky(a, i) != isSky(b, i), all += !isSky(b, i);
    return off / all;
}
}  // namespace sward::test
