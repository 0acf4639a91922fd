#include "app/long_frame.h"

#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "core/hash.h"
#include "scene/project.h"

namespace sward {
namespace {

constexpr double kShownSeconds = 1;  // that a picture may take where all blades would take too long

uint64_t grassOf(const Project& p) {
    std::string kinds;
    p.registry.each<GrassField>([&](Entity, const GrassField& f) {
        kinds += f.technique + '\n';
        for (const Species& s : f.species) kinds += fmt::format("{} {}\n", s.bladesPerM2, f.cellSize);
    });
    return hashBytes(kinds.data(), kinds.size());
}

bool sameView(const LongFrame& f, const LongView& v) {
    return f.revision == v.revision && f.camera.eye == v.camera.eye && f.camera.target == v.camera.target &&
           f.camera.fovDeg == v.camera.fovDeg && f.width == v.width && f.height == v.height;
}

void estimate(LongFrame& f, const LongView& v) {
    f.seconds = 0;
    if (!mayBeLong(v.project)) return;
    const FrameEstimate e = estimateFrame(v.project, v.tables, v.camera, v.width, v.height);
    if (e.seconds <= kLongFrame) return;
    f.seconds = e.seconds;
    f.slowest = e.fields.front();
}

}  // namespace

void followLongFrame(LongFrame& f, const LongView& v, bool atRest) {
    const uint64_t grass = grassOf(v.project);
    if (grass == f.grass && (!atRest || sameView(f, v))) return;
    if (grass != f.grass) f.all = false;
    f.grass = grass, f.revision = v.revision, f.camera = v.camera, f.width = v.width, f.height = v.height;
    estimate(f, v);
}

double shareOfBlades(const LongFrame& f) { return f.seconds > 0 && !f.all ? kShownSeconds / f.seconds : 1; }

std::string longFrameNotice(const LongFrame& f) {
    if (!(f.seconds > 0)) return {};
    const std::string all =
        fmt::format("All {:.0f} million blades of {} ({}) ", static_cast<double>(f.slowest.blades) / 1e6,
                    f.slowest.entity, f.slowest.technique);
    if (f.all) return all + fmt::format("take about {:.0f} s a frame.", f.seconds);
    return all +
           fmt::format("would take about {:.0f} s a frame: 1 in {:.0f} is drawn.", f.seconds, 1 / shareOfBlades(f));
}

}  // namespace sward
