// One interface for what a pass costs: milliseconds and pipeline counts.
// On a software renderer glFinish and a steady clock (its timer queries report a few percent of the truth);
// elsewhere GL_TIME_ELAPSED. Counts come from ARB_pipeline_statistics_query where the driver has it, else 0.
// Does not: average; a caller that wants a median takes it.
#pragma once
#include <chrono>

#include "gpu/gpu.h"

namespace sward {

struct GpuCost {
    double ms = 0;
    uint64_t vertices = 0;   // vertex shader invocations
    uint64_t fragments = 0;  // fragment shader invocations
};

class GpuTimer {
  public:
    explicit GpuTimer(const Gpu& gpu);
    ~GpuTimer();
    GpuTimer(const GpuTimer&) = delete;
    GpuTimer& operator=(const GpuTimer&) = delete;
    // Begins to measure; one measurement at a time, ended by end().
    void begin();
    // What was drawn since begin() cost. Waits for the GPU.
    GpuCost end();

    // How times are taken on this GPU, as statistics name it: "wall-finish" or "gpu-timer".
    static const char* kind(const Gpu& gpu) { return gpu.software ? "wall-finish" : "gpu-timer"; }

  private:
    bool software_ = false, counts_ = false;
    GLuint queries_[3] = {0, 0, 0};  // time, vertices, fragments
    std::chrono::steady_clock::time_point start_;
};

}  // namespace sward
