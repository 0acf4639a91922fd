#include "gpu/timer.h"

namespace sward {

GpuTimer::GpuTimer(const Gpu& gpu)
    : software_(gpu.software), counts_(epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query")) {
    glGenQueries(3, queries_);  // glCreateQueries refuses pipeline statistics on Mesa 22
}
GpuTimer::~GpuTimer() { glDeleteQueries(3, queries_); }

void GpuTimer::begin() {
    if (software_)
        glFinish();
    else
        glBeginQuery(GL_TIME_ELAPSED, queries_[0]);
    if (counts_) {
        glBeginQuery(GL_VERTEX_SHADER_INVOCATIONS_ARB, queries_[1]);
        glBeginQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB, queries_[2]);
    }
    start_ = std::chrono::steady_clock::now();
}

GpuCost GpuTimer::end() {
    GpuCost cost;
    if (counts_) {
        glEndQuery(GL_VERTEX_SHADER_INVOCATIONS_ARB);
        glEndQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
    }
    if (software_) {
        glFinish();
        cost.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    } else {
        glEndQuery(GL_TIME_ELAPSED);
        GLuint64 ns = 0;
        glGetQueryObjectui64v(queries_[0], GL_QUERY_RESULT, &ns);
        cost.ms = static_cast<double>(ns) * 1e-6;
    }
    if (counts_) {
        GLuint64 n = 0;
        glGetQueryObjectui64v(queries_[1], GL_QUERY_RESULT, &n);
        cost.vertices = n;
        glGetQueryObjectui64v(queries_[2], GL_QUERY_RESULT, &n);
        cost.fragments = n;
    }
    return cost;
}

}  // namespace sward
