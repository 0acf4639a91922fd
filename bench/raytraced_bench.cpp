// What rays through slices cost: against the same slices as blended quads, by how many slices there are and how large
// the ground is, and by pixel; and that no view breaks them.
#include <cmath>
#include <random>

#include "bench/limits.h"
#include "frame/renderer.h"
#include "techniques.h"
#include "tests/fields.h"
#include "tests/grass/comparison.h"
#include "world/view_camera.h"

namespace {
using namespace sward;
using namespace sward::test;

constexpr Design kPatches{"2,600 blades/m2 of 20 cm on 8 m", 2600, 0.2f, 0.005f, 8, 0, 0, 0, 0};
constexpr int kSteps = 4;  // the paper's

Project patches(Technique technique, int slices = 16, double side = kPatches.side) {
    Project p = designed(kPatches, side);
    FlatField f = grassIn(p);
    f.technique = nameOf(technique);
    f.cellSize = 1;
    f.slices = slices;
    f.sliceWidth = 256, f.sliceHeight = 64, f.farSize = 256;
    f.raytraced.steps = kSteps;
    f.raytraced.maxDistance = std::numeric_limits<float>::infinity();
    return p;
}
ViewCamera over() { return {{4, 1.2, 0.3}, {4, 0, 4}, 50, 0}; }

struct Timed {
    Renderer renderer{*gpu(), tables()};
    Project project;
    std::vector<double> ms;
    explicit Timed(Project p) : project(std::move(p)) {}
    double frame(const ViewCamera& c, const ViewSettings& s) {
        bool drawn = false;
        const double took = 1000 * seconds([&] {
                                drawn = bool(renderer.draw(project, c, s));
                                renderer.finish();
                            });
        return drawn ? took : NAN;
    }
    PassStats pass(const char* name, const ViewCamera& c, ViewSettings s) {
        s.measure = true;
        frame(c, s);
        for (const PassStats& p : renderer.stats().passes)
            if (p.name == name) return p;
        return {};
    }
};

// Median of the quotients a / b of frames in turn.
double quotient(Timed& a, Timed& b, const ViewSettings& s, int pairs) {
    std::vector<double> all;
    for (Timed* t : {&a, &b}) t->frame(over(), s);  // compiles, bakes
    for (int i = 0; i < pairs; ++i) {
        const double first = a.frame(over(), s);
        all.push_back(first / b.frame(over(), s));
    }
    std::sort(all.begin(), all.end());
    std::fprintf(stderr, "  of %zu pairs: %.3f to %.3f\n", all.size(), all.front(), all.back());
    return median(all);
}

SWARD_LIMITS("raytraced-quads", [] {
    if (!gpu()) return reportLimit("rays as a share of blended quads", NAN, 1 / 1.5, "x");
    Timed rays(patches(Technique::Raytraced)), quads(patches(Technique::Slices));
    grassIn(quads.project).transparency = Transparency::Blend;
    grassIn(quads.project).maxBTF = std::numeric_limits<float>::infinity();  // both shade the ground everywhere
    grassIn(rays.project).transparency = Transparency::Blend;
    reportLimit("rays as a share of blended quads", quotient(rays, quads, sized(640, 480, 1), 9), 1 / 1.5, "x");
});

// Both ways of visibility, over ground alone: what the copy of the depth and a look-up a ray cost.
SWARD_LIMITS("raytraced-visibility", [] {
    if (!gpu())
        return reportLimit("frame of rays that end at the scene as a share of one depth a pixel", NAN, 1.15, "x");
    Timed depth(patches(Technique::Raytraced)), scene(patches(Technique::Raytraced));
    grassIn(scene.project).raytraced.visibility = RayVisibility::Scene;
    reportLimit("frame of rays that end at the scene as a share of one depth a pixel",
                quotient(scene, depth, sized(640, 480, 1), 15), 1.15, "x");
});

SWARD_LIMITS("raytraced-growth", [] {
    if (!gpu()) return reportLimit("frame of 256 slices a side as a share of 16", NAN, 1.15, "x");
    Timed few(patches(Technique::Raytraced, 16)), many(patches(Technique::Raytraced, 256));
    reportLimit("frame of 256 slices a side as a share of 16", quotient(many, few, sized(640, 480, 1), 15), 1.15, "x");
    Timed large(patches(Technique::Raytraced, 16, 10 * kPatches.side));
    const ViewSettings s = sized(640, 480, 1);
    large.frame(over(), s);
    const PassStats a = few.pass("grass/raytraced", over(), s), b = large.pass("grass/raytraced", over(), s);
    std::fprintf(stderr, "  8 m: %.1f ms, %lu fragments; 80 m: %.1f ms, %lu fragments\n", a.ms,
                 static_cast<unsigned long>(a.fragments), b.ms, static_cast<unsigned long>(b.fragments));
    reportLimit("ms a traced pixel, ground of 100 times",
                b.ms / static_cast<double>(b.fragments) / (a.ms / static_cast<double>(a.fragments)), 1.15, "x");
});

// The material without what a scene may add to it: one light under a sky, no haze, no maps.
Project bare() {
    Project p = patches(Technique::Raytraced);
    removeEntity(p, "haze");
    return p;
}
// With all of that: haze, wind, a lamp, shadows, and a map each of density, colour and lean.
Project full() {
    Project p = patches(Technique::Raytraced);
    const auto map = [](int channels, float value) {
        Map m({64, 64, channels, PixelType::U8});
        for (int i = 0; i < 64 * 64 * channels; ++i) m.set(i / channels % 64, i / channels / 64, i % channels, value);
        return MapField{"maps/even.png", std::move(m)};
    };
    FlatField f = grassIn(p);
    f.species[0].density = map(1, 0.9f), f.vegetation = map(4, 0.3f), f.orientation = map(2, 0.6f);
    give(p, "wind", Wind{});
    Light lamp;
    lamp.type = LightType::Point;
    give(p, "lamp", lamp);
    p.registry.add<Transform>(findEntity(p, "lamp"), Transform{.position = {4, 1, 4}});
    return p;
}

// What a traced pixel takes as a share of one of the pass that fetches one texel and writes it, full screen.
double pixelShare(Project p) {
    Timed t(std::move(p));
    const ViewCamera down{{4, 0.9, 3}, {4, 0, 4}, 50, 0};
    const ViewSettings s = sized(640, 480, 1);
    t.frame(down, s);
    std::vector<double> all;
    for (int i = 0; i < 15; ++i) {
        const PassStats rays = t.pass("grass/raytraced", down, s), fetch = t.pass("post/tonemap", down, s);
        all.push_back(rays.ms / static_cast<double>(rays.fragments) /
                      (fetch.ms / static_cast<double>(fetch.fragments)));
    }
    return median(all);
}
SWARD_LIMITS("raytraced-pixel", [] {
    if (!gpu()) return reportLimit("a traced pixel as a share of one with a fetch", NAN, 8, "x");
    const double hazed = pixelShare(patches(Technique::Raytraced)), whole = pixelShare(full());
    std::fprintf(stderr, "  in haze: %.2f; with haze, wind, lamp, shadows and three maps: %.2f\n", hazed, whole);
    reportLimit("a traced pixel as a share of one with a fetch", pixelShare(bare()), 8, "x");
});

SWARD_LIMITS("raytraced-views", [] {
    if (!gpu()) return reportLimit("views of 10,000 with a pixel that is no number", NAN, 0, "views");
    Timed t(patches(Technique::Raytraced));
    ViewSettings s = sized(64, 48, 1);
    std::mt19937 random(11);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    int broken = 0;
    for (int i = 0; i < 10000; ++i) {
        glm::dvec3 eye(10 * unit() - 1, 0.5 * unit() * unit(), 10 * unit() - 1),
            way(2 * unit() - 1, 1.2 * unit() - 1, 2 * unit() - 1);
        if (i % 5 == 0) way = glm::dvec3(i % 15 == 0, i % 15 == 5 ? -1 : 0, i % 15 == 10);  // along an axis, or down
        if (i % 7 == 0) eye = glm::floor(eye * 16.0) / 16.0 + glm::dvec3(0.5 / 16, 0, 0.5 / 16);  // on a slice
        t.frame({eye, eye + way, 20 + 80 * static_cast<float>(unit()), 0}, s);
        const std::vector<float> image = t.renderer.readLinear();
        broken += !std::all_of(image.begin(), image.end(), [](float v) { return std::isfinite(v); });
    }
    reportLimit("views of 10,000 with a pixel that is no number", broken, 0, "views");
});

}  // namespace
