// Small worlds and inputs for the tests of the simulation.
#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "playtest/trunks.h"

namespace sward::test {

inline constexpr double kRight = 3.14159265358979 / 2;  // yaw towards +x

// 64 x 64 m; heights in metres by place.
inline PlayWorld worldOf(const std::function<double(double, double)>& height = nullptr, int texels = 256) {
    PlayWorld world;
    world.terrain.size = {64, 64};
    if (!height) return world;
    world.terrain.height.file = "maps/h.exr";
    world.terrain.height.map = Map({texels, texels, 1, PixelType::F32});
    for (int y = 0; y < texels; ++y)
        for (int x = 0; x < texels; ++x)
            world.terrain.height.map.set(x, y, 0,
                                         static_cast<float>(height((x + 0.5) * 64 / texels, (y + 0.5) * 64 / texels)));
    return world;
}
inline PlayWorld hills() {
    return worldOf(
        [](double x, double z) { return 3 * std::sin(x / 5) * std::cos(z / 7) + 0.2 * std::sin(x * 1.7 + z); });
}
inline PlacedTree treeAt(double x, double z, float size = 1) {
    PlacedTree t;
    t.at = {x, z};
    t.size = size;
    return t;
}
// Trees by hand alone, of a species whose trunks have a radius of kTrunk.
inline const double kTrunk = trunkRadius(TreeSpecies{});
inline void plant(PlayWorld& world, const std::vector<PlacedTree>& trees) {
    Forest forest;
    forest.perHectare = 0;
    forest.placed = trees;
    world.forests.push_back(playForest(forest, {&world.terrain, world.origin}));
}
inline PlayState stateAt(const PlayWorld& world, double x, double z, double yaw = kRight) {
    PlayState s;
    placeWalker(s, world, x, z, yaw, 0);
    return s;
}
inline PlayInput walk(double yaw = kRight) {
    PlayInput in;
    in.move = {0, 1};
    in.yaw = yaw;
    return in;
}
inline void steps(PlayState& s, const PlayWorld& world, const PlayInput& in, int n) {
    for (int i = 0; i < n; ++i) stepPlay(s, world, in);
}
inline Roller ball(double x, double y, double z, double radius = 0.25) {
    Roller r;
    r.name = "ball";
    r.radius = radius;
    r.position = {x, y, z};
    return r;
}
// A walk that turns, runs, jumps and stands by turns.
inline PlayInput scripted(int64_t i) {
    PlayInput in;
    in.yaw = 0.002 * static_cast<double>(i % 5000) + std::sin(static_cast<double>(i) * 0.01);
    in.move = {std::sin(static_cast<double>(i) * 0.003), i % 700 < 600 ? 1.0 : 0.0};
    in.run = i % 1000 < 500;
    in.jump = i % 120 < 10;
    return in;
}

}  // namespace sward::test
