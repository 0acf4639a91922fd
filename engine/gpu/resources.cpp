#include "gpu/resources.h"

#include <algorithm>
#include <bit>
#include <new>

namespace sward {

size_t formatBytes(GLenum format) {
    switch (format) {
        case GL_R8:
        case GL_R8UI:
            return 1;
        case GL_RG8:
        case GL_R16:
        case GL_R16F:
            return 2;
        case GL_RGBA8:
        case GL_SRGB8_ALPHA8:
        case GL_RG16:
        case GL_RG16F:
        case GL_R32F:
        case GL_DEPTH_COMPONENT32F:
        case GL_R11F_G11F_B10F:
            return 4;
        case GL_RGBA16:
        case GL_RGBA16F:
        case GL_RG32F:
        case GL_RG32UI:
        case GL_DEPTH32F_STENCIL8:
            return 8;
        case GL_RGB8:
            return 3;
        case GL_RGB16:
            return 6;
        case GL_RGB32F:
            return 12;
        case GL_RGBA32F:
            return 16;
        default:
            checkFailed(__FILE__, __LINE__, fmt::format("unknown texture format 0x{:x}", format));
    }
}

size_t imageBytes(GLenum format, int width, int height) {
    if (format != GL_COMPRESSED_RGBA_BPTC_UNORM && format != GL_COMPRESSED_SRGB_ALPHA_BPTC_UNORM)
        return formatBytes(format) * static_cast<size_t>(width) * static_cast<size_t>(height);
    return 16 * static_cast<size_t>((width + 3) / 4) * static_cast<size_t>((height + 3) / 4);
}

void throwWithoutMemory() {
    for (int kinds = 0; kinds < 8; ++kinds) {  // one of each kind may wait; a lost context says so for ever
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) return;
        if (error == GL_OUT_OF_MEMORY) throw std::bad_alloc();
    }
}

Buffer makeBuffer(Gpu& gpu, const std::string& owner, size_t bytes, const void* data, GLbitfield flags) {
    const size_t size = std::max<size_t>(bytes, 16);
    GLuint id = 0;
    glCreateBuffers(1, &id);
    glNamedBufferStorage(id, static_cast<GLsizeiptr>(size), bytes == size ? data : nullptr, flags);
    throwWithoutMemory();
    if (data && bytes > 0 && bytes != size) glNamedBufferSubData(id, 0, static_cast<GLsizeiptr>(bytes), data);
    glObjectLabel(GL_BUFFER, id, -1, owner.c_str());
    return {GlName<BufferKind>(id), Tally(gpu, owner, size)};
}

void writeBuffer(Gpu& gpu, Buffer& buffer, const std::string& owner, size_t bytes, const void* data) {
    const size_t room = std::bit_ceil(std::max<size_t>(bytes, 256));
    if (buffer.bytes() != room) buffer = makeBuffer(gpu, owner, room, nullptr);
    if (bytes > 0 && data) glNamedBufferSubData(buffer.id(), 0, static_cast<GLsizeiptr>(bytes), data);
}

namespace {
int fullChain(int width, int height) {
    int levels = 1;
    for (int side = std::max(width, height); side > 1; side /= 2) ++levels;
    return levels;
}
size_t chainBytes(GLenum format, int width, int height, int levels) {
    size_t sum = 0;
    for (int l = 0; l < levels; ++l) sum += imageBytes(format, std::max(width >> l, 1), std::max(height >> l, 1));
    return sum;
}
}  // namespace

Texture makeTexture2D(Gpu& gpu, const std::string& owner, GLenum format, int width, int height, int levels,
                      bool repeat) {
    if (levels == 0) levels = fullChain(width, height);
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &id);
    glTextureStorage2D(id, levels, format, width, height);
    throwWithoutMemory();
    const GLint wrap = repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, wrap);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, wrap);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glObjectLabel(GL_TEXTURE, id, -1, owner.c_str());
    return {GlName<TextureKind>(id),
            Tally(gpu, owner, chainBytes(format, width, height, levels)),
            width,
            height,
            levels,
            format};
}

Texture makeTextureArray(Gpu& gpu, const std::string& owner, GLenum format, int width, int height, int layers) {
    const int levels = fullChain(width, height);
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
    glTextureStorage3D(id, levels, format, width, height, layers);
    throwWithoutMemory();
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glObjectLabel(GL_TEXTURE, id, -1, owner.c_str());
    return {GlName<TextureKind>(id),
            Tally(gpu, owner, chainBytes(format, width, height, levels) * static_cast<size_t>(layers)),
            width,
            height,
            levels,
            format};
}

Texture makeTexture3D(Gpu& gpu, const std::string& owner, GLenum format, int width, int height, int depth, int levels) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_3D, 1, &id);
    glTextureStorage3D(id, levels, format, width, height, depth);
    throwWithoutMemory();
    glTextureParameteri(id, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR);
    glObjectLabel(GL_TEXTURE, id, -1, owner.c_str());
    size_t bytes = 0;
    for (int l = 0; l < levels; ++l)
        bytes += imageBytes(format, std::max(width >> l, 1), std::max(height >> l, 1)) *
                 static_cast<size_t>(std::max(depth >> l, 1));
    return {GlName<TextureKind>(id), Tally(gpu, owner, bytes), width, height, levels, format};
}

Texture makeTexture2DMultisample(Gpu& gpu, const std::string& owner, GLenum format, int width, int height,
                                 int samples) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &id);
    glTextureStorage2DMultisample(id, samples, format, width, height, GL_TRUE);
    throwWithoutMemory();
    glObjectLabel(GL_TEXTURE, id, -1, owner.c_str());
    const size_t bytes = chainBytes(format, width, height, 1) * static_cast<size_t>(samples);
    return {GlName<TextureKind>(id), Tally(gpu, owner, bytes), width, height, 1, format};
}

Framebuffer makeFramebuffer(GLuint color, GLuint depth, const char* label) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    if (color) glNamedFramebufferTexture(id, GL_COLOR_ATTACHMENT0, color, 0);
    GLint format = 0;
    if (depth) glGetTextureLevelParameteriv(depth, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    if (depth)
        glNamedFramebufferTexture(
            id, format == GL_DEPTH32F_STENCIL8 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, depth, 0);
    glObjectLabel(GL_FRAMEBUFFER, id, -1, label);
    CHECK_EQ(static_cast<unsigned>(glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER)),
             static_cast<unsigned>(GL_FRAMEBUFFER_COMPLETE));
    return Framebuffer(id);
}

VertexArray makeVertexArray(const char* label) {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    glObjectLabel(GL_VERTEX_ARRAY, id, -1, label);
    return VertexArray(id);
}

}  // namespace sward
