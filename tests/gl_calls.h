// Counts a frame's calls of OpenGL and the bytes that it hands over, at libepoxy's function pointers.
// Does not: see calls of functions that no line below names; a test reads the engine's sources and finds such.
#pragma once
#include <epoxy/gl.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace sward::test {

struct GlCalls {
    uint64_t calls = 0, bytes = 0, textureUploads = 0, reads = 0;
    std::map<std::string_view, uint64_t> byName;
};
inline GlCalls glCalls;
inline std::string glCallsByName() {
    std::string out;
    for (const auto& [name, n] : glCalls.byName) out += std::to_string(n) + " " + std::string(name) + "\n";
    return out;
}

namespace gl_calls {
template <auto& pointer>
struct Hook;
template <class R, class... A, R (*&pointer)(A...)>
struct Hook<pointer> {
    static inline R (*original)(A...) = nullptr;
    static inline const char* name = nullptr;
    static R call(A... a) {
        ++glCalls.calls;
        ++glCalls.byName[name];
        if constexpr (static_cast<const void*>(&pointer) == static_cast<const void*>(&epoxy_glNamedBufferSubData))
            addBytes(a...);
        if constexpr (static_cast<const void*>(&pointer) == static_cast<const void*>(&epoxy_glTextureSubImage2D) ||
                      static_cast<const void*>(&pointer) == static_cast<const void*>(&epoxy_glTextureSubImage3D) ||
                      static_cast<const void*>(&pointer) ==
                          static_cast<const void*>(&epoxy_glCompressedTextureSubImage3D))
            ++glCalls.textureUploads;
        if constexpr (static_cast<const void*>(&pointer) == static_cast<const void*>(&epoxy_glGetNamedBufferSubData) ||
                      static_cast<const void*>(&pointer) == static_cast<const void*>(&epoxy_glGetTextureImage))
            ++glCalls.reads;
        return original(a...);
    }
    static void addBytes(GLuint, GLintptr, GLsizeiptr size, const void*) {
        glCalls.bytes += static_cast<uint64_t>(size);
    }
    static void set(bool on, const char* called) {
        name = called;
        if (on)
            original = pointer, pointer = &call;
        else
            pointer = original;
    }
};
}  // namespace gl_calls

// The functions counted; clang-format would step every row to the right.
// clang-format off
#define SWARD_GL_CALLS(X) \
    X(glAttachShader) X(glBeginQuery) X(glBindBuffer) X(glBindBufferBase) X(glBindBuffersBase) X(glBindFramebuffer) X(glBindImageTexture) \
    X(glBindTextureUnit) X(glBindTextures) X(glBindVertexArray) X(glBlendEquation) X(glBlendEquationi) X(glBlendEquationSeparate) \
    X(glBlendFunc) X(glBlendFuncSeparate) X(glBlitNamedFramebuffer) X(glCheckNamedFramebufferStatus) X(glClear) \
    X(glClearColor) X(glClearDepth) X(glClearNamedBufferData) X(glClearNamedFramebufferfi) \
    X(glClearNamedFramebufferfv) X(glClearStencil) X(glClientWaitSync) X(glClipControl) X(glColorMask) \
    X(glCompileShader) X(glCompressedTextureSubImage3D) X(glCreateBuffers) X(glCreateFramebuffers) X(glCreateProgram) X(glCreateShader) \
    X(glCreateTextures) X(glCreateVertexArrays) X(glDebugMessageCallback) X(glDebugMessageControl) \
    X(glDeleteBuffers) X(glDeleteFramebuffers) X(glDeleteProgram) X(glDeleteQueries) X(glDeleteShader) \
    X(glDeleteSync) X(glDeleteTextures) X(glDeleteVertexArrays) X(glCopyImageSubData) X(glCullFace) X(glDepthFunc) X(glDepthMask) X(glDisable) \
    X(glDisableVertexArrayAttrib) X(glDispatchCompute) X(glDispatchComputeIndirect) X(glDrawArrays) \
    X(glDrawArraysIndirect) X(glDrawArraysInstanced) X(glDrawElements) X(glDrawElementsInstanced) \
    X(glDrawElementsInstancedBaseInstance) X(glEnable) X(glEnableVertexArrayAttrib) X(glEndQuery) X(glFenceSync) \
    X(glFinish) X(glFrontFace) X(glGenQueries) X(glGenerateTextureMipmap) X(glGetError) X(glGetIntegerv) X(glGetInternalformativ) \
    X(glGetNamedBufferSubData) X(glGetProgramInfoLog) X(glGetProgramiv) X(glGetQueryObjectui64v) \
    X(glGetShaderInfoLog) X(glGetShaderiv) X(glGetString) X(glGetTextureImage) X(glGetTextureLevelParameteriv) \
    X(glLinkProgram) X(glMemoryBarrier) X(glMultiDrawArraysIndirect) X(glMultiDrawElementsIndirect) \
    X(glNamedBufferStorage) X(glNamedBufferSubData) X(glNamedFramebufferDrawBuffer) X(glNamedFramebufferDrawBuffers) X(glNamedFramebufferTexture) \
    X(glNamedFramebufferTextureLayer) X(glObjectLabel) X(glPatchParameteri) X(glPixelStorei) X(glPopDebugGroup) \
    X(glPushDebugGroup) X(glShaderSource) X(glStencilFunc) X(glStencilMask) X(glStencilOp) X(glTextureBarrier) \
    X(glTextureParameterf) X(glTextureParameteri) X(glTextureStorage2D) X(glTextureStorage2DMultisample) \
    X(glTextureStorage3D) X(glTextureSubImage2D) X(glTextureSubImage3D) X(glUniform1f) X(glUniform1i) \
    X(glUniform1ui) X(glUniform2f) X(glUniform2i) X(glUniform3f) X(glUniform3ui) X(glUniform4f) X(glUniform4fv) X(glUniform4ui) X(glUniformMatrix4fv) X(glPolygonOffset) X(glUseProgram) \
    X(glVertexArrayAttribBinding) X(glVertexArrayAttribFormat) X(glVertexArrayAttribIFormat) \
    X(glVertexArrayBindingDivisor) X(glVertexArrayElementBuffer) X(glVertexArrayVertexBuffer) X(glViewport)
// clang-format on

// Counts from here to its end. The functions must have been called once before, so that libepoxy has found them.
struct CountGlCalls {
    CountGlCalls() {
        glCalls = {};
        set(true);
    }
    ~CountGlCalls() { set(false); }
    CountGlCalls(const CountGlCalls&) = delete;
    CountGlCalls& operator=(const CountGlCalls&) = delete;

  private:
    static void set(bool on) {
#define SWARD_SET_HOOK(name) gl_calls::Hook<epoxy_##name>::set(on, #name);
        SWARD_GL_CALLS(SWARD_SET_HOOK)
#undef SWARD_SET_HOOK
    }
};
#define SWARD_GL_NAME(name) #name,
inline constexpr const char* kCountedGlCalls[] = {SWARD_GL_CALLS(SWARD_GL_NAME)};
#undef SWARD_GL_NAME

}  // namespace sward::test
