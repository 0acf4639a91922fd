#include <epoxy/gl.h>

#include <cstring>

#include "ui/surface.h"

namespace sward::ui {
namespace {

class HeadlessSurface final : public Surface {
  public:
    HeadlessSurface(int width, int height) : width_(width), height_(height) {
        glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
        glTextureStorage2D(texture_, 1, GL_RGBA8, width, height);
        glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
        glObjectLabel(GL_TEXTURE, texture_, -1, "editor/headless");
    }
    ~HeadlessSurface() override {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteTextures(1, &texture_);
    }
    int width() const override { return width_; }
    int height() const override { return height_; }
    void poll(InputQueue&, double) override {}
    void bind() override { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }
    void present() override {}
    double fixedStep() const override { return 1.0 / 60; }

  private:
    int width_, height_;
    unsigned texture_ = 0, framebuffer_ = 0;
};

}  // namespace

std::unique_ptr<Surface> makeHeadlessSurface(int width, int height) {
    return std::make_unique<HeadlessSurface>(width, height);
}

std::vector<uint8_t> readSurface(Surface& surface) {
    const size_t width = static_cast<size_t>(surface.pixelWidth()), height = static_cast<size_t>(surface.pixelHeight());
    const size_t row = width * 4;
    std::vector<uint8_t> pixels(row * height), flipped(row * height);
    surface.bind();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, static_cast<int>(width), static_cast<int>(height), GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (size_t y = 0; y < height; ++y) std::memcpy(&flipped[y * row], &pixels[(height - 1 - y) * row], row);
    return flipped;
}

}  // namespace sward::ui
