#include "ui/widget_list.h"

#include <fmt/format.h>

#include <algorithm>

namespace sward::ui {
namespace {

std::string inOneLine(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');
    return text;
}

}  // namespace

std::string widgetList(const WidgetBook& book) {
    std::string text;
    for (const auto& [path, w] : book.widgets) {
        const std::string is = std::string(w.visible ? "v" : "") + (w.enabled ? "e" : "") + (w.open ? "o" : "");
        text += fmt::format("{}\t{:.0f}\t{:.0f}\t{:.0f}\t{:.0f}\t{}\t{}\n", inOneLine(path), w.x0, w.y0, w.x1, w.y1,
                            is.empty() ? "-" : is, inOneLine(w.value));
    }
    return text;
}

}  // namespace sward::ui
