// Small scenes made in memory, and the one OpenGL context of the test process.
#pragma once
#include <gtest/gtest.h>

#include "frame/renderer.h"
#include "programs_once.h"
#include "scene/project.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {

// Made at first use; lives until the process ends, so that start-up is paid once.
inline Gpu& gpu() {
    static std::unique_ptr<Gpu> instance = [] {
        auto made = makeHeadlessGpu();
        if (!made) ADD_FAILURE() << made.error().text();
        return made ? std::move(*made) : std::make_unique<Gpu>();
    }();
    static ProgramsOnce programs;
    makeCurrent(*instance);
    programs.makeCurrent();
    return *instance;
}
// Fails the test if OpenGL reported an error since it was made.
struct NoGlErrors {
    int before = gpu().errors;
    ~NoGlErrors() { EXPECT_EQ(gpu().errors, before) << gpu().lastError; }
};

template <class C>
C& put(Project& p, const std::string& entity, C value = {}) {
    Entity e = findEntity(p, entity);
    if (e == kNoEntity) e = *addEntity(p, entity);
    return *p.registry.add<C>(e, std::move(value));
}

inline MapField field(Map map, const std::string& file = "maps/made.png") { return {file, std::move(map)}; }
inline Map filled(const MapInfo& info, float value) {
    Map m(info);
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x)
            for (int c = 0; c < info.channels; ++c) m.set(x, y, c, value);
    return m;
}

// Flat ground of 20 x 20 m, 200 blades a m2 (a cell's share is whole), sun, sky, haze.
inline Project lawn() {
    Project p;
    p.name = "lawn";
    Terrain t;
    t.size = {20, 20};
    put(p, "ground", t);
    GrassField f;
    f.species[0].name = "lawn";
    f.species[0].bladesPerM2 = 200;
    f.species[0].width = 0.02f;  // wide enough for the small pictures of tests
    f.species[0].height = 0.15f;
    put(p, "grass", f);
    put<Light>(p, "sun");
    put<Sky>(p, "sky");
    put<Fog>(p, "haze");
    return p;
}
inline ViewCamera above() { return {{10, 6, 10}, {10, 0, 11}, 55, 0}; }
inline ViewCamera eyeHeight() { return {{2, 1.7, 2}, {10, 0, 10}, 55, 0}; }
inline ViewSettings small() {
    ViewSettings s;
    s.width = 160, s.height = 120;
    return s;
}

}  // namespace sward::test
