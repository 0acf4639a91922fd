// Table 1 of Jahrmann and Wimmer 2013 beside the same questions put to Sward: three scenes, their sizes, effects on
// what is far, on and off; and at sizes that both can hold, every blade stored (`unique`, the paper's basic technique)
// against one patch drawn many times
// (`patch`, the paper's instanced one). What stands beside each other are ratios: the machines have nothing in common.
#include "bench/limits.h"
#include "frame/renderer.h"
#include "project/project_files.h"
#include "scene/antialias.h"
#include "scene/unique.h"
#include "techniques.h"
#include "tests/fields.h"
#include "tests/grass/comparison.h"
#include "world/view_camera.h"

namespace {
using namespace sward;
using namespace sward::test;

enum Added : unsigned { kNothing = 0, kObjects = 1, kFlowers = 2 };
// A row of the paper's, with effects and without.
struct Published {
    const char* scene;
    double side;  // metres
    unsigned added;
    double fpsOn, fpsOff, blades;
};
constexpr Published kTable[] = {
    {"oasis", 160, kNothing, 75, 78, 136650},      {"oasis", 320, kNothing, 65, 68, 330816},
    {"meadow", 300, kNothing, 84, 88, 348370},     {"meadow", 300, kObjects, 83, 87, 348370},
    {"meadow", 600, kObjects, 81, 85, 340716},     {"prairie", 300, kNothing, 60, 62, 660000},
    {"prairie", 600, kNothing, 56, 58, 824000},    {"prairie", 2000, kFlowers, 55, 57, 1008000},
    {"prairie", 4000, kFlowers, 55, 57, 1008000},  {"prairie", 8000, kFlowers, 55, 57, 1008000},
    {"prairie", 90000, kFlowers, 55, 57, 1008000},
};
constexpr int kFrames = 3;              // timed, of each
constexpr float kThinning = 0.6f;       // as published: linear in the distance
constexpr double kLargestStored = 600;  // metres: the paper's memory ends at 1,000, ours at kMaxUniqueBlades

template <class C>
void removeAll(Project& p) {
    std::vector<std::string> names;
    for (const auto& [name, e] : p.entities)
        if (p.registry.get<C>(e)) names.push_back(name);
    for (const std::string& name : names) removeEntity(p, name);
}

// Maps that lie on the terrain once repeat instead, so that around the camera all is as in the sample project.
void resize(Project& p, double side) {
    for (const auto& [name, e] : p.entities)
        if (Terrain* t = p.registry.get<Terrain>(e)) {
            if (!(t->mapSize > 0)) t->mapSize = static_cast<float>(t->size.x);
            t->size = glm::dvec2(side);
        }
}

// Sparser where all blades of that size could not be stored, for both populations alike.
void thinToStore(const FlatField& f, const Project& p) {
    const float share = static_cast<float>(
        std::min(1.0, 0.95 * static_cast<double>(kMaxUniqueBlades) / std::max(virtualBlades(p), 1.0)));
    for (Species& s : f.species) s.bladesPerM2 *= share;
}

std::optional<Project> sceneOf(const Published& row, Population population) {
    auto p = loadProject(std::filesystem::path(SWARD_SOURCE_DIR) / "projects" / row.scene, tables().components);
    if (!p) {
        std::fprintf(stderr, "%s\n", p.error().text().c_str());
        return {};
    }
    if (!(row.added & kObjects)) removeAll<StaticMesh>(*p);
    if (!(row.added & kFlowers)) removeAll<Flowers>(*p);
    removeAll<Antialias>(*p);
    resize(*p, row.side);
    FlatField f = grassIn(*p);
    f.leastPixels = 0;
    f.thinning = std::max(f.thinning, kThinning);
    f.technique = nameOf(Technique::Tessellated);
    f.population = population;
    if (row.side <= kLargestStored) thinToStore(f, *p);
    return std::move(*p);
}

struct Measured {
    double ms = std::numeric_limits<double>::infinity();  // the least: load that the machine has besides only adds
    uint64_t blades = 0;
    int64_t bytes = 0;  // on the GPU
};
// A population of a row's scene, and what it takes without effects on what is far [0] and with them [1].
struct Drawn {
    Renderer renderer{*gpu(), tables()};
    Project project;
    Measured at[2];

