#include "app/time_left.h"

#include <fmt/format.h>

#include <cmath>

namespace sward {

std::string timeLeft(double share, double seconds) {
    if (!(share >= 0.005) || !(seconds >= 2) || share >= 1) return "";
    const long left = std::lround(seconds * (1 - share) / share);
    if (left < 60) return fmt::format("{} s left", std::max(left, 1L));
    if (left < 3600) return fmt::format("{}:{:02d} left", left / 60, left % 60);
    return fmt::format("{}:{:02d} h left", left / 3600, left / 60 % 60);
}

double Stopwatch::of(bool active) {
    const auto now = std::chrono::steady_clock::now();
    if (active && !runs) begun = now;
    runs = active;
    return active ? std::chrono::duration<double>(now - begun).count() : 0;
}

}  // namespace sward
