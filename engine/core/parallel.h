// A loop over independent pieces of work on all cores.
// Does not: report progress or stop early; long work that the user waits for is a job of its own.
#pragma once
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace sward {

// Calls f(i) once for each i in [0, n), on the calling thread and as many more as there are cores; returns when all
// are done. f must not throw.
template <class F>
void parallelFor(size_t n, F&& f) {
    std::atomic<size_t> next{0};
    const auto work = [&] {
        for (size_t i = next++; i < n; i = next++) f(i);
    };
    const size_t cores = std::max<size_t>(1, std::thread::hardware_concurrency());
    std::vector<std::jthread> helpers;
    for (size_t t = 1; t < std::min(cores, n); ++t) helpers.emplace_back(work);
    work();
}

}  // namespace sward
