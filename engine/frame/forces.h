// What presses on the grass: what stands on it now, and the tracks that it left, which recover.
// Source: Jahrmann and Wimmer 2013, section 5.2; J-8. Formulas: numerics/gust.h. Does not: bend blades, walk.
// Shapes of tracks: editor/playtest/tracks.h. One list for all techniques and for the reference; it has what still presses, so its length does not grow with time.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/project.h"

namespace sward {

// Something long and round that lies from `from` to `to`, metres relative to the terrain's corner.
struct Force {
    glm::dvec2 from{0}, to{0};
    float radius = 0;  // of where it presses blades down, about the line between them
    float reach = 0;   // radii out to which it pushes them aside
    float share = 0;   // ]0, 1]: of its strength that is left
};
// In the order of their entities' names, each one's oldest track first.
std::vector<Force> forcesOf(const Project& p, double seconds);

// x, y: push aside (metres a metre, at most 1 long); z: press in [0, 1]; at a place relative to the terrain's corner.
// The technique holds the same in a map around the eye (grass/forces.h), whose texels are its error.
glm::vec3 forceAt(std::span<const Force> forces, const glm::dvec2& place);
// Share of a track's strength that is left after so many seconds: falls smoothly from 1 to 0 in `recovery`; infinite: it stays.
double trackLeft(double age, float recovery);

// Adds a track and forgets those that have recovered. NaN and infinite places are left out.
void leaveTrack(ForceSource& source, const glm::dvec2& from, const glm::dvec2& to, double seconds);

}  // namespace sward
