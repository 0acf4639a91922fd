#include "app/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace sward {
namespace {

constexpr float kLeastRight = 200, kLeastBottom = 70, kLeastViewport = 120;

void readNumber(std::istringstream& line, float& value, float low, float high) {
    float v;
    if (line >> v && std::isfinite(v)) value = std::clamp(v, low, high);
}

}  // namespace

std::string openTab(const Layout& l) {
    const auto shown = [&](const std::string& name) { return !l.hidden.count(name); };
    const auto known = std::find(std::begin(kBottomPanels), std::end(kBottomPanels), l.tab);
    if (known != std::end(kBottomPanels) && shown(l.tab)) return l.tab;
    const auto first = std::find_if(std::begin(kBottomPanels), std::end(kBottomPanels), shown);
    return first == std::end(kBottomPanels) ? "" : *first;
}

float& bottomHeight(Layout& l) {
    const std::string tab = openTab(l);
    constexpr const char* kTall[] = {"Accuracy",    "Layers",     "Species", "Pictures",
                                     "Transitions", "Hard Cases", "Effects"};
    const bool tall = std::find(std::begin(kTall), std::end(kTall), tab) != std::end(kTall);
    return tall ? l.accuracy : l.bottom;
}

void clampLayout(Layout& l, float width, float height) {
    l.right = std::clamp(l.right, std::min(kLeastRight, width / 2), std::max(kLeastRight, width - 2 * kLeastViewport));
    for (float* bottom : {&l.bottom, &l.accuracy})
        *bottom = std::clamp(*bottom, kLeastBottom, std::max(kLeastBottom, height - 2 * kLeastViewport));
    l.outliner = std::clamp(l.outliner, 0.1f, 0.9f);
}

Areas areasOf(const Layout& given, float width, float height, float menuHeight, float barHeight, float statusHeight,
              float toolsWidth) {
    Layout l = given;
    clampLayout(l, width, height);
    const bool outliner = !l.hidden.count("Outliner"), inspector = !l.hidden.count("Inspector");
    const bool bottom = !openTab(l).empty();
    const float top = menuHeight + barHeight, middle = std::max(0.f, height - top - statusHeight);
    const float right = outliner || inspector ? std::min(l.right, std::max(0.f, width - toolsWidth)) : 0;
    const float left = std::min(toolsWidth, width), centre = std::max(0.f, width - left - right);
    const float low = bottom ? std::min(bottomHeight(l), middle) : 0;
    Areas a;
    a.menu = {0, 0, width, menuHeight};
    a.brushBar = {0, menuHeight, width, barHeight};
    a.tools = {0, top, left, middle};
    a.viewport = {left, top, centre, middle - low};
    a.bottom = {left, top + middle - low, centre, low};
    const float upper = !outliner ? 0 : inspector ? std::round(middle * l.outliner) : middle;
    a.outliner = {width - right, top, right, upper};
    a.inspector = {width - right, top + upper, right, inspector ? middle - upper : 0};
    a.status = {0, height - statusHeight, width, statusHeight};
    return a;
}

std::optional<std::filesystem::path> layoutFile() {
    const auto absolute = [](const char* name) -> std::optional<std::filesystem::path> {
        const char* value = std::getenv(name);
        if (!value || value[0] != '/') return std::nullopt;
        return std::filesystem::path(value);
    };
    if (const auto config = absolute("XDG_CONFIG_HOME")) return *config / "sward" / "layout.txt";
    if (const auto home = absolute("HOME")) return *home / ".config" / "sward" / "layout.txt";
    return std::nullopt;
}

Layout loadLayout(const std::filesystem::path& file) {
    Layout l;
    std::ifstream in(file);
    std::string text;
    while (std::getline(in, text)) {
        std::istringstream line(text);
        std::string name, word;
        line >> name;
        if (name == "right") readNumber(line, l.right, 100, 4000);
        if (name == "outliner") readNumber(line, l.outliner, 0.1f, 0.9f);
        if (name == "bottom") readNumber(line, l.bottom, 50, 4000);
        if (name == "accuracy") readNumber(line, l.accuracy, 50, 4000);
        if (name == "hidden" && std::getline(line >> std::ws, word)) l.hidden.insert(word);
        if (name == "tab" && std::getline(line >> std::ws, word)) l.tab = word;
        if (name == "budget") readNumber(line, l.budgetMs, 1, 1000);
        if (name == "theme" && line >> word) l.lightTheme = word == "light";
        if (name == "shift" && line >> word) l.shiftErases = word == "erases";
        if (name == "strokes" && line >> word) l.timesStrokes = word != "untimed";
    }
    return l;
}

bool saveLayout(const std::filesystem::path& file, const Layout& l) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    std::ofstream out(file);
    out << fmt::format("right {}\noutliner {}\nbottom {}\naccuracy {}\nbudget {}\ntab {}\n", l.right, l.outliner,
                       l.bottom, l.accuracy, l.budgetMs, l.tab);
    if (l.lightTheme) out << "theme light\n";
    if (l.shiftErases) out << "shift erases\n";
    if (!l.timesStrokes) out << "strokes untimed\n";
    for (const std::string& name : l.hidden) out << "hidden " << name << '\n';
    return static_cast<bool>(out.flush());
}

}  // namespace sward
