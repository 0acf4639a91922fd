// What the viewport shows while no project is open: ways to begin.
#pragma once
#include <functional>

#include "app/edits.h"
#include "app/file_tasks.h"
#include "app/layout.h"
#include "app/start.h"
#include "app/thumbnails.h"

namespace sward {

struct StartParts {
    const StartScreen& start;
    Thumbnails& thumbnails;
    Document& doc;
    FileDialog& files;
    UnsavedDialog& unsaved;
    Edits& edits;
    Messages& messages;
    Waiting& waiting;
    std::function<void()> adopt;  // after the document holds a project
};
// Buttons for a new project and for opening one, the last projects, the samples. Paths: "Viewport/Start/Open...",
// "Viewport/Start/Samples/football".
void drawStart(const StartParts& parts, const Rect& view);

}  // namespace sward
