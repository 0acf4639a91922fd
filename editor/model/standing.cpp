#include "model/standing.h"

#include <chrono>
#include <thread>

namespace sward {
namespace {

constexpr std::chrono::milliseconds kPatience{30};

void wait(const Job<bool>& job) {
    const auto begun = std::chrono::steady_clock::now();
    while (job.active() && !job.finished() && std::chrono::steady_clock::now() - begun < kPatience)
        std::this_thread::sleep_for(std::chrono::microseconds(200));
}

std::optional<Map> heightsOn(HeightLayers& layers, const Project& p) {
    const Map* made = layers.shown(p);
    return made ? std::optional(*made) : std::nullopt;
}

}  // namespace

void Standing::begin(const Project& p, uint64_t revision, std::span<const ComponentRow> rows) {
    maker_->of = snapshot(p, rows);
    maker_->revision = revision;
    job_ = Job<bool>(Lane::Waited, "the ground's layers", 0, [maker = maker_](JobControl&) -> Result<bool> {
        maker->heights = heightsOn(maker->layers, maker->of);
        return true;
    });
}

// Here, and not on the thread of jobs: whoever asks may be one of them.
void Standing::now(const Project& p, uint64_t revision, std::span<const ComponentRow> rows) {
    heights_ = heightsOn(maker_->layers, p), madeOf_ = revision;
    project_ = heights_ ? std::optional(standingOn(p, *heights_, rows)) : std::nullopt;
    draft_ = false;
}

// What is there by now is used, or what was there before.
void Standing::soon(const Project& p, uint64_t revision, std::span<const ComponentRow> rows) {
    for (int turn = 0; turn < 2 && madeOf_ != revision; ++turn) {  // the first may be of an older revision
        if (!job_.active()) begin(p, revision, rows);
        wait(job_);
        if (!job_.finished()) break;
        job_.take(0);
        heights_ = maker_->heights, madeOf_ = maker_->revision;
    }
    draft_ = madeOf_ != revision;
    const bool fits = heights_ && (!draft_ || findGround(p).terrain);
    project_ = fits ? std::optional(standingOn(p, *heights_, rows)) : std::nullopt;
}

const Project& Standing::of(const Project& p, uint64_t revision, std::span<const ComponentRow> rows) {
    if (!known_ || revision_ != revision) {
        known_ = true, revision_ = revision;
        if (hasHeightLayers(p) && patient)
            now(p, revision, rows);
        else if (hasHeightLayers(p))
            soon(p, revision, rows);
        else
            project_.reset(), heights_.reset(), draft_ = false;
    }
    return project_ ? *project_ : p;
}

bool Standing::follow() {
    if (!draft_ || !job_.finished()) return false;
    known_ = false;
    return true;
}

}  // namespace sward
