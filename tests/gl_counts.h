// What OpenGL counts while something is drawn. Does not: count calls (gl_calls.h).
#pragma once
#include <epoxy/gl.h>

#include <cstdint>
#include <functional>

namespace sward::test {

// what: a target of queries, such as GL_CLIPPING_INPUT_PRIMITIVES_ARB, that nothing within `work` asks for itself.
inline uint64_t counted(GLenum what, const std::function<void()>& work) {
    GLuint query = 0;
    glGenQueries(1, &query);  // glCreateQueries refuses pipeline statistics on Mesa 22
    glBeginQuery(what, query);
    work();
    glEndQuery(what);
    GLuint64 n = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &n);
    glDeleteQueries(1, &query);
    return n;
}

}  // namespace sward::test
