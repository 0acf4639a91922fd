// What the editor's last frames took on the wall, and of that its panels: for the graph of the profiler.
// Does not: measure (app.cpp does), nor count waiting for input.
#pragma once
#include <array>
#include <cstddef>

namespace sward {

inline constexpr size_t kFramesKept = 240;
inline constexpr float kLeastBudgetMs = 1, kMostBudgetMs = 1000;

struct FrameTime {
    float all = 0;     // ms
    float panels = 0;  // ms of it: building and drawing widgets, without the viewport's picture
};
struct FrameTimes {
    std::array<FrameTime, kFramesKept> ring = {};
    size_t count = 0;              // of all frames so far
    float budgetMs = 1000 / 60.f;  // what a frame may take: the line of the graph
    bool dragging = false;         // the line is in the hand
};

// The next frame's; the oldest goes.
void addFrame(FrameTimes& times, FrameTime frame);
// How many are kept now.
size_t keptFrames(const FrameTimes& times);
// i: from 0, the oldest kept, to keptFrames - 1.
FrameTime frameAt(const FrameTimes& times, size_t i);

struct FrameSummary {
    float median = 0, slowest = 0;  // ms of a whole frame
    float panels = 0;               // median ms of the panels
    size_t over = 0;                // frames beyond the budget
};
// Of those kept; zeros before the first.
FrameSummary summaryOf(const FrameTimes& times);

}  // namespace sward
