// All that differs between the Dear ImGui versions that distributions package (1.86 to 1.91), in one place.
// Does not: hold state beyond the current ImGui context.
#pragma once
#include <imgui.h>

#include <string>

#include "ui/input_queue.h"
#include "ui/widgets.h"

namespace sward::ui {

// Key table and options of a new context: no ini file, no blinking cursor, no second input queue.
void setUpContext();
// Gives ImGui what this frame holds. Sizes in window coordinates and in pixels. Before ImGui::NewFrame.
void feedInput(const FrameInput& in, float deltaSeconds, int width, int height, int pixelWidth, int pixelHeight);
// A GL texture as ImGui takes it.
ImTextureID textureId(unsigned glTexture);
// An input line on a std::string; true when Enter was pressed. Fills the item width set before.
bool inputText(const char* id, const char* hint, std::string& text, const LineHelp& help = {});
// The key is pressed in this frame (not repeated).
bool enterPressed();
// Likewise for Escape.
bool escapePressed();
// The next input line gets the keyboard, or the last one. Once is enough: it has it in the next frame.
void focusNext();
void focusLast();
// What is drawn over the next item takes the pointer there: newer versions ask before the item, older ones after it.
// Both are to be called.
void allowOverlapOfNext();
void allowOverlapOfLast();
// The next press of a button is the first of a click, whenever it comes. After the context's last frame.
void forgetClicks();
// What copy and paste of the current context call, with `user`.
void setClipboardFunctions(const char* (*get)(void*), void (*set)(void*, const char*), void* user);

}  // namespace sward::ui
