#include "app/play_control.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/app.h"
#include "playtest/playtest.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kMostSeconds = 0.25;

bool wentDown(const EditorApp& app, int key) {
    const std::vector<int>& keys = app.in.pressedKeys;
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

bool held(const EditorApp& app, int key) { return app.in.keys[static_cast<size_t>(key)]; }

// The pointer turns the head as it turns the view when flying.
void turnHead(EditorApp& app, PlayInput& in) {
    PlayControl& c = app.play;
    FlyCamera head;
    head.yaw = in.yaw;
    head.pitch = in.pitch;
    for (const auto& [x, y] : app.in.path) {
        if (c.looked) look(head, x - c.lastX, y - c.lastY);
        c.looked = true;
        c.lastX = x, c.lastY = y;
    }
    in.yaw = head.yaw;
    in.pitch = head.pitch;
}

// With the mouse free the walker stands, unless a script moves it.
void handOver(EditorApp& app, Playtest& play) {
    if (!app.play.captured) return;
    PlayInput in = play.held();
    turnHead(app, in);
    const auto axis = [&](int more, int less) { return (held(app, more) ? 1.0 : 0.0) - (held(app, less) ? 1.0 : 0.0); };
    const bool command = app.in.ctrl();  // Ctrl+S is no step back
    in.move = command ? glm::dvec2(0) : glm::dvec2(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_W, GLFW_KEY_S));
    in.run = app.in.shift();
    in.jump = held(app, GLFW_KEY_SPACE) || wentDown(app, GLFW_KEY_SPACE);
    play.hold(in);
}

void redraw(EditorApp& app) {
    app.viewport.drawnRevision = ~uint64_t(0);
    app.framesWanted = 4;
}

}  // namespace

bool playing(const EditorApp& app) { return app.doc.play() != nullptr; }

void captureMouse(EditorApp& app, bool captured) {
    PlayControl& c = app.play;
    if (c.captured == captured) return;
    c.captured = captured;
    c.looked = false;
    app.surface->captureMouse(captured);
    if (Playtest* play = app.doc.play(); play && !captured) {
        PlayInput rest = play->held();
        rest.move = {0, 0};
        rest.run = rest.jump = false;
        play->hold(rest);
    }
}

void togglePlay(EditorApp& app) {
    if (playing(app)) return stopPlay(app);
    if (!app.book.editing.empty() || !app.book.typing.empty())
        return say(app, "finish typing first (Enter, or Esc to give up), then play");
    if (!app.holding.empty()) return say(app, "let go of what is being dragged first, then play");
    Viewport& v = app.viewport;
    if (v.gesture == Gesture::Ring) return say(app, "let go of the ring first, then play");
    if (!accept(app, app.doc.startPlay({viewOf(v.camera), 0, true}))) return;
    v.gesture = Gesture::None;
    v.flying = false;
    app.play.last = app.now;
    captureMouse(app, true);
    redraw(app);
    say(app, "playing: the project stays as it is; F5 stops");
}

void stopPlay(EditorApp& app) {
    if (!playing(app)) return;
    captureMouse(app, false);
    app.doc.stopPlay();
    redraw(app);
    say(app, "stopped: everything is as it was before");
}

void togglePause(EditorApp& app) {
    Playtest* play = app.doc.play();
    if (!play) return say(app, "nothing is played; F5 starts");
    play->pause(!play->paused());
    captureMouse(app, !play->paused());
    redraw(app);
    say(app, play->paused() ? "paused: F6 goes on, F11 takes one step" : "playing");
}

void stepOnce(EditorApp& app) {
    Playtest* play = app.doc.play();
    if (!play) return say(app, "nothing is played; F5 starts");
    if (!play->paused()) togglePause(app);
    play->step();
    redraw(app);
    say(app, fmt::format("step {}: {:.3f} s", play->state().tick, play->time()));
}

void followPlay(EditorApp& app) {
    Playtest* play = app.doc.play();
    PlayControl& c = app.play;
    if (std::exchange(c.seen, playing(app)) != playing(app)) {  // scripts start and stop it too
        redraw(app);
        c.last = app.now;
    }
    if (!play) return captureMouse(app, false);
    if (c.captured && wentDown(app, GLFW_KEY_ESCAPE)) {
        captureMouse(app, false);
        say(app, "the mouse is free; a click in the picture takes it again, F5 stops");
    }
    handOver(app, *play);
    const double seconds = std::clamp(app.now - std::exchange(c.last, app.now), 0.0, kMostSeconds);
    play->advance(seconds);
}

FrameInput widgetInput(const EditorApp& app) {
    if (!app.play.captured) return app.in;
    FrameInput none;
    none.x = none.y = -1e6;
    return none;
}

const Project& projectShown(const EditorApp& app) {
    return playing(app) ? app.doc.play()->project() : app.doc.project();
}
ViewCamera viewShown(const EditorApp& app) {
    return playing(app) ? app.doc.play()->view() : viewOf(app.viewport.camera);
}
double timeShown(const EditorApp& app) { return playing(app) ? app.doc.play()->time() : 0; }

}  // namespace sward
