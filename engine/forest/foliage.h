// What leaves of a species send to the eye from the side that they are seen from, under one sun: tables over the ways
// to the eye, made anew when the sun moves. Does not: know what hides the light. Cost: 2 ms to make, twice that of
// stretched trees, 30 ns to ask.
#pragma once
#include <array>
#include <glm/glm.hpp>

#include "mesh/facing.h"

namespace sward {

struct FoliageLook {
    float seen = 1;    // area that is seen, against leaves in all directions: factor of the path through them
    float sun = 0;     // share of the sun's light that they send there (facing.h, sentTo)
    float passed = 0;  // likewise of what falls on the sides that are not seen: what would shine through (passedTo)
    float sky = 1;     // share of the light from all around that they take from above; from below the rest
    // Of light that comes level from all around, and upright, what they take, as a factor of what they would as baked.
    float level = 1, upright = 1;
};
// Mean reflectance of a mesh's leaves, by area; of one that has none, of all that it has; black of one without area.
glm::vec3 leafColor(const Mesh& mesh);
// Share of the light that falls on leaves of a reflectance that they send on, to both sides. translucency: what shines
// through them, as a share of what they reflect.
glm::vec3 scatterOf(const glm::vec3& color, float translucency);

class FoliageTable {
  public:
    // facing: as baked. sun: unit, towards it. verticalScale: Forest's; `seen` is then of the path as it was baked.
    FoliageTable(const Facing& facing, const glm::vec3& sun, float verticalScale = 1);
    // way: unit, towards the eye.
    FoliageLook from(const glm::vec3& way) const;

  private:
    static constexpr int kRises = 33, kTurns = 17;  // of the way to the eye; away from the sun's side
    float verticalScale_;
    glm::vec2 sunSide_{1, 0};
    std::array<float, kRises> seen_{}, sky_{}, level_{}, upright_{};  // seen_: by the baked way's rise
    std::array<std::array<float, kTurns>, kRises> sun_{}, passed_{};
};

}  // namespace sward
