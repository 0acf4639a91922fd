// What the Tiers panel and its rings in the viewport remember.
// Does not: hold the distances; those are fields of GrassField.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "tools/rings.h"
#include "tools/tiers.h"

namespace sward {

// A ring in the hand.
struct RingDrag {
    RingHit hit;                 // as it was when the button went down
    glm::dvec2 offset{0};        // from the pointer to the ring
    double level = 0;            // height of the ground where it was taken: where the hand goes on beyond the terrain
    bool moved = false;          // a click alone changes nothing
    std::optional<size_t> tier;  // which it is; rings on top of each other are told apart by where the hand goes
};

struct TierView {
    std::string field;                                // entity chosen in the panel; empty: the selected or first one
    bool rings = true;                                // drawn while the panel is in sight
    std::optional<glm::dvec3> pin;                    // where the rings stay; none: around the eye
    std::array<ScreenRing, kTierCount> screen;        // as last drawn
    std::array<std::vector<bool>, kTierCount> clear;  // by point: on the terrain, and no ground hides it
    std::optional<RingHit> hover;                     // under the pointer
    std::optional<RingDrag> drag;
};

}  // namespace sward
