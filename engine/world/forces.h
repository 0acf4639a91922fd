// What presses on the grass: what stands on it now, and the tracks that it left, which recover.
// Source: Jahrmann and Wimmer 2013, section 5.2; J-8. Formulas: numerics/gust.h. Does not: bend blades, walk.
// Shapes of tracks: editor/playtest/tracks.h. One list for all techniques and for the reference; it has what still
// presses, so its length does not grow with time.
#pragma once
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "mesh/footprint.h"
#include "scene/project.h"

namespace sward {

// Something long and round that lies from `from` to `to`, metres relative to the terrain's corner; or of an object's
// outline.
struct Force {
    glm::dvec2 from{0}, to{0};
    float radius = 0;  // of where it presses blades down, about the line between them
    float reach = 0;   // radii out to which it pushes them aside
    float share = 0;   // ]0, 1]: of its strength that is left
    std::shared_ptr<const Footprint> outline =
        nullptr;  // about `from`: it presses inside, and radius and reach are of its rim; null: long and round
    glm::vec2 heading{1, 0};  // cosine and sine of the outline's turn about the vertical, counter-clockwise from above
    float scale = 1;          // metres a unit of the outline
};
// Around the line between `from` and `to`, metres (along x and z) that the force reaches at most.
float farOf(const Force& f);

// Outlines that were made, so that who asks each frame makes none twice. A raster is one mesh's, tilted and cut as the
// object stands: turn and scale are the force's. One stands until the mesh's file changes or nobody asks for it.
class Outlines {
  public:
    // Of the entity's StaticMesh: what of it is lower than the tallest blade over the ground at its Transform. Null
    // where it has none, its file cannot be read (both told once, naming the entity and what to do) or nothing of it is
    // so low.
    std::shared_ptr<const Footprint> of(const Project& p, const std::string& entity);
    // Forgets those that were not asked for since the last call.
    void sweep();
    size_t count() const { return made_.size(); }

  private:
    struct Entry {
        std::shared_ptr<const Footprint> footprint;
        bool asked = true;
    };
    std::map<std::string, Entry> made_;  // by file, its version, tilt and height
    std::set<std::string> told_;
};

// In the order of their entities' names, each one's oldest track first. `outlines`: where outlines are kept from call
// to call; null: made for this one.
std::vector<Force> forcesOf(const Project& p, double seconds, Outlines* outlines = nullptr);

// x, y: push aside (metres a metre, at most 1 long); z: press in [0, 1]; at a place relative to the terrain's corner.
// The technique holds the same in a map around the eye (grass/forces.h), whose texels are its error.
glm::vec3 forceAt(std::span<const Force> forces, const glm::dvec2& place);
// Share of a track's strength that is left after so many seconds: falls smoothly from 1 to 0 in `recovery`; infinite:
// it stays.
double trackLeft(double age, float recovery);

// Adds a track and forgets those that have recovered. NaN and infinite places are left out.
void leaveTrack(ForceSource& source, const glm::dvec2& from, const glm::dvec2& to, double seconds);

}  // namespace sward
