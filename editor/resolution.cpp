#include "resolution.h"

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

// Steps of a sixteenth, so that the renderer's targets are not made anew for every frame.
double quantized(double scale) { return std::clamp(std::floor(scale * 16 + 0.5) / 16, kMinScale, 1.0); }

int gridFor(double fullMs) {
    if (fullMs <= kSlowMs) return 1;
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(fullMs / kTargetMs))), 2, kMaxGrid);
}

void beginParts(Resolution& r) {
    r.part = 0;
    r.partsMs = 0;
    r.grid = gridFor(r.fullMs);
}

void learnWhole(Resolution& r, double ms) {
    r.fullMs = ms;
    r.drawnScale = 1;
    if (ms <= kSlowMs)
        r.movingScale = 1;
    else if (r.movingScale >= 1)
        r.movingScale = std::clamp(std::sqrt(kTargetMs / ms), kMinScale, 1.0);
}

}  // namespace

ResolutionPlan planDrawing(Resolution& r, double now, bool changed) {
    if (changed) {
        r.lastChange = now;
        r.stale = true;
    }
    const bool moving = now - r.lastChange < kRestSeconds;
    ResolutionPlan plan;
    if (r.stale && moving) {
        plan.draw = true;
        plan.scale = quantized(r.movingScale);
    } else if (r.stale || (!moving && r.drawnScale < 1)) {
        if (r.part == 0 || r.stale) beginParts(r);
        plan.draw = true;
        plan.grid = r.grid;
        plan.part = r.part;
    }
    plan.msaa = plan.scale < 1 ? 1 : 4;
    return plan;
}

void learnDrawing(Resolution& r, const ResolutionPlan& plan, double ms) {
    r.stale = false;
    if (plan.scale < 1) {
        r.part = 0;
        r.drawnScale = plan.scale;
        if (r.fullMs <= 0) r.fullMs = ms / (plan.scale * plan.scale);
        const double fitting = plan.scale * std::sqrt(kTargetMs / std::max(ms, 0.1));
        if (ms > kSlowMs || ms < 0.6 * kTargetMs)
            r.movingScale = std::clamp(fitting, std::max(kMinScale, plan.scale * 0.5), std::min(1.0, plan.scale * 1.25));
        return;
    }
    r.partsMs = plan.part == 0 ? ms : r.partsMs + ms;
    r.part = plan.part + 1;
    if (r.part < plan.grid * plan.grid) {
        r.drawnScale = std::min(r.drawnScale, 0.999);
        return;
    }
    r.part = 0;
    learnWhole(r, r.partsMs);
}

double secondsToRefine(const Resolution& r, double now) {
    if (r.stale) return 0;
    if (r.drawnScale >= 1) return -1;
    return std::max(0.0, r.lastChange + kRestSeconds - now);
}

}  // namespace sward
