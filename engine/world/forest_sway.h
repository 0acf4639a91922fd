// How the wind leans the trees of a forest: each by what blows at its foot at a scene time, over the forest's stiffness
// (m per m), for meshes and for the truth alike. Volumes shear their look-ups by the same (forest/texcells.vert.glsl).
// Does not: bend branches, or move a foot. Cost: 60 ns a tree.
#pragma once
#include <glm/glm.hpp>

#include "scene/forest.h"
#include "world/wind.h"

namespace sward {

class TreeSway {
  public:
    TreeSway() = default;
    TreeSway(const TreeSway&) = delete;
    TreeSway& operator=(const TreeSway&) = delete;
    // wind: null in a calm; it must outlive what is asked. eye: from the terrain's corner (m), from which places count.
    void follow(const Wind* wind, const glm::dvec2& eye, double seconds);
    bool blows() const { return wind_ != nullptr; }
    // What wind does to a tree with its foot there (x, z from the eye; m): what stands leans, the foot stays. In a calm
    // exactly nothing.
    glm::dmat3 at(const Forest& forest, const glm::dvec2& foot) const;

  private:
    const Wind* wind_ = nullptr;
    const Map* gusts_ = nullptr;
    Map made_;  // kept from frame to frame, once it is needed
    WindGlobals globals_{};
};

}  // namespace sward
