// A walk along a path on the ground: what the walker's keys would do to follow it. Pure.
// It goes around trunks, one at a time, and past those that stand on the path.
// Does not: move the walker (play_state.h): where it cannot go, such as up a cliff or between two trunks that leave no
// room, it pushes and stays.
#pragma once
#include "playtest/play_state.h"
#include "scene/ground_path.h"

namespace sward {

struct PathWalk {
    std::vector<CurveStation> stations;  // in the world, x and z
    bool closed = false;
    double metres = 0;  // of the place on the path that the walker goes towards
};
// To the path's beginning, and along it. No stations: the path has no point. `origin`: of the terrain.
PathWalk pathWalk(const GroundPath& path, const glm::dvec3& origin);
// Turns and moves the input towards the path, some steps ahead of the walker; whether it runs stays as it is. False at
// the end of an open path, or beside a trunk that stands there: the input stands still.
bool steer(PathWalk& walk, const PlayWorld& world, const Walker& walker, PlayInput& in);

}  // namespace sward
