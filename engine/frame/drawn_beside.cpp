#include "frame/drawn_beside.h"

#include <chrono>
#include <thread>

#include "scene/ground_path.h"
#include "scene/map_layers.h"

namespace sward {
namespace {

constexpr std::chrono::milliseconds kPatience{30};

// Waits for its end, at most so long; none: however long.
void wait(const Job<bool>& job, std::optional<std::chrono::milliseconds> most) {
    const auto begun = std::chrono::steady_clock::now();
    while (job.active() && !job.finished() && (!most || std::chrono::steady_clock::now() - begun < *most))
        std::this_thread::sleep_for(std::chrono::microseconds(200));
}

// Whether anything may change maps: else nothing is copied.
bool mayChange(const Project& p) { return hasLayers(p) || firstOf<GroundPath>(p); }

}  // namespace

// Takes what is finished.
void DrawnBeside::take(std::span<const ComponentRow> rows) {
    if (!job_.finished()) return;
    job_.take(0);
    shown_ = snapshot(*maker_->made, rows);
    notes_ = maker_->drawn.layerNotes();
}

void DrawnBeside::begin(const Project& p, std::span<const ComponentRow> rows) {
    maker_->of = snapshot(p, rows);
    job_ = Job<bool>(Lane::Waited, "layers", 0, [maker = maker_, rows](JobControl&) -> Result<bool> {
        maker->made = &maker->drawn.of(maker->of, rows);
        return true;
    });
}

const Project& DrawnBeside::now(const Project& p, std::span<const ComponentRow> rows) {
    wait(job_, {});
    take(rows);
    const Project& made = maker_->drawn.of(p, rows);
    notes_ = maker_->drawn.layerNotes();
    shown_.reset();
    return made;
}

const Project& DrawnBeside::soon(const Project& p, std::span<const ComponentRow> rows) {
    take(rows);
    if (!mayChange(p)) {
        if (!job_.active()) return now(p, rows);
        shown_.reset();
        return p;
    }
    if (!job_.active()) begin(p, rows);
    wait(job_, kPatience);
    take(rows);
    return shown_ && shown_->dir == p.dir ? *shown_ : p;
}

void DrawnBeside::news(std::vector<JobNews>& out) const {
    if (job_.active()) out.push_back(job_.news());
}

}  // namespace sward
