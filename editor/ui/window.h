// A GLFW window with an OpenGL 4.5 core context, as a surface.
// Does not: decide when to draw.
#pragma once
#include "core/error.h"
#include "ui/surface.h"

namespace sward::ui {

// Opens the window and makes its context current. ExitCode::NoContext without a display or without OpenGL 4.5.
// One at a time in a process.
Result<std::unique_ptr<Surface>> openWindow(int width, int height, const std::string& title);
// Copy and paste of the current ImGui context go through the window system's clipboard. No window: nothing changes.
void installClipboard(Surface& surface);

}  // namespace sward::ui
