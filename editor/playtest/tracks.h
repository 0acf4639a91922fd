// What a playtest presses into the grass: prints of the walker's feet, and the paths of what rolls; as tracks of
// ForceSource components of the play's own project (world/forces.h), where they recover and are forgotten. A
// ForceSource of shape `foot` without a Transform says what the walker's feet are (width, length, strength, recovery);
// without one, a shoe's are taken. What rolls presses as its own ForceSource says, or with the half of its radius. Does
// not: step anything. Cost: a few numbers a track; none after it has recovered.
#pragma once
#include "playtest/play_state.h"
#include "scene/project.h"

namespace sward {

class Tracks {
  public:
    // Adds what is missing to `p`, the play's own copy.
    void begin(Project& p, const PlayState& s);
    // After each step.
    void press(Project& p, const PlayState& s);

  private:
    Entity feet_ = kNoEntity;
    std::vector<glm::dvec2> ends_;  // by rolling thing: where its track ends
};

}  // namespace sward
