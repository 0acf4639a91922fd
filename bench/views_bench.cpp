// Whether any of many random views of the sample projects has a pixel that is no number or (but where the sun itself or
// its glint may be in sight) brighter than the lights can make it, an error of OpenGL, or takes over half a minute:
// from low and high, at any hour, by every technique, at one, four and eight samples a pixel, some a few pixels small.
// SWARD_VIEWS=FIRST-LAST: which views, by their numbers; 1-2000 if it is not given. Each number is one view for ever,
// so that a long trial may be cut into parts.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "bench/limits.h"
#include "cost/frame_estimate.h"
#include "project/project_files.h"
#include "techniques.h"
#include "tests/grass/bright_pixels.h"
#include "tests/programs_once.h"

namespace {
using namespace sward;
using namespace sward::test;

constexpr const char* kProjects[] = {"football", "park",    "meadow",  "wheat", "tornado", "lawn",
                                     "oasis",    "rockery", "prairie", "grove", "forest"};
constexpr double kLongestSeconds = 30;
constexpr double kBrightest = 4;     // times what the lights give
constexpr uint64_t kOfOneLook = 50;  // views one after another of one project by one technique at one time

struct Range {
    uint64_t first = 1, last = 2000;
};
Range asked() {
    Range r;
    if (const char* text = std::getenv("SWARD_VIEWS"))
        if (unsigned long a = 0, b = 0; std::sscanf(text, "%lu-%lu", &a, &b) == 2 && a >= 1 && a <= b) r = {a, b};
    return r;
}

double unit(uint64_t view, uint32_t k) {
    return static_cast<double>(f32::hashUnit(f32::hash3(static_cast<uint32_t>(view), k, 815)));
}

// Anywhere over the terrain or a little beside it, from within the grass to above the hills, looking anywhere.
ViewCamera anyPlace(const Project& p, uint64_t view) {
    const Ground ground = findGround(p);
    const glm::dvec2 at = ground.terrain->size * glm::dvec2(1.1 * unit(view, 0) - 0.05, 1.1 * unit(view, 1) - 0.05);
    const double up = terrainHeight(*ground.terrain, at.x, at.y) + 0.02 + 200 * std::pow(unit(view, 2), 6);
    const double around = 2 * M_PI * unit(view, 3),
                 down = M_PI * (unit(view, 4) - 0.5) * (unit(view, 5) < 0.5 ? 1 : 0.3);
    ViewCamera c;
    c.eye = ground.origin + glm::dvec3(at.x, up, at.y);
    c.target = c.eye + glm::dvec3(std::cos(around) * std::cos(down), std::sin(down), std::sin(around) * std::cos(down));
    c.fovDeg = 20 + 80 * unit(view, 6);
    return c;
}

// All fields by one technique; false if the project has none of grass.
bool setTechnique(Project& p, const TechniqueRow& row) {
    bool any = false;
    p.registry.each<GrassField>([&](Entity, GrassField& field) { field.technique = row.name, any = true; });
    return any;
}

// Whether the sun's disc, or its glint on water, may be in sight: they are as bright as they are.
bool seesSun(const Project& p, const ViewCamera& c, double time, int width, int height) {
    const Light* light = sunLight(p);
    if (!light) return false;
    const glm::dvec3 sun(directionTo(*light, time)), ahead = glm::normalize(c.target - c.eye);
    const double across = std::tan(0.5 * c.fovDeg * M_PI / 180) * std::max(1.0, double(width) / height);
    const double reach = std::cos(std::min(M_PI, std::atan(1.5 * across) + 0.2));
    return std::max(glm::dot(ahead, sun), glm::dot(ahead, sun * glm::dvec3(1, -1, 1))) > reach;
}

// When the views of a look are seen, in seconds from the project's own time; half of the looks at that time.
double timeOf(uint64_t view) {
    const double when = unit(view / kOfOneLook, 9);
    return when < 0.5 ? 0 : 4e6 * (when - 0.5);
}

struct Found {
    uint64_t views = 0, tooLong = 0, pixels = 0, errors = 0;
    double slowest = 0;
};

void look(Renderer& r, const Project& p, uint64_t view, Found& found) {
    constexpr int kSamples[] = {1, 4, 8};
    ViewSettings s;
    s.width = unit(view, 7) < 0.1 ? 1 + static_cast<int>(8 * unit(view, 8)) : 48, s.height = 36;
    s.msaa = kSamples[view % 3];
    s.time = timeOf(view);
    const ViewCamera place = anyPlace(p, view);
    if (mayBeLong(p) && estimateFrame(p, tables(), place, s.width, s.height).seconds > kLongestSeconds) {
        ++found.tooLong;
        return;
    }
    uint64_t wrong = 0;
    const double took = seconds([&] {
        if (!r.draw(p, place, s)) ++found.errors;
        const bool bright = seesSun(p, place, s.time, s.width, s.height);
        const double most = kBrightest * static_cast<double>(lightsGive(p, s.time));
        for (const float v : r.readLinear()) wrong += bright ? !std::isfinite(v) : !(static_cast<double>(v) <= most);
    });
    if (glGetError() != GL_NO_ERROR) ++found.errors;
    if (wrong > 0) std::fprintf(stderr, "view %lu of %s: %lu pixels\n", view, p.name.c_str(), wrong);
    found.pixels += wrong, ++found.views;
    found.slowest = std::max(found.slowest, took);
}

void measure() {
    const Range range = asked();
    const std::span<const TechniqueRow> techniques = tables().techniques;
    if (!gpu()) return reportLimit("a context of OpenGL", 0, -1, "");
    ProgramsOnce programs;  // a look's programs are the next one's for the most part
    programs.makeCurrent();
    Found found;
    for (uint64_t view = range.first; view <= range.last;) {
        const uint64_t block = view / kOfOneLook, end = std::min((block + 1) * kOfOneLook - 1, range.last);
        const char* name = kProjects[block % std::size(kProjects)];
        const TechniqueRow& technique = techniques[block / std::size(kProjects) % techniques.size()];
        auto project = loadProject(std::string(SWARD_SOURCE_DIR "/projects/") + name, tables().components);
        if (!project) return reportLimit("projects that open", 0, -1, "");
        setTechnique(*project, technique);
        Renderer r(*gpu(), tables());
        Found atFirst;  // programs and images of blades are made then, which is no frame's time
        const double begun = seconds([&] { look(r, *project, view, atFirst); });
        const double took = seconds([&] {
            for (; view <= end; ++view) look(r, *project, view, found);
        });
        std::fprintf(stderr, "%s by %s, to view %lu: begun in %.2g s, then all in %.3g s; slowest view %.2g s\n", name,
                     technique.name, end, begun, took, found.slowest);
    }
    std::fprintf(stderr, "%lu views; %lu more would take over %.0f s by their estimate\n", found.views, found.tooLong,
                 kLongestSeconds);
    reportLimit("pixels of random views that are no number or over 4 times the lights",
                found.views == 0 ? NAN : static_cast<double>(found.pixels), 0, "pixels");
    reportLimit("errors of OpenGL in random views", static_cast<double>(found.errors), 0, "");
    reportLimit("slowest of random views", found.slowest, kLongestSeconds, "s");
}
SWARD_LIMITS("random views", measure);

}  // namespace
