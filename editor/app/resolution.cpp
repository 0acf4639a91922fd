#include "app/resolution.h"

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

// Steps of a sixteenth, so that the renderer's targets are not made anew for every frame.
double quantized(double scale) { return std::clamp(std::floor(scale * 16 + 0.5) / 16, kMinScale, 1.0); }

void beginStrips(Resolution& r) {
    r.done = 0;
    r.stripsMs = 0;
    r.strip = r.fullMs <= kSlowMs ? 1 : std::clamp(kStripMs / r.fullMs, kMinStrip, 1.0);
}

void nextStrip(Resolution& r, ResolutionPlan& plan) {
    if (r.done <= 0 || r.stale) beginStrips(r);
    plan.draw = true;
    plan.from = r.done;
    plan.to = r.done + r.strip;
    if (1 - plan.to < r.strip / 2) plan.to = 1;  // no sliver remains
}

// Detail gives way when the smallest image is still too slow, and comes back first.
void learnMoving(Resolution& r, const ResolutionPlan& plan, double ms) {
    r.done = 0;
    r.drawnScale = plan.scale * 0.999;  // a whole image with fewer blades is not the full one yet
    if (r.fullMs <= 0) r.fullMs = ms / (plan.scale * plan.scale);
    const double ratio = kTargetMs / std::max(ms, 0.1);
    const bool slow = ms > kSlowMs, quick = ms < 0.6 * kTargetMs;
    if ((slow && plan.scale <= kMinScale) || (quick && plan.detail < 1))
        r.movingDetail = std::clamp(plan.detail * std::clamp(ratio, 0.4, 1.5), kMinDetail, 1.0);
    else if (slow || quick)
        r.movingScale = std::clamp(plan.scale * std::sqrt(ratio), std::max(kMinScale, plan.scale * 0.5),
                                   std::min(1.0, plan.scale * 1.25));
}

void learnFull(Resolution& r, double ms) {
    r.fullMs = ms;
    r.drawnScale = 1;
    if (ms <= kSlowMs)
        r.movingScale = r.movingDetail = 1;
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
        plan.detail = r.movingDetail;
    } else if (r.stale || (!moving && r.drawnScale < 1)) {
        nextStrip(r, plan);
    }
    plan.msaa = plan.scale < 1 ? 1 : 4;
    return plan;
}

void learnDrawing(Resolution& r, const ResolutionPlan& plan, double ms) {
    r.stale = false;
    if (plan.scale < 1 || plan.detail < 1) return learnMoving(r, plan, ms);
    r.stripsMs = plan.from <= 0 ? ms : r.stripsMs + ms;
    r.done = plan.to;
    r.strip = std::clamp((plan.to - plan.from) * std::clamp(kStripMs / std::max(ms, 0.1), 0.4, 2.0), kMinStrip, 1.0);
    if (plan.to < 1) {
        r.drawnScale = std::min(r.drawnScale, 0.999);
        return;
    }
    r.done = 0;
    learnFull(r, r.stripsMs);
}

double secondsToRefine(const Resolution& r, double now) {
    if (r.stale) return 0;
    if (r.drawnScale >= 1) return -1;
    return std::max(0.0, r.lastChange + kRestSeconds - now);
}

}  // namespace sward