    explicit Drawn(Project p) : project(std::move(p)) {}
    void frame(int effects, bool first) {
        FlatField f = grassIn(project);
        f.farBlur = effects ? FarBlur::Gaussian : FarBlur::None;
        f.farDarkening = effects ? 0.4f : 0;
        ViewSettings s = sized(320, 240, 1);
        s.measure = first;
        bool drawn = false;
        const double ms = 1000 * seconds([&] {
                              drawn = bool(renderer.draw(project, viewOf(*findCamera(project, "human")), s));
                              renderer.finish();
                          });
        Measured& m = at[effects];
        if (!drawn)
            m.ms = NAN;
        else if (first)
            m.blades = renderer.stats().bladesGeometry;
        else
            m.ms = std::min(m.ms, ms);
    }
    // Frames that compile, and are counted; `others`: bytes that are not its own.
    void begin(int64_t others) {
        for (const int effects : {0, 1}) {
            frame(effects, true);
            at[effects].bytes = gpu()->totalBytes() - others;
        }
    }
};

struct TableRow {
    const Published* published;
    Measured patch[2], stored[2];
    bool hasStored = false;
};

// Both populations and effects on and off, in turn.
std::optional<TableRow> measure(const Published& published) {
    TableRow row{&published, {}, {}, published.side <= kLargestStored};
    std::vector<std::unique_ptr<Drawn>> all;
    for (const Population p : {Population::Patch, Population::Unique}) {
        if (p == Population::Unique && !row.hasStored) continue;
        std::optional<Project> scene = sceneOf(published, p);
        if (!scene) return {};
        const int64_t others = gpu()->totalBytes();
        all.push_back(std::make_unique<Drawn>(std::move(*scene)));
        all.back()->begin(others);
    }
    for (int i = 0; i < 2 * kFrames; ++i)
        for (auto& d : all) d->frame(i % 2, false);
    for (int e : {0, 1}) {
        row.patch[e] = all[0]->at[e];
        if (row.hasStored) row.stored[e] = all[1]->at[e];
    }
    return row;
}

double mega(int64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

void print(const TableRow& r, int effects) {
    const Published& p = *r.published;
    const Measured& m = r.patch[effects];
    std::fprintf(stderr, "%-8s %6.0f  %-8s %-3s | %5.1f ms %9.0f | %7.1f ms %8lu %6.1f MB |", p.scene, p.side,
                 p.added & kObjects   ? "objects"
                 : p.added & kFlowers ? "flowers"
                                      : "-",
                 effects ? "on" : "off", 1000 / (effects ? p.fpsOn : p.fpsOff), p.blades, m.ms,
                 static_cast<unsigned long>(m.blades), mega(m.bytes));
    const Measured& s = r.stored[effects];
    if (r.hasStored)
        std::fprintf(stderr, " %7.1f ms %8lu %6.1f MB | %5.2f |", s.ms, static_cast<unsigned long>(s.blades),
                     mega(s.bytes), s.ms / m.ms);
    else
        std::fprintf(stderr, " %31s | %5s |", "-", "-");
    if (effects) std::fprintf(stderr, " %5.2f %5.2f", p.fpsOff / p.fpsOn, m.ms / r.patch[0].ms);
    std::fprintf(stderr, "\n");
}

SWARD_LIMITS("prairie-table", [] {
    if (!gpu()) return reportLimit("stored blades as a share of a patch's time", NAN, 1.25, "x");
    std::vector<TableRow> rows;
    std::fprintf(stderr, "320 x 240, 1 sample, least of %d frames in turn, %s\n", kFrames, gpu()->renderer.c_str());
    std::fprintf(stderr,
                 "scene    metres  added    far | the paper's       | a patch                      | every blade "
                 "stored           | ratio | on/off: paper's, ours\n");
    for (const Published& p : kTable)
        if (std::optional<TableRow> row = measure(p)) {
            rows.push_back(*row);
            for (const int effects : {1, 0}) print(*row, effects);
        }
    if (rows.size() != std::size(kTable)) return reportLimit("rows of the paper's table 1", NAN, 0, "");
    std::vector<double> stored, effects;
    for (const TableRow& r : rows) {
        effects.push_back(r.patch[1].ms / r.patch[0].ms);
        if (r.hasStored) stored.push_back(r.stored[0].ms / r.patch[0].ms);
    }
    reportLimit("stored blades as a share of a patch's time, median of scenes", median(stored), 1.25, "x");
    reportLimit("effects on what is far as a share of none, median of scenes", median(effects), 1.25, "x");
    reportLimit("prairie, 90,000 m as a share of 2,000 m", rows[10].patch[0].ms / rows[7].patch[0].ms, 1.25, "x");
});

}  // namespace
