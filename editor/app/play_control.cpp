#include "app/play_control.h"

#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "app/edits.h"
#include "app/frame_clock.h"
#include "app/messages.h"
#include "app/viewport.h"
#include "model/document.h"
#include "playtest/playtest.h"
#include "ui/input_queue.h"
#include "ui/surface.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kMostSeconds = 0.25;

bool wentDown(const FrameInput& in, int key) {
    return std::find(in.pressedKeys.begin(), in.pressedKeys.end(), key) != in.pressedKeys.end();
}

bool held(const FrameInput& in, int key) { return in.keys[static_cast<size_t>(key)]; }

// The pointer turns the head as it turns the view when flying.
void turnHead(PlayControl& c, const FrameInput& in, PlayInput& out) {
    FlyCamera head;
    head.yaw = out.yaw;
    head.pitch = out.pitch;
    for (const auto& [x, y] : in.path) {
        if (c.looked) look(head, x - c.lastX, y - c.lastY);
        c.looked = true;
        c.lastX = x, c.lastY = y;
    }
    out.yaw = head.yaw;
    out.pitch = head.pitch;
}

// With the mouse free the walker stands, unless a script moves it.
void handOver(PlayControl& c, const FrameInput& in, Playtest& play) {
    if (!c.captured) return;
    PlayInput out = play.held();
    turnHead(c, in, out);
    const auto axis = [&](int more, int less) { return (held(in, more) ? 1.0 : 0.0) - (held(in, less) ? 1.0 : 0.0); };
    const bool command = in.ctrl();  // Ctrl+S is no step back
    out.move = command ? glm::dvec2(0) : glm::dvec2(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_W, GLFW_KEY_S));
    out.run = in.shift();
    out.jump = held(in, GLFW_KEY_SPACE) || wentDown(in, GLFW_KEY_SPACE);
    play.hold(out);
}

void redraw(const PlayParts& p) {
    p.picture.drawnRevision = p.picture.begunRevision = kNeverDrawn;
    p.clock.wanted = 4;
}

void capture(const PlayParts& p, bool captured) { captureMouse(p.control, p.doc, p.surface, captured); }

}  // namespace

bool playing(const Document& document) { return document.play() != nullptr; }

void captureMouse(PlayControl& control, Document& document, ui::Surface& surface, bool captured) {
    if (control.captured == captured) return;
    control.captured = captured;
    control.looked = false;
    surface.captureMouse(captured);
    if (Playtest* play = document.play(); play && !captured) {
        PlayInput rest = play->held();
        rest.move = {0, 0};
        rest.run = rest.jump = false;
        play->hold(rest);
    }
}

void togglePlay(const PlayParts& p, const FlyCamera& view, ViewportHand& hand, const Edits& edits, bool typing) {
    if (playing(p.doc)) return stopPlay(p);
    if (typing) return say(p.messages, "finish typing first (Enter, or Esc to give up), then play");
    if (!edits.holding.empty()) return say(p.messages, "let go of what is being dragged first, then play");
    if (hand.gesture == Gesture::Ring) return say(p.messages, "let go of the ring first, then play");
    if (!accept(p.messages, p.doc.startPlay({viewOf(view), 0, true}))) return;
    hand.gesture = Gesture::None;
    hand.flying = false;
    p.control.last = p.clock.now;
    capture(p, true);
    redraw(p);
    say(p.messages, "playing: the project stays as it is; F5 stops");
}

void stopPlay(const PlayParts& p) {
    if (!playing(p.doc)) return;
    capture(p, false);
    p.doc.stopPlay();
    redraw(p);
    say(p.messages, "stopped: everything is as it was before");
}

void togglePause(const PlayParts& p) {
    Playtest* play = p.doc.play();
    if (!play) return say(p.messages, "nothing is played; F5 starts");
    play->pause(!play->paused());
    capture(p, !play->paused());
    redraw(p);
    say(p.messages, play->paused() ? "paused: F6 goes on, F11 takes one step" : "playing");
}

void stepOnce(const PlayParts& p) {
    Playtest* play = p.doc.play();
    if (!play) return say(p.messages, "nothing is played; F5 starts");
    if (!play->paused()) togglePause(p);
    play->step();
    redraw(p);
    say(p.messages, fmt::format("step {}: {:.3f} s", play->state().tick, play->time()));
}

void followPlay(const PlayParts& p, const FrameInput& in) {
    Playtest* play = p.doc.play();
    PlayControl& c = p.control;
    if (std::exchange(c.seen, playing(p.doc)) != playing(p.doc)) {  // scripts start and stop it too
        redraw(p);
        c.last = p.clock.now;
    }
    if (!play) return capture(p, false);
    if (c.captured && wentDown(in, GLFW_KEY_ESCAPE)) {
        capture(p, false);
        say(p.messages, "the mouse is free; a click in the picture takes it again, F5 stops");
    }
    handOver(c, in, *play);
    const double seconds = std::clamp(p.clock.now - std::exchange(c.last, p.clock.now), 0.0, kMostSeconds);
    play->advance(seconds);
}

FrameInput widgetInput(const FrameInput& in, const PlayControl& control) {
    if (!control.captured) return in;
    FrameInput none;
    none.x = none.y = -1e6;
    return none;
}

const Project& projectShown(const Document& document) {
    return playing(document) ? document.play()->project() : document.visibleProject();
}
ViewCamera viewShown(const Document& document, const FlyCamera& view) {
    return playing(document) ? document.play()->view() : viewOf(view);
}
double timeShown(const Document& document) { return playing(document) ? document.play()->time() : 0; }

}  // namespace sward
