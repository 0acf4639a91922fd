// The verb `edit`: the editor in a window.
// Does not: parse the command line.
#pragma once
#include <filesystem>

namespace sward {

// Opens the project (empty: none yet) and runs until the person quits. Returns an exit code: NoContext without a
// display or OpenGL 4.5, Unsound or Failed if the project cannot be opened; what was wrong is logged.
// `widgets`: a file that gets, after each frame, where each widget is (ui/widget_list.h); empty: none.
int editMain(const std::filesystem::path& project, const std::filesystem::path& widgets);

}  // namespace sward
