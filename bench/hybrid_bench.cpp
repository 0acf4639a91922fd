// The hybrid field's time against all its blades drawn as geometry, and what slices cost to make and to load.
#include "bench/limits.h"
#include "core/file.h"
#include "frame/color_image.h"
#include "frame/renderer.h"
#include "grass/slice_file.h"
#include "grass/slice_textures.h"
#include "grass/slices.h"
#include "techniques.h"
#include "tests/fields.h"
#include "tests/grass/comparison.h"
#include "world/view_camera.h"

namespace {
using namespace sward;
using namespace sward::test;

// A project with its own renderer, so that two can be timed in turn without making anything anew.
struct Timed {
    Renderer renderer{*gpu(), tables()};
    Project project;
    std::vector<double> ms;

    Timed(Project p, Technique t) : project(std::move(p)) { grassIn(project).technique = nameOf(t); }
    // One frame with one finish at its end.
    double frame(const ViewCamera& c, const ViewSettings& s) {
        bool drawn = false;
        const double took = 1000 * seconds([&] {
                                drawn = bool(renderer.draw(project, c, s));
                                renderer.finish();
                            });
        return drawn ? took : NAN;
    }
};

// Where a frame's time goes.
void printPasses(Timed& t, const ViewCamera& c, ViewSettings s) {
    s.measure = true;
    t.frame(c, s);
    for (const PassStats& p : t.renderer.stats().passes)
        std::fprintf(stderr, "  %-20s %7.1f ms %9lu vertices %9lu fragments\n", p.name.c_str(), p.ms,
                     static_cast<unsigned long>(p.vertices), static_cast<unsigned long>(p.fragments));
}

struct Race {
    double geometry, hybrid;  // ms, medians
};
Race race(const Design& d, int frames, bool passes = false) {
    const ViewSettings s = sized(320, 240);
    const ViewCamera c = person(d.side);
    Timed geometry(designed(d, d.side), Technique::Geometry), hybrid(designed(d, d.side), Technique::Hybrid);
    for (Timed* t : {&geometry, &hybrid}) t->frame(c, s);  // compiles, bakes
    for (int i = 0; i < frames; ++i)
        for (Timed* t : {&hybrid, &geometry, &hybrid}) t->ms.push_back(t->frame(c, s));
    if (passes) printPasses(hybrid, c, s);
    return {median(geometry.ms), median(hybrid.ms)};
}

void reportRace(const Design& d, double times, int frames) {
    if (!gpu()) return reportLimit(d.name, NAN, 1 / times, "x");
    const Race r = race(d, frames, true);
    std::fprintf(stderr, "%s, tiers at %g to %g and %g to %g m: geometry %.0f ms, hybrid %.1f ms, %.1f times\n", d.name,
                 d.minGeom, d.maxGeom, d.minBTF, d.maxBTF, r.geometry, r.hybrid, r.geometry / r.hybrid);
    reportLimit((std::string("hybrid as a share of geometry, ") + d.name).c_str(), r.hybrid / r.geometry, 1 / times,
                "x");
}

// The density at which hybrid and geometry take the same time, on the meadow: between the two tried densities where the
// quotient passes 1, by its logarithm.
void printBreakEven() {
    double before = 0, quotientBefore = 0;
    for (const float density : {5.0f, 20.0f, 80.0f, 320.0f}) {
        Design d = kMeadow;
        d.bladesPerM2 = density;
        const Race r = race(d, 3);
        const double quotient = r.geometry / r.hybrid;
        std::fprintf(stderr, "at %g blades/m2: geometry %.1f ms, hybrid %.1f ms\n", density, r.geometry, r.hybrid);
        if (quotient >= 1 && before > 0 && quotientBefore < 1) {
            const double share = std::log(1 / quotientBefore) / std::log(quotient / quotientBefore);
            std::fprintf(stderr, "hybrid breaks even at %.0f blades/m2\n", before * std::pow(density / before, share));
            return;
        }
        if (quotient >= 1) return void(std::fprintf(stderr, "hybrid breaks even below %g blades/m2\n", density));
        before = density, quotientBefore = quotient;
    }
}

SWARD_LIMITS("hybrid-meadow", [] { reportRace(kMeadow, 10, 3); });
SWARD_LIMITS("hybrid-lawn", [] { reportRace(kLawn, 20, 3); });
SWARD_LIMITS("hybrid-turf", [] { reportRace(kTurf, 40, 2); });
SWARD_LIMITS("hybrid-even", [] {
    if (gpu()) printBreakEven();
});

// 20 x 20 m of 10,000 blades/m2 at 640 x 480, one sample. The aim is 50 ms; the limit is what another program's static
// field without light takes on such a machine.
SWARD_LIMITS("hybrid-frame", [] {
    if (!gpu()) return reportLimit("a lawn of 20 x 20 m at 640 x 480", NAN, 1, "ms");
    Timed t(designed(kLawn, 20), Technique::Hybrid);
    ViewSettings s = sized(640, 480, 1);
    t.frame(person(20), s);
    for (int i = 0; i < 9; ++i) t.ms.push_back(t.frame(person(20), s));
    printPasses(t, person(20), s);
    reportLimit("a lawn of 20 x 20 m at 640 x 480", median(t.ms), 103, "ms");
});

// Walking 3 m across both transitions in steps of 1 cm: the change of each tile of 16 x 16 pixels at each step, less
// that of blades alone.
SWARD_LIMITS("hybrid-walk", [] {
    if (!gpu()) return reportLimit("change at a step, hybrid less blades", NAN, 1.25, "x");
    Renderer renderer(*gpu(), tables());
    Project p = designed(kMeadow, 24);
    for (const auto& [name, distance] : {std::pair{"blades to slices", 6.0}, std::pair{"slices to far", 16.0}}) {
        const Restless seen = restless(renderer, p, lookingAt(distance), 300, sized(160, 112));
        reportLimit((std::string("change of pixels at a step as a share of blades', ") + name).c_str(), seen.pixels,
                    1.25, "x");
        reportLimit((std::string("change of tiles at a step as a share of blades', ") + name).c_str(), seen.means, 1.25,
                    "x");
    }
});

// --- 25 times the field, from high above -------------------------------------------------------------------

double coveredShare(Timed& t, const ViewCamera& c, const ViewSettings& s) {
    ViewSettings tiers = s;
    tiers.mode = ViewMode::Tiers;
    t.frame(c, tiers);
    const auto rgb = t.renderer.readImage();
    double green = 0;
    for (size_t i = 0; i < rgb.size(); i += 3) green += rgb[i + 1] > rgb[i] && rgb[i + 1] > rgb[i + 2];
    return green;
}

SWARD_LIMITS("hybrid-whole", [] {
    if (!gpu()) return reportLimit("ms a grass pixel at whole, field of 25 times", NAN, 1.2, "x");
    const ViewSettings s = sized(640, 480);
    const auto whole = [](double side) {
        return ViewCamera{{0.5 * side, 0.7 * side, -0.25 * side}, {0.5 * side, 0, 0.45 * side}, 55, 0};
    };
    Timed small(designed(kMeadow, 40), Technique::Hybrid), large(designed(kMeadow, 200), Technique::Hybrid);
    const double smallPixels = coveredShare(small, whole(40), s), largePixels = coveredShare(large, whole(200), s);
    small.frame(whole(40), s), large.frame(whole(200), s);
    for (int i = 0; i < 7; ++i)
        small.ms.push_back(small.frame(whole(40), s)), large.ms.push_back(large.frame(whole(200), s));
    std::fprintf(stderr, "whole: 40 m %.1f ms over %.0f pixels, 200 m %.1f ms over %.0f pixels\n", median(small.ms),
                 smallPixels, median(large.ms), largePixels);
    reportLimit("ms a grass pixel at whole, field of 25 times",
                median(large.ms) / largePixels / (median(small.ms) / smallPixels), 1.2, "x");
});

// --- making and loading slices -----------------------------------------------------------------------------

SWARD_LIMITS("slices", [] {
    FlatField f;
    f.species[0].bladesPerM2 = 88000, f.species[0].height = 0.03f, f.species[0].width = 0.0015f;
    f.slices = 10, f.sliceWidth = 512, f.sliceHeight = 64, f.farSize = 512;
    const SliceSpec spec = sliceSpec(f.asField(), 0, makeBladeImage(32, 128), true);
    const auto folder = std::filesystem::temp_directory_path() / fmt::format("sward-bench-{}", getpid());
    JobControl control;
    std::optional<SliceImages> images;
    reportLimit("slices of the paper's resolutions, made",
                seconds([&] { images = std::move(*bakeSlices(spec, control)); }), 25, "s");
    cacheSlices(folder, sliceKey(spec), *images);
    std::optional<SliceImages> loaded;
    SliceTextures textures;
    const double took = seconds([&] {
        loaded = loadCachedSlices(folder, sliceKey(spec));
        if (loaded && gpu()) textures = uploadSlices(*gpu(), "bench", "bench", *loaded, Storage::Factored), glFinish();
    });
    reportLimit("slices of the paper's resolutions, loaded", loaded ? took : NAN, 0.5, "s");
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    if (!gpu()) return;
    reportLimit("slices of the paper's resolutions, factored", static_cast<double>(textures.bytes()) / 1e6, 25, "MB");
    textures = uploadSlices(*gpu(), "bench", "bench", *images, Storage::Compressed);
    reportLimit("slices of the paper's resolutions, compressed", static_cast<double>(textures.bytes()) / 1e6, 9, "MB");
});

}  // namespace
