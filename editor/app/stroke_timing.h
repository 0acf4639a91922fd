// What the last stroke adds to a frame of the view that is shown, measured: the scene with it and as it was before,
// in turn (cost/paired_frames.h), a frame at a time and only while the person and everything else rest; whatever comes
// in meanwhile comes first, and the measurement goes on after it if it still is of what is shown. Drawn by the
// viewport's own renderer, which has all that it needs; the picture on the screen stays.
// Does not: estimate (tools/brush_cost.h does, until this is done), nor time a stroke that made the map it painted: the
// scene asked for other programs before it.
// Cost: 28 frames a stroke, each of at most about kTimingFrameMs.
#pragma once
#include <memory>
#include <optional>

#include "cost/paired_frames.h"
#include "scene/project.h"
#include "world/view_camera.h"

namespace sward {

class Document;
struct FrameClock;

inline constexpr double kTimingFrameMs = 100;      // slower views are timed by smaller pictures
inline constexpr double kTimingRestSeconds = 0.5;  // without an event before a frame is drawn

// What is measured; once it differs all that was measured is dropped.
struct TimedView {
    uint64_t revision = ~uint64_t(0);
    ViewCamera camera;
    int width = 0, height = 0;  // pixels of the viewport
    double seconds = 0;         // scene time
    bool operator==(const TimedView& o) const;
};
struct StrokeTiming {
    bool on = true;  // the person's setting
    TimedView view;
    std::unique_ptr<Project> before, now;  // while it is measured
    ViewSettings settings;                 // of its frames
    PairedFrames frames{.settles = true};
    bool due = false;      // frames are still to be drawn, once all rests
    bool blocked = false;  // by something else that is being made or measured
    double lastEvent = 0;  // seconds
    // Once all frames are there: the ms and the blades drawn that the stroke adds to a frame.
    std::optional<PairedDifference> ms, blades;
};

// What it is done with.
struct TimingParts {
    const Document& doc;
    Renderer& renderer;  // the viewport's
    FrameClock& clock;   // more frames are wanted once there is something to show
};
// What the viewport shows and does.
struct TimingState {
    ViewCamera camera;
    ViewSettings shown;     // at the viewport's size
    double fullMs = 0;      // what a full picture takes, as far as is known; 0: nothing is known
    bool restless = false;  // an event came in, or something is held or moves
    bool free = false;      // the picture is whole, and nothing else is being made or measured
};
// Once a frame, after the panels: draws the next frame that is due, if all rests.
void followStroke(StrokeTiming& timing, const TimingParts& parts, const TimingState& state);
// Seconds until a frame is to be drawn though nothing comes in; 0: now; negative: none is due.
double secondsToTiming(const StrokeTiming& timing, double now);
// Drops what was measured; the setting stays.
void dropTiming(StrokeTiming& timing);
// The side by which pictures are smaller than the view so that a frame takes no more than kTimingFrameMs: 0.25 to 1.
double timingScale(double fullMs);

}  // namespace sward
