// The project's objects as a ray from the eye meets them, and their boxes.
// Triangles are those of the reference tracer's Embree scenes (reference/ray_scene.h), one a file however many entities
// show it; above them a hierarchy of the objects' boxes (tools/box_tree.h), made anew after a change when it is next
// asked. Cost: a file is read once for each time it was written; 50,000 objects: 40 ms after a change, 5 us a ray. Does
// not: know the ground, or what is selected.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/ray_scene.h"
#include "scene/project.h"
#include "tools/box_tree.h"
#include "world/ground.h"
#include "world/scatter.h"

namespace sward {

// One file's object, in its own lengths.
struct ObjectShape {
    std::string version;  // of the file, as it was read
    Box bounds;           // empty: it cannot be read
    std::optional<RayScene> triangles;
};
struct ObjectHit {
    std::string entity;
    double distance = 0;  // in lengths of the ray's direction
};
using Corners = std::array<glm::dvec3, 8>;  // in the world; bit 0 of the index: high x, bit 1: y, bit 2: z

class SceneObjects {
  public:
    // The first object on origin + t way, be it an entity's own or one that an entity's Scatter puts there. `revision`:
    // of the document (Document::revision); what is Hidden or Locked is not met.
    std::optional<ObjectHit> closest(const Project& p, uint64_t revision, const glm::dvec3& origin,
                                     const glm::dvec3& way);
    // The box around an entity's object, turned with it; nothing if it has none that can be read.
    std::optional<Corners> cornersOf(const Project& p, const Ground& ground, const std::string& entity);
    // The same of a file's object that would stand at a place; nothing if it cannot be read.
    std::optional<Corners> cornersAt(const Project& p, const std::string& file, const glm::dvec3& at);
    // Boxes that the last ray looked at.
    size_t looked() const { return looked_; }

  private:
    struct Placed {
        std::string entity;
        glm::dvec3 at;
        glm::dmat3 turn;  // with the scale
        const ObjectShape* shape;
    };
    const ObjectShape& shapeOf(const Project& p, const std::string& file);
    void add(std::vector<Box>& boxes, Placed placed);
    void addScattered(std::vector<Box>& boxes, const Project& p, const Ground& ground);
    void follow(const Project& p, uint64_t revision);

    std::map<std::string, ObjectShape> shapes_;  // by file
    std::vector<Placed> placed_;                 // as the tree's boxes
    BoxTree tree_;
    std::filesystem::path dir_;
    uint64_t revision_ = 0;
    ScatterMemory scattered_;
    size_t looked_ = 0;
};

}  // namespace sward
