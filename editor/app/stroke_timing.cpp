#include "app/stroke_timing.h"

#include <algorithm>
#include <cmath>

#include "app/frame_clock.h"
#include "core/log.h"
#include "model/document.h"

namespace sward {
namespace {

TimedView viewOf(const Document& doc, const TimingState& s) {
    return {doc.revision(), s.camera, s.shown.width, s.shown.height, s.shown.time};
}

// Headless frames are small, the same on every machine.
ViewSettings settingsOf(const TimingState& s, const FrameClock& clock) {
    const double scale = clock.fixed ? 0.25 : timingScale(s.fullMs);
    ViewSettings out;
    out.width = std::max(1, static_cast<int>(s.shown.width * scale));
    out.height = std::max(1, static_cast<int>(s.shown.height * scale));
    out.msaa = clock.fixed ? 1 : s.shown.msaa;
    out.time = s.shown.time;
    out.background = !clock.fixed;
    return out;
}

// Both states; false if they ask for different features, so that programs would be compiled in every frame.
bool prepare(StrokeTiming& t, const Document& doc) {
    const std::span<const ComponentRow> rows = doc.tables().components;
    t.now = std::make_unique<Project>(snapshot(doc.visibleProject(), rows));
    t.before = std::make_unique<Project>(snapshot(*t.now, rows));
    for (const auto& [path, map] : *doc.strokeBefore())
        if (const auto field = findField(*t.before, rows, path)) static_cast<MapField*>(field->value)->map = map;
    return sceneFeatures(t.before->registry, doc.tables()) == sceneFeatures(t.now->registry, doc.tables());
}

void release(StrokeTiming& t) {
    t.due = false;
    t.before.reset();
    t.now.reset();
}

void drawOne(StrokeTiming& t, const TimingParts& parts, const TimingState& state) {
    if (!t.now) {
        t.settings = settingsOf(state, parts.clock);
        if (!prepare(t, parts.doc)) return release(t);
    }
    const Status drawn =
        drawNext(t.frames, {{{parts.renderer, *t.now}, {parts.renderer, *t.before}}}, state.camera, t.settings);
    if (!drawn) {
        logWarning("the stroke is not timed: " + drawn.error().text());
        return release(t);
    }
    if (!allDrawn(t.frames)) return;
    t.ms = msBetween(t.frames), t.blades = bladesBetween(t.frames);
    parts.clock.wanted = 2;
    release(t);
}

}  // namespace

bool TimedView::operator==(const TimedView& o) const {
    return revision == o.revision && camera.eye == o.camera.eye && camera.target == o.camera.target &&
           camera.fovDeg == o.camera.fovDeg && camera.exposure == o.camera.exposure && width == o.width &&
           height == o.height && seconds == o.seconds;
}

void dropTiming(StrokeTiming& t) {
    StrokeTiming fresh;
    fresh.on = t.on, fresh.lastEvent = t.lastEvent;
    t = std::move(fresh);
}

double timingScale(double fullMs) {
    return fullMs > kTimingFrameMs ? std::max(0.25, std::sqrt(kTimingFrameMs / fullMs)) : 1;
}

void followStroke(StrokeTiming& t, const TimingParts& parts, const TimingState& state) {
    if (state.restless) t.lastEvent = parts.clock.now;
    const bool any = t.on && parts.doc.isOpen() && !parts.doc.play() && parts.doc.strokeBefore();
    if (!any || parts.doc.stroking()) return dropTiming(t);
    if (const TimedView view = viewOf(parts.doc, state); !(view == t.view)) {
        dropTiming(t);
        t.view = view;
        t.due = true;
    }
    if (!t.due) return;
    t.blocked = !state.free;
    if (secondsToTiming(t, parts.clock.now) != 0) return interrupt(t.frames);
    drawOne(t, parts, state);
}

double secondsToTiming(const StrokeTiming& t, double now) {
    return t.due && !t.blocked ? std::max(0.0, t.lastEvent + kTimingRestSeconds - now) : -1;
}

}  // namespace sward
