// A bounding hierarchy: which of many boxes a ray meets, the near ones first. Pure.
// Boxes lie in the order of their centres along G. M. Morton's curve (1966), and each node halves its own, down to four
// boxes a leaf (C. Lauterbach et al., Fast BVH Construction on GPUs, 2009). Cost: about 0.04 us a box to make, a
// tenth of that to follow boxes that moved; a ray looks at some hundred of 50,000
// (tests/editor/tools/box_tree_test.cpp). Does not: know what lies in a box (tools/scene_objects.h; triangles:
// reference/ray_scene.h).
#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace sward {

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};  // nothing lies in it at first
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    // Grows to hold a point.
    void add(const glm::dvec3& point) { low = glm::min(low, point), high = glm::max(high, point); }
    // And all of another.
    void add(const Box& box) { low = glm::min(low, box.low), high = glm::max(high, box.high); }
};
// Where origin + t way enters the box, t >= 0 (0: it begins inside); nothing if it does not before `far`.
std::optional<double> entry(const Box& box, const glm::dvec3& origin, const glm::dvec3& way, double far);

class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::vector<Box> boxes);
    // Boxes that are elsewhere now, by their numbers. The nodes keep what they hold and grow or shrink with it, until
    // so many have moved (an eighth of all) that rays would look at too much: then all is made anew.
    void follow(const std::vector<std::pair<uint32_t, Box>>& moved);
    // Calls meet(i, far) for each box that the ray enters before `far`, in lengths of `way`; what it gives back is
    // `far` from then on: where the ray ends in what lies in box i, or `far` as it was. How many boxes were looked at.
    size_t cast(const glm::dvec3& origin, const glm::dvec3& way, double far,
                const std::function<double(size_t i, double far)>& meet) const;

  private:
    struct Node {
        Box box;
        uint32_t first = 0, count = 0;  // a leaf's boxes, in order_; an inner node's second child, count 0
    };
    void make();
    uint32_t build(size_t from, size_t to);
    Box around(const Node& leaf) const;

    std::vector<Box> boxes_;
    std::vector<uint32_t> order_;
    std::vector<Node> nodes_;  // a node's first child comes right after it
    size_t moved_ = 0;         // boxes, since all was made
};

}  // namespace sward
