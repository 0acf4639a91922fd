// A playtest of a project: a copy that runs, while the project itself stays as it is. Stopping is dropping the copy.
// The picture lies between the last two steps, so that it moves evenly whatever the screen's rate.
// Does not: know keys, windows or undo; Document keeps the project from being edited meanwhile (startPlay).
// Cost: starting copies no map, only pointers to their tiles.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "frame/renderer.h"
#include "playtest/path_walk.h"
#include "playtest/play_state.h"
#include "playtest/tracks.h"
#include "world/view_camera.h"

namespace sward {

struct PlayStart {
    ViewCamera view;      // the walker stands below its eye and looks where it looks; field of view and exposure stay
    double time = 0;      // scene seconds, of which whole ticks count
    bool byClock = true;  // advance() takes steps; false: only step() does
};

class Playtest {
  public:
    // Fails without a Terrain to walk on, and for a view or time that is not finite or beyond 1e9 seconds.
    static Result<std::unique_ptr<Playtest>> start(const Project& p, std::span<const ComponentRow> rows,
                                                   const PlayStart& start);

    // Held from the next step on. A walk along a path goes on unless the input moves or jumps.
    void hold(const PlayInput& input);
    const PlayInput& held() const { return input_; }
    void step(int64_t steps = 1);
    // Takes the steps due after so many seconds of the clock, at most a quarter of a second's. True if the picture
    // changes.
    bool advance(double seconds);
    void pause(bool paused) { paused_ = paused; }
    bool paused() const { return paused_; }
    bool runs() const { return byClock_ && !paused_; }  // by the clock
    // The walker goes to the beginning of an entity's GroundPath and along it, round and round where it is closed,
    // until its end, or until other input moves it. Usage error if there is no such path.
    Status walkAlong(const std::string& entity);
    void endWalk() { walk_.reset(); }
    bool walking() const { return walk_.has_value(); }

    const PlayState& state() const { return now_; }
    const PlayWorld& world() const { return world_; }
    // What touches the ground in the last step: feet and what rolls.
    const std::vector<Contact>& contacts() const { return now_.contacts; }

    // --- the picture
    const Project& project() const { return project_; }  // with what rolls where the picture shows it
    double time() const;                                 // scene seconds
    ViewCamera view() const;                             // where the held input looks

  private:
    Playtest() = default;
    void takeStep();
    void show();

    Project project_;
    PlayWorld world_;
    PlayState before_, now_;
    PlayInput input_;
    std::optional<PathWalk> walk_;
    Tracks tracks_;
    ViewCamera view_;  // field of view and exposure
    double due_ = 0;   // ticks of the clock, not yet taken; in [0, 1)
    bool byClock_ = true, paused_ = false;
};

}  // namespace sward
