// How long a task still takes, told from what it took so far.
#pragma once
#include <chrono>
#include <string>

namespace sward {

// "40 s left", "2:05 left", "1:10 h left"; empty while too little is done to say (0.5% or 2 seconds), or all of it.
// share: of the work done, 0 to 1; seconds: that it took.
std::string timeLeft(double share, double seconds);

// A task's beginning, noted the first time that it is asked about; `active` false forgets it.
struct Stopwatch {
    bool runs = false;
    std::chrono::steady_clock::time_point begun;
    // Seconds since it began; 0 at first and while not active.
    double of(bool active);
};

}  // namespace sward
