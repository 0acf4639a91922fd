// Trunks in the way of what is played: upright posts that nothing jumps over, as thick as a tree is at its foot
// (world/forest_stand.h). What meets one keeps the part of its way along it; between two that leave no room it stays
// where it touches both. Ways are followed from trunk to trunk, not tried at their ends, so that no step is too long.
// Pure; a world without forests asks nothing.
// Does not: make crowns or branches an obstacle, or end a post at its tree's top.
// Cost: 1 us each question, of the few tiles around the place, however many trees there are.
#pragma once
#include "playtest/play_state.h"

namespace sward {

struct Trunk {
    glm::dvec2 at{0};  // x, z in the world
    double radius = 0;
};
// A forest on a ground, and all those of a project, to be asked for trunks.
PlayForest playForest(const Forest& forest, const Ground& ground);
std::vector<PlayForest> playForests(const Project& p);
// All trunks that reach into a circle, in a fixed order. `looked`, if given, counts the trees that were looked at.
std::vector<Trunk> trunksNear(const PlayWorld& world, glm::dvec2 at, double radius, size_t* looked = nullptr);

// Metres that a circle of this radius reaches into the trunk that it reaches into farthest; 0: into none.
double depthInTrunks(const PlayWorld& world, glm::dvec2 at, double radius);
// Where a circle comes to that goes from a place to another, both within the edges: there exactly, if no trunk is in
// the way, else along trunks as far as they let it.
glm::dvec2 pastTrunks(const PlayWorld& world, glm::dvec2 from, glm::dvec2 to, double radius);
// The nearest place within the edges where a circle reaches into no trunk; the same if it is such a place, or if there
// is none for eight times the radii around.
glm::dvec2 outOfTrunks(const PlayWorld& world, glm::dvec2 at, double radius);
// The way to take towards a place on the far side of the first trunk between: along its side that is nearer, by the
// left one of equal sides. The way itself where there is none.
glm::dvec2 wayAroundTrunks(const PlayWorld& world, glm::dvec2 from, glm::dvec2 way, double radius);

}  // namespace sward
