#include "app/frame_times.h"

#include <algorithm>
#include <vector>

namespace sward {

void addFrame(FrameTimes& times, FrameTime frame) { times.ring[times.count++ % kFramesKept] = frame; }

size_t keptFrames(const FrameTimes& times) { return std::min(times.count, kFramesKept); }

FrameTime frameAt(const FrameTimes& times, size_t i) {
    return times.ring[(times.count - keptFrames(times) + i) % kFramesKept];
}

FrameSummary summaryOf(const FrameTimes& times) {
    FrameSummary s;
    const size_t n = keptFrames(times);
    if (n == 0) return s;
    std::vector<float> all, panels;
    for (size_t i = 0; i < n; ++i) all.push_back(frameAt(times, i).all), panels.push_back(frameAt(times, i).panels);
    std::sort(all.begin(), all.end());
    std::sort(panels.begin(), panels.end());
    s.median = all[n / 2], s.slowest = all.back(), s.panels = panels[n / 2];
    s.over = static_cast<size_t>(all.end() - std::upper_bound(all.begin(), all.end(), times.budgetMs));
    return s;
}

}  // namespace sward
