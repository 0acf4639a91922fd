// What the size of a field costs (Jahrmann and Wimmer 2013, table 1, scene Instance): the sample project prairie at
// `human`, made larger by its one field Terrain.size; and whether it stays the same picture where it stands far from
// the origin.
#include <deque>

#include "bench/limits.h"
#include "frame/renderer.h"
#include "project/project_files.h"
#include "techniques.h"
#include "tests/grass/comparison.h"
#include "world/view_camera.h"

namespace {
using namespace sward;
using namespace sward::test;

// Of frames drawn in turn with others': what load the machine has besides only adds to it.
double least(const std::vector<double>& ms) { return ms.empty() ? NAN : *std::min_element(ms.begin(), ms.end()); }

std::optional<Project> prairie(double side) {
    auto project = loadProject(SWARD_SOURCE_DIR "/projects/prairie", tables().components);
    if (!project) {
        std::fprintf(stderr, "%s\n", project.error().text().c_str());
        return {};
    }
    project->registry.get<Terrain>(findEntity(*project, "land"))->size = glm::dvec2(side);
    return std::move(*project);
}

struct Counts {
    double vertices = 0, fragments = 0, nodes = 0, bytes = 0;
};
struct Sized {
    Renderer renderer{*gpu(), tables()};
    Project project;
    std::vector<double> ms;

    explicit Sized(Project p) : project(std::move(p)) {}
    ViewCamera camera() const { return viewOf(*findCamera(project, "human")); }
    // Down to what lies before one's feet: no horizon is in view, so that fields of every size show the same.
    ViewCamera feet() const {
        ViewCamera c = camera();
        c.target = c.eye + glm::dvec3(1.2, -1.8, 1.2);
        return c;
    }
    double frame(const ViewCamera& c, const ViewSettings& s) {
        bool drawn = false;
        const double took = 1000 * seconds([&] {
                                drawn = bool(renderer.draw(project, c, s));
                                renderer.finish();
                            });
        return drawn ? took : NAN;
    }
    // Of a drawn frame. bytes: of all renderers together.
    Counts counts(const ViewCamera& camera, ViewSettings s) {
        s.measure = true;
        frame(camera, s);
        Counts c;
        for (const PassStats& p : renderer.stats().passes) {
            c.vertices += static_cast<double>(p.vertices), c.fragments += static_cast<double>(p.fragments);
            if (p.name == "terrain/ground") c.nodes += static_cast<double>(p.instances);
        }
        c.nodes += static_cast<double>(renderer.stats().cells);
        c.bytes = static_cast<double>(renderer.stats().gpuBytes);
        std::fprintf(stderr, "%.0f m: %.0f vertices, %.0f fragments, %.0f nodes and cells, %lu blades\n",
                     project.registry.get<Terrain>(findEntity(project, "land"))->size.x, c.vertices, c.fragments,
                     c.nodes, static_cast<unsigned long>(renderer.stats().bladesGeometry));
        return c;
    }
};

// What is not seen costs nothing.
SWARD_LIMITS("prairie-size", [] {
    std::optional<Project> small = gpu() ? prairie(2000) : std::nullopt, large = gpu() ? prairie(90000) : std::nullopt;
    if (!small || !large) return reportLimit("a prairie of 90,000 m against 2,000 m", NAN, 1.01, "x");
    const ViewSettings s = sized(320, 240, 1);
    Sized a(std::move(*small));
    const Counts few = a.counts(a.feet(), s);
    Sized b(std::move(*large));
    const Counts many = b.counts(b.feet(), s);
    reportLimit("vertices of a prairie of 90,000 m as a share of one of 2,000 m", many.vertices / few.vertices, 1.01,
                "x");
    reportLimit("fragments of the same", many.fragments / few.fragments, 1.01, "x");
    reportLimit("nodes and cells of the same", many.nodes / few.nodes, 1.01, "x");
    reportLimit("bytes of the same", (many.bytes - few.bytes) / few.bytes, 1.01, "x");
    for (int i = 0; i < 9; ++i)
        for (Sized* t : {&a, &b}) t->ms.push_back(t->frame(t->feet(), s));
    reportLimit("time of the same, in turn", least(b.ms) / least(a.ms), 1.15, "x");
});

// Up to the horizon, where the haze ends what is seen, and drawn (terrain/lod.h).
SWARD_LIMITS("prairie-horizon", [] {
    constexpr double kSides[] = {90000, 2000, 4000, 8000};
    const ViewSettings s = sized(320, 240, 1);
    std::deque<Sized> all;
    std::vector<Counts> counts;
    for (const double side : kSides) {
        std::optional<Project> p = gpu() ? prairie(side) : std::nullopt;
        if (!p) return reportLimit("a prairie of 90,000 m up to the horizon", NAN, 1.01, "x");
        const int64_t before = gpu()->totalBytes();
        all.emplace_back(std::move(*p));
        counts.push_back(all.back().counts(all.back().camera(), s));
        counts.back().bytes -= static_cast<double>(before);
    }
    const Counts& most = counts[0];
    for (size_t i = 1; i < counts.size(); ++i) {
        const std::string what = fmt::format("up to the horizon, 90,000 m as a share of {:.0f}: ", kSides[i]);
        reportLimit((what + "vertices").c_str(), most.vertices / counts[i].vertices, 1.01, "x");
        reportLimit((what + "fragments").c_str(), most.fragments / counts[i].fragments, 1.01, "x");
        reportLimit((what + "nodes and cells").c_str(), most.nodes / counts[i].nodes, 1.01, "x");
        reportLimit((what + "bytes").c_str(), most.bytes / counts[i].bytes, 1.01, "x");
    }
    for (int i = 0; i < 7; ++i)
        for (Sized& t : all) t.ms.push_back(t.frame(t.camera(), s));
    for (size_t i = 1; i < all.size(); ++i)
        reportLimit(fmt::format("up to the horizon, 90,000 m as a share of {:.0f}: time, in turn", kSides[i]).c_str(),
                    least(all[0].ms) / least(all[i].ms), 1.15, "x");
});

// Levels of 255 that any channel of any pixel differs by between two pictures.
double mostDifferent(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
    if (a.size() != b.size()) return NAN;
    int most = 0;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(int(a[i]) - int(b[i])));
    return most;
}

SWARD_LIMITS("prairie-far", [] {
    std::optional<Project> p = gpu() ? prairie(300) : std::nullopt;
    if (!p) return reportLimit("a prairie moved by 90,000 m", NAN, 1, "levels");
    p->registry.get<Wind>(findEntity(*p, "wind"))->strength = 0;  // it blows over the world, not over the field
    Sized here(std::move(*p));
    const ViewSettings s = sized(320, 240, 1);
    here.frame(here.camera(), s);
    const auto before = here.renderer.readImage();
    const glm::dvec3 far(90000, 0, 90000);
    here.project.registry.add<Transform>(findEntity(here.project, "land"), {far});
    Camera& camera = *here.project.registry.get<Camera>(findEntity(here.project, "human"));
    camera.eye += far, camera.target += far;
    here.frame(here.camera(), s);
    reportLimit("a prairie moved by 90,000 m, at the worst pixel", mostDifferent(before, here.renderer.readImage()), 1,
                "levels");
});

}  // namespace
