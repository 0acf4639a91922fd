// `ui.*` of scripts over the real widgets: every call goes through the input queue and runs frames of the editor.
// Does not: know Lua.
#pragma once
#include <memory>

#include "app/app.h"
#include "script/ui_driver.h"

namespace sward {

// Drives an editor that outlives it.
std::unique_ptr<UiDriver> makeUiDriver(EditorApp& app);
// An editor without a window over a document, in the current GL context, and its driver in one. Sizes in points, of
// `density` pixels each.
std::unique_ptr<UiDriver> makeHeadlessUi(Document& document, Gpu& gpu, int width, int height, float density = 1);
// The same in a window. ExitCode::NoContext without a display.
Result<std::unique_ptr<UiDriver>> makeWindowUi(Document& document, int width, int height);

}  // namespace sward
