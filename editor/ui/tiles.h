// Pictures to choose from: a picture above its name, side by side. What is recorded is as of a button.
// Does not: make pictures (app/thumbnails.h).
#pragma once
#include <string>

#include "ui/widgets.h"

namespace sward::ui {

// A GL texture whose first row is on top; texture 0: none, a plain field is shown.
struct Shown {
    unsigned texture = 0;
    int width = 1, height = 1;
};
struct TileSize {
    float width = 96, height = 96;  // of the picture, in points; its name takes a line more
};

// True if it was pressed. `title`: what stands below, shortened to fit; `twice`: it was pressed twice.
bool tile(const std::string& label, const std::string& title, const Shown& picture, const TileSize& size, bool chosen,
          bool* twice = nullptr);
// Before the next of several tiles: on the same line if it fits there. Nothing before the first.
void nextTile(const TileSize& size, bool first);
// A picture as large as fits, in the middle of a field; no widget of its own, but it can have a tooltip.
void picture(const std::string& label, const Shown& picture, const TileSize& size);

}  // namespace sward::ui
