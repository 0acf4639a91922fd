// Play in the editor: F5, F6, F11, the captured mouse, and keys that move the walker.
// Does not: simulate (playtest/), draw (panels/play_bar.cpp).
#pragma once

#include "world/view_camera.h"

namespace sward {

namespace ui {
class Surface;
}
class Document;
struct Edits;
struct FlyCamera;
struct FrameClock;
struct FrameInput;
struct Messages;
struct Project;
struct ViewportHand;
struct ViewportPicture;

struct PlayControl {
    bool seen = false;      // played in the last frame
    bool captured = false;  // the mouse turns the walker's head and keys move it
    bool looked = false;    // the pointer's place is known ...
    double lastX = 0, lastY = 0;
    double last = 0;  // seconds of the last frame's clock
};

// What starting, stepping and stopping touches; all must outlive the call.
struct PlayParts {
    Document& doc;
    PlayControl& control;
    ui::Surface& surface;
    ViewportPicture& picture;
    FrameClock& clock;
    Messages& messages;
};

// A copy of the project runs, or is paused.
bool playing(const Document& document);
// Finishes a stroke under way, then starts at the view and ends what the hand was doing; or stops. `typing`: a value is
// half typed. Then, and while a slider or ring is held, nothing starts and it is said why.
void togglePlay(const PlayParts& parts, const FlyCamera& view, ViewportHand& hand, const Edits& edits, bool typing);
// Leaves everything as it was before; nothing happens when nothing is played.
void stopPlay(const PlayParts& parts);
// Frees the mouse, and takes it again. Says so when nothing is played.
void togglePause(const PlayParts& parts);
// One step of the simulation; pauses first. Says so when nothing is played.
void stepOnce(const PlayParts& parts);
// Set free, the mouse leaves the walker standing.
void captureMouse(PlayControl& control, Document& document, ui::Surface& surface, bool captured);

// Once a frame, before the widgets: hands the input over and takes the steps that are due.
void followPlay(const PlayParts& parts, const FrameInput& in);
// What the widgets see of a frame's input: nothing while the mouse is captured.
FrameInput widgetInput(const FrameInput& in, const PlayControl& control);

// --- what the viewport shows: the copy that runs, or the document
const Project& projectShown(const Document& document);
// The walker's eye, or the view's.
ViewCamera viewShown(const Document& document, const FlyCamera& view);
// Seconds since play began; 0 when nothing is played.
double timeShown(const Document& document);

}  // namespace sward
