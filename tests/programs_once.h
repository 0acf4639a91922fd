// Compiles programs of equal sources once a context, at libepoxy's function pointers: each test makes a renderer of its
// own, and a software driver would spend most of the time of all tests on compiling what it compiled before.
// Does not: change what a renderer asks for, names or forgets, nor keep anything that failed to compile or to link.
#pragma once
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sward::test {

namespace programs_once {

// What the driver keeps of one context.
struct Kept {
    EGLContext context = EGL_NO_CONTEXT;
    std::map<GLuint, std::string> sources;   // of the shaders that live
    std::set<GLuint> postponed;              // shaders whose source compiled before; compiled where a new program asks
    std::vector<GLuint> sinceProgram;        // shaders made since the last program was
    std::set<std::string> compiles;          // sources that did
    std::map<GLuint, std::string> unlinked;  // programs made and not linked yet, by the sources of all their stages
    std::map<std::string, GLuint> programs;  // those linked, by these sources
    std::set<GLuint> linked;
};
inline Kept* latest = nullptr;
// Of the context that is current; null: every program is compiled.
inline Kept* keptHere() { return latest && latest->context == eglGetCurrentContext() ? latest : nullptr; }

template <auto& pointer>
inline std::remove_reference_t<decltype(pointer)> original = nullptr;

inline void shaderSource(GLuint shader, GLsizei count, const GLchar* const* text, const GLint* lengths) {
    Kept* kept = keptHere();
    original<epoxy_glShaderSource>(shader, count, text, lengths);
    if (!kept) return;
    GLint stage = 0;
    original<epoxy_glGetShaderiv>(shader, GL_SHADER_TYPE, &stage);
    kept->sources[shader] = std::to_string(stage) + text[0];
    kept->sinceProgram.push_back(shader);
}
inline void compileShader(GLuint shader) {
    Kept* kept = keptHere();
    if (kept && kept->compiles.contains(kept->sources[shader])) {
        kept->postponed.insert(shader);
        return;
    }
    original<epoxy_glCompileShader>(shader);
    GLint compiled = 0;
    original<epoxy_glGetShaderiv>(shader, GL_COMPILE_STATUS, &compiled);
    if (kept && compiled) kept->compiles.insert(kept->sources[shader]);
}
inline void getShaderiv(GLuint shader, GLenum what, GLint* value) {
    Kept* kept = keptHere();
    if (kept && what == GL_COMPILE_STATUS && kept->postponed.contains(shader))
        *value = GL_TRUE;
    else
        original<epoxy_glGetShaderiv>(shader, what, value);
}
inline void deleteShader(GLuint shader) {
    Kept* kept = keptHere();
    original<epoxy_glDeleteShader>(shader);
    if (!kept) return;
    kept->sources.erase(shader);
    kept->postponed.erase(shader);
}
inline GLuint createProgram() {
    Kept* kept = keptHere();
    if (!kept) return original<epoxy_glCreateProgram>();
    std::string sources;
    for (const GLuint shader : std::exchange(kept->sinceProgram, {}))
        if (const auto it = kept->sources.find(shader); it != kept->sources.end()) sources += it->second;
    if (const auto it = kept->programs.find(sources); it != kept->programs.end()) return it->second;
    const GLuint program = original<epoxy_glCreateProgram>();
    kept->unlinked[program] = sources;
    return program;
}
inline void attachShader(GLuint program, GLuint shader) {
    Kept* kept = keptHere();
    if (kept && kept->linked.contains(program)) return;
    if (kept && kept->postponed.erase(shader)) original<epoxy_glCompileShader>(shader);
    original<epoxy_glAttachShader>(program, shader);
}
inline void linkProgram(GLuint program) {
    Kept* kept = keptHere();
    if (kept && kept->linked.contains(program)) return;
    original<epoxy_glLinkProgram>(program);
    if (!kept) return;
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    const auto made = kept->unlinked.extract(program);
    if (!linked || made.empty()) return;
    kept->programs[made.mapped()] = program;
    kept->linked.insert(program);
}
inline void deleteProgram(GLuint program) {
    Kept* kept = keptHere();
    if (!kept || !kept->linked.contains(program)) original<epoxy_glDeleteProgram>(program);
}

template <auto& pointer>
void hook(std::remove_reference_t<decltype(pointer)> with) {
    original<pointer> = std::exchange(pointer, with);
}
// libepoxy's pointers name the driver's functions from their first call on, and would write over a hook before.
inline void hookAll() {
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER), program = glCreateProgram();
    const GLchar* text = "#version 450 core\nvoid main() {}\n";
    GLint compiled = 0;
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    glAttachShader(program, shader);
    glLinkProgram(program);
    glDeleteShader(shader);
    glDeleteProgram(program);
    hook<epoxy_glShaderSource>(&shaderSource);
    hook<epoxy_glCompileShader>(&compileShader);
    hook<epoxy_glGetShaderiv>(&getShaderiv);
    hook<epoxy_glDeleteShader>(&deleteShader);
    hook<epoxy_glCreateProgram>(&createProgram);
    hook<epoxy_glAttachShader>(&attachShader);
    hook<epoxy_glLinkProgram>(&linkProgram);
    hook<epoxy_glDeleteProgram>(&deleteProgram);
}

}  // namespace programs_once

// The programs of one context. To be made, or made current, with it; it may outlive the context if no other is drawn
// with.
class ProgramsOnce {
  public:
    void makeCurrent() {
        static const bool hooked = (programs_once::hookAll(), true);
        kept_.context = eglGetCurrentContext();
        programs_once::latest = hooked ? &kept_ : nullptr;
    }
    ~ProgramsOnce() {
        if (programs_once::latest == &kept_) programs_once::latest = nullptr;
    }

  private:
    programs_once::Kept kept_;
};

}  // namespace sward::test
