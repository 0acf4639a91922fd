// What a comparison lays over the viewport's picture: the other picture or the map of errors right of a line, and the
// line's grip. Does not: make what it shows (accuracy/accuracy.h).
#pragma once
#include "app/app.h"

namespace sward {

void drawComparison(EditorApp& app);  // within the viewport's clip rectangle, after its image
// --- the grip in the line's middle; the rest of the line takes no clicks, so that painting goes on beneath it
void hoverSplit(EditorApp& app, bool over);
bool grabSplit(const EditorApp& app);  // true if the pointer is on it and no modifier says otherwise
void dragSplit(EditorApp& app, double x);

}  // namespace sward
