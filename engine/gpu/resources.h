// Buffers, textures and framebuffers that free themselves, carry a label, and are counted in Gpu::ledger.
// Does not: bind anything for drawing.
#pragma once
#include <cstddef>
#include <string>
#include <utility>

#include "gpu/gpu.h"

namespace sward {

// Bytes of the driver's memory under an owner's name, given back on destruction.
class Tally {
  public:
    Tally() = default;
    Tally(Gpu& gpu, std::string owner, size_t bytes) : gpu_(&gpu), owner_(std::move(owner)), bytes_(bytes) {
        gpu.ledger[owner_] += static_cast<int64_t>(bytes);
    }
    Tally(Tally&& o) noexcept : gpu_(std::exchange(o.gpu_, nullptr)), owner_(std::move(o.owner_)), bytes_(o.bytes_) {}
    Tally& operator=(Tally&& o) noexcept {
        release();
        gpu_ = std::exchange(o.gpu_, nullptr);
        owner_ = std::move(o.owner_);
        bytes_ = o.bytes_;
        return *this;
    }
    ~Tally() { release(); }
    // Bytes counted; 0 after it was moved from.
    size_t bytes() const { return gpu_ ? bytes_ : 0; }

  private:
    void release() {
        if (!gpu_) return;
        if ((gpu_->ledger[owner_] -= static_cast<int64_t>(bytes_)) == 0) gpu_->ledger.erase(owner_);
        gpu_ = nullptr;
    }
    Gpu* gpu_ = nullptr;
    std::string owner_;
    size_t bytes_ = 0;
};

// An OpenGL name that is deleted with its holder. Kind: a struct with `static void destroy(GLuint)`.
template <class Kind>
class GlName {
  public:
    GlName() = default;
    explicit GlName(GLuint id) : id_(id) {}
    GlName(GlName&& o) noexcept : id_(std::exchange(o.id_, 0)) {}
    GlName& operator=(GlName&& o) noexcept {
        if (id_) Kind::destroy(id_);
        id_ = std::exchange(o.id_, 0);
        return *this;
    }
    ~GlName() {
        if (id_) Kind::destroy(id_);
    }
    // The name; 0 if it holds none.
    GLuint id() const { return id_; }

  private:
    GLuint id_ = 0;
};
// Kinds of names, and how each is deleted.
struct BufferKind {
    // Deletes the buffer.
    static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct TextureKind {
    // Deletes the texture.
    static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct FramebufferKind {
    // Deletes the framebuffer.
    static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct VertexArrayKind {
    // Deletes the vertex array.
    static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct ProgramKind {
    // Deletes the program.
    static void destroy(GLuint id) { glDeleteProgram(id); }
};
using VertexArray = GlName<VertexArrayKind>;
using Framebuffer = GlName<FramebufferKind>;

struct Buffer {
    GlName<BufferKind> name;
    Tally tally;
    // The buffer's name; 0 before it was made.
    GLuint id() const { return name.id(); }
    // Size as it was made, in bytes.
    size_t bytes() const { return tally.bytes(); }
};
// owner: "domain/stem"; its domain/stem is what `explain` charges. data may be null. Sizes of 0 become 16.
Buffer makeBuffer(Gpu& gpu, const std::string& owner, size_t bytes, const void* data,
                  GLbitfield flags = GL_DYNAMIC_STORAGE_BIT);
// Writes at the start of a buffer whose size is the next power of two: what it holds follows from what is written now,
// not from what was once. Contents are lost when the size changes.
void writeBuffer(Gpu& gpu, Buffer& buffer, const std::string& owner, size_t bytes, const void* data);

struct Texture {
    GlName<TextureKind> name;
    Tally tally;
    int width = 0, height = 0, levels = 1;
    GLenum format = 0;
    // The texture's name; 0 before it was made.
    GLuint id() const { return name.id(); }
};
// std::bad_alloc if the driver said since the last call that it has no memory: it tells of it by an error alone. After
// each call that makes storage; what is below does so.
void throwWithoutMemory();
// levels 0: the full chain. Filters trilinear when there are levels, clamped unless `repeat`.
Texture makeTexture2D(Gpu& gpu, const std::string& owner, GLenum format, int width, int height, int levels = 1,
                      bool repeat = false);
// Layers of one size, with their full chain of levels; trilinear, clamped.
Texture makeTextureArray(Gpu& gpu, const std::string& owner, GLenum format, int width, int height, int layers);
// Linearly filtered along all three axes, repeated along the first two; of several levels the nearest one is read.
Texture makeTexture3D(Gpu& gpu, const std::string& owner, GLenum format, int width, int height, int depth,
                      int levels = 1);
// `samples` a texel, one of Gpu::sampleCounts; no levels.
Texture makeTexture2DMultisample(Gpu& gpu, const std::string& owner, GLenum format, int width, int height, int samples);
// depth may be of a format with a stencil; 0: none.
Framebuffer makeFramebuffer(GLuint color, GLuint depth, const char* label);
// Vertex array without attributes, labelled for debuggers.
VertexArray makeVertexArray(const char* label);

// Bytes of one texel of a sized format; CHECK fails for one that Sward does not use, or that is compressed.
size_t formatBytes(GLenum format);
// Bytes of one level of an image, compressed formats included (blocks of 4 x 4).
size_t imageBytes(GLenum format, int width, int height);

}  // namespace sward
