#include "playtest/path_walk.h"

#include <cmath>

#include "playtest/trunks.h"

namespace sward {
namespace {

constexpr double kAhead = 0.7;     // metres from the walker to the place it goes towards
constexpr double kStep = 0.05;     // metres by which that moves on
constexpr double kArrived = 0.15;  // from the end

}  // namespace

PathWalk pathWalk(const GroundPath& path, const glm::dvec3& origin) {
    const GroundCurve curve = groundCurve(path);
    PathWalk walk{stationsOn(curve), curve.closed, 0};
    for (CurveStation& s : walk.stations) s.at += glm::dvec2(origin.x, origin.z);
    return walk;
}

bool steer(PathWalk& walk, const PlayWorld& world, const Walker& walker, PlayInput& in) {
    const glm::dvec2 here{walker.position.x, walker.position.z};
    const double length = walk.stations.back().metres;
    const auto way = [&] { return placeAlong(walk.stations, walk.metres) - here; };
    const auto depth = [&] { return depthInTrunks(world, here + way(), kBodyRadius); };
    // Once around at most: all of a small path may lie within reach. A place in a trunk is no place to go towards.
    for (double gone = 0; gone < length && (glm::length(way()) < kAhead || depth() > 0); gone += kStep) {
        walk.metres += kStep;
        if (walk.metres >= length) walk.metres = walk.closed ? walk.metres - length : length;
        if (!walk.closed && walk.metres == length) break;
    }
    in.jump = false;
    in.move = {0, 0};
    if (!walk.closed && walk.metres >= length && glm::length(way()) < kArrived + depth()) return false;
    const glm::dvec2 to = wayAroundTrunks(world, here, way(), kBodyRadius);
    if (glm::length(to) > 1e-6) in.move = {0, 1}, in.yaw = std::atan2(to.x, -to.y);
    return true;
}

}  // namespace sward
