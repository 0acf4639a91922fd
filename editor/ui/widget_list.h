// Where each widget of the last whole frame is, as text: for programs that press a real window's widgets by the
// pointer and the keys, such as tests/window. Does not: write files, nor press anything.
#pragma once
#include <string>

#include "ui/widgets.h"

namespace sward::ui {

// A line a widget, fields parted by tabs: path, x0, y0, x1, y1 in whole pixels of the window, what it is now as letters
// (v in sight, e enabled, o open; "-": none of these), and its value with line ends and tabs as spaces.
std::string widgetList(const WidgetBook& book);

}  // namespace sward::ui
