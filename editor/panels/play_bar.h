// What shows in the viewport that the project is played: a frame, a badge and the keys.
// Does not: draw the buttons, which are a panel of their own in the menu bar (panels.h).
#pragma once
#include "app/app.h"

namespace sward {

void drawPlayFrame(EditorApp& app);  // nothing unless it is played

}  // namespace sward
