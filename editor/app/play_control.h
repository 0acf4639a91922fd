// Play in the editor: F5, F6, F11, the captured mouse, and keys that move the walker.
// Does not: simulate (playtest/), draw (panels/play_bar.cpp).
#pragma once

#include "world/view_camera.h"

namespace sward {

struct EditorApp;
struct FrameInput;
struct Project;
struct ViewCamera;

struct PlayControl {
    bool seen = false;      // played in the last frame
    bool captured = false;  // the mouse turns the walker's head and keys move it
    bool looked = false;    // the pointer's place is known ...
    double lastX = 0, lastY = 0;
    double last = 0;  // seconds of the last frame's clock
};

bool playing(const EditorApp& app);
// Finishes a stroke under way, then starts at the view; or stops, which leaves everything as it was before.
void togglePlay(EditorApp& app);
void stopPlay(EditorApp& app);     // nothing happens when nothing is played
void togglePause(EditorApp& app);  // frees the mouse
void stepOnce(EditorApp& app);     // pauses first
void captureMouse(EditorApp& app, bool captured);

// Once a frame, before the widgets: hands the input over and takes the steps that are due.
void followPlay(EditorApp& app);
// What the widgets see of a frame's input: nothing while the mouse is captured.
FrameInput widgetInput(const EditorApp& app);

// --- what the viewport shows: the copy that runs, or the document
const Project& projectShown(const EditorApp& app);
ViewCamera viewShown(const EditorApp& app);
double timeShown(const EditorApp& app);

}  // namespace sward
