#include "resolution.h"

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

// Steps of a sixteenth, so that the renderer's targets are not made anew for every frame.
double quantized(double scale) { return std::clamp(std::floor(scale * 16 + 0.5) / 16, kMinScale, 1.0); }

}  // namespace

ResolutionPlan planDrawing(Resolution& r, double now, bool changed) {
    if (changed) {
        r.lastChange = now;
        r.stale = true;
    }
    const bool moving = now - r.lastChange < kRestSeconds;
    ResolutionPlan plan;
    if (r.stale) {
        plan.draw = true;
        plan.scale = moving ? quantized(r.movingScale) : 1;
    } else if (!moving && r.drawnScale < 1) {
        plan.draw = true;
        plan.scale = r.drawnScale < 0.5 ? 0.5 : 1;  // a step between, so that input never waits for two drawings
    }
    plan.msaa = plan.scale < 1 ? 1 : 4;
    return plan;
}

void learnDrawing(Resolution& r, double scale, double ms) {
    r.drawnScale = scale;
    r.stale = false;
    const double fitting = scale * std::sqrt(kTargetMs / std::max(ms, 0.1));
    if (scale >= 1) {
        if (ms <= kSlowMs)
            r.movingScale = 1;
        else if (r.movingScale >= 1)
            r.movingScale = std::clamp(fitting, kMinScale, 1.0);
        return;
    }
    if (ms > kSlowMs || ms < 0.6 * kTargetMs) r.movingScale = std::clamp(fitting, std::max(kMinScale, scale * 0.5), std::min(1.0, scale * 1.25));
}

double secondsToRefine(const Resolution& r, double now) {
    if (r.stale) return 0;
    if (r.drawnScale >= 1) return -1;
    return std::max(0.0, r.lastChange + kRestSeconds - now);
}

}  // namespace sward
