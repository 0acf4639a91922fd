// Where panels lie and which are shown: one per user, kept in $XDG_CONFIG_HOME/sward/layout.txt (~/.config without it).
// Without HOME nothing is kept, and a file that cannot be read or written changes nothing.
// Does not: draw.
#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace sward {

struct Rect {
    float x = 0, y = 0, w = 0, h = 0;
};

struct Layout {
    float right = 350;             // width of the right column
    float outliner = 0.28f;        // its upper part, as a share of its height
    float bottom = 170;            // height of the bottom panels
    float accuracy = 290;          // ... while one of those is in sight that need more
    std::set<std::string> hidden;  // panels that the person closed
    std::string tab = "Console";   // of the bottom panels
    bool lightTheme = false;       // the panels' colours
    float budgetMs = 1000 / 60.f;  // what a frame may take (app/frame_times.h)
    bool shiftErases = false;      // a habit of the hand, not of a project
    bool timesStrokes = true;      // what strokes cost a frame is measured (app/stroke_timing.h)
};
// The panels that share the bottom as tabs.
inline constexpr const char* kBottomPanels[] = {"Console",  "Profiler",    "Tiers",      "Accuracy",
                                                "History",  "Objects",     "Layers",     "Species",
                                                "Pictures", "Transitions", "Hard Cases", "Effects"};
// The tab that is in sight: the chosen one, or the first that is not hidden; "" if all are.
std::string openTab(const Layout& layout);
// The height that counts for the tab in sight.
float& bottomHeight(Layout& layout);

// Where everything goes in a window of this size, once menu, brush bar and status bar took their heights.
struct Areas {
    Rect menu, brushBar, tools, viewport, outliner, inspector, bottom, status;
};
// A hidden panel gives its place to its neighbours. Areas never overlap and never have a negative size.
Areas areasOf(const Layout& layout, float width, float height, float menuHeight, float barHeight, float statusHeight,
              float toolsWidth);
// Brings sizes into what fits the window.
void clampLayout(Layout& layout, float width, float height);

// Where the person's layout is kept; nothing if neither XDG_CONFIG_HOME nor HOME is absolute.
std::optional<std::filesystem::path> layoutFile();
Layout loadLayout(const std::filesystem::path& file);  // defaults for what is missing or senseless
// Makes the folders on the way. False if it could not be written whole.
bool saveLayout(const std::filesystem::path& file, const Layout& layout);

}  // namespace sward
