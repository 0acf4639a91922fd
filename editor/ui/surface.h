// Where the editor's frames go: a window, or a framebuffer that nobody sees.
// Does not: draw, nor own the GL context of a headless run.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ui/input_queue.h"

namespace sward::ui {

enum class Cursor { Arrow, Text, ResizeEW, ResizeNS };

class Surface {
  public:
    virtual ~Surface() = default;
    // Size in points, in which panels, fonts and the pointer are measured: a pixel of a screen of usual density, and
    // more pixels on a denser one, so that everything keeps its size to the eye.
    virtual int width() const = 0;
    // Of the same.
    virtual int height() const = 0;
    // In pixels.
    virtual int pixelWidth() const { return width(); }
    virtual int pixelHeight() const { return height(); }
    // Moves what came from the person since the last call into the queue; waits up to `seconds` for something.
    virtual void poll(InputQueue& queue, double seconds) = 0;
    // The person asked to close the window, and takeCloseRequest has not been called since.
    virtual bool closeRequested() const { return false; }
    // True once after the person asked to close the window.
    virtual bool takeCloseRequest() { return false; }
    // Binds the framebuffer to draw into.
    virtual void bind() = 0;
    // Shows what was drawn since bind.
    virtual void present() = 0;
    // Of the window, UTF-8; nothing without one.
    virtual void setTitle(const std::string&) {}
    virtual void setCursor(Cursor) {}
    // Hides the pointer and lets it move without end, for turning one's head; or shows it again where it was.
    virtual void captureMouse(bool) {}
    // Fixed seconds a frame, or 0: as the clock says.
    virtual double fixedStep() const { return 0; }
};

// RGBA8 pixels of what is bound by bind(), first row on top.
std::vector<uint8_t> readSurface(Surface& surface);

// Pixels a point.
float densityOf(const Surface& surface);

// A framebuffer of the current context, in points, with `density` pixels a point; frames of 1/60 s.
std::unique_ptr<Surface> makeHeadlessSurface(int width, int height, float density = 1);

}  // namespace sward::ui
