// What shows in the viewport that the project is played: a frame, a badge and the keys.
// Does not: draw the buttons, which are a panel of their own in the menu bar (panels.h).
#pragma once
#include "app/layout.h"

namespace sward {

class Document;

// Around the viewport's picture, within `view`; `captured`: the mouse turns the walker's head. Nothing unless it is
// played.
void drawPlayFrame(const Document& document, bool captured, const Rect& view);

}  // namespace sward
