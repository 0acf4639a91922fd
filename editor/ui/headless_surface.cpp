#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/surface.h"

namespace sward::ui {
namespace {

class HeadlessSurface final : public Surface {
  public:
    HeadlessSurface(int width, int height, float density) : width_(width), height_(height), density_(density) {
        glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
        glTextureStorage2D(texture_, 1, GL_RGBA8, pixelWidth(), pixelHeight());
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
    int pixelWidth() const override { return static_cast<int>(std::lround(static_cast<float>(width_) * density_)); }
    int pixelHeight() const override { return static_cast<int>(std::lround(static_cast<float>(height_) * density_)); }
    void poll(InputQueue&, double) override {}
    void bind() override { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }
    void present() override {}
    double fixedStep() const override { return 1.0 / 60; }

  private:
    int width_, height_;
    float density_;
    unsigned texture_ = 0, framebuffer_ = 0;
};

}  // namespace

float densityOf(const Surface& surface) {
    const int points = surface.width();
    return points > 0 ? static_cast<float>(surface.pixelWidth()) / static_cast<float>(points) : 1;
}

std::unique_ptr<Surface> makeHeadlessSurface(int width, int height, float density) {
    return std::make_unique<HeadlessSurface>(width, height, density);
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
