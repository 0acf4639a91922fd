// The project's objects as a ray from the eye meets them, and their boxes.
// Triangles are those of the reference tracer's Embree scenes (reference/ray_scene.h), one a file however many entities
// show it; above them hierarchies of the objects' boxes (tools/box_tree.h), one for the entities' own, which follows
// those that moved when it is next asked, and one for each Scatter and each Forest, made anew when its objects are
// others.
// Cost: a file is read once for each time it was written; for times see bench --limits --filter=pick. Does not: know
// the ground, or what is selected.
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
#include "world/forest_stand.h"
#include "world/ground.h"
#include "world/scatter.h"

namespace sward {

// One file's object, in its own lengths.
struct ObjectShape {
    std::string version;  // of the file, as it was read
    Box bounds;           // empty: it cannot be read
    std::optional<RayScene> triangles;
};
using Corners = std::array<glm::dvec3, 8>;  // in the world; bit 0 of the index: high x, bit 1: y, bit 2: z
struct ObjectHit {
    std::string entity;
    double distance = 0;     // in lengths of the ray's direction
    std::string which = {};  // of a rule's many: "spruce, 11 m high, one of 1630"; empty: it is the entity's only one
    Corners corners = {};    // around that one
};

class SceneObjects {
  public:
    // The first object on origin + t way, be it an entity's own, one that an entity's Scatter puts there, or a tree of
    // its Forest (as it stands without wind). `revision`:
    // of the document (Document::revision); what is Hidden or Locked is not met.
    std::optional<ObjectHit> closest(const Project& p, uint64_t revision, const glm::dvec3& origin,
                                     const glm::dvec3& way);
    // The box around an entity's object, turned with it; nothing if it has none that can be read.
    std::optional<Corners> cornersOf(const Project& p, const Ground& ground, const std::string& entity);
    // The same of a file's object that would stand at a place; nothing if it cannot be read.
    std::optional<Corners> cornersAt(const Project& p, const std::string& file, const glm::dvec3& at);
    // Reads one file of the entities' own objects that nobody asked for yet, so that the first question need not wait
    // for all of them. True: it read one; there may be more.
    bool readAhead(const Project& p);
    // Whether a file was read already: what is asked of its objects then costs nothing more.
    bool hasRead(const Project& p, const std::string& file) const { return dir_ == p.dir && shapes_.contains(file); }
    // Boxes that the last ray looked at.
    size_t looked() const { return looked_; }

  private:
    struct Placed {
        glm::dvec3 at;
        glm::dmat3 turn;  // with the scale
        const ObjectShape* shape;
    };
    // What an entity's own object is placed by.
    struct Source {
        glm::dvec3 at, rotationDeg;
        float scale;
        bool onGround;
        const ObjectShape* shape;
        bool operator==(const Source&) const = default;
    };
    // Objects under one hierarchy.
    struct Group {
        std::vector<std::string> entities;  // of each, or one for all
        std::vector<Placed> placed;         // as the tree's boxes
        BoxTree tree;
        std::shared_ptr<const Scattering> of;  // of a Scatter: what it was made of
    };
    // The trees of a Forest, and what they were made of.
    struct Grove {
        Group trees;
        Forest rule;
        std::optional<Terrain> terrain;
        glm::dvec3 origin{0};
        std::vector<std::string> files;  // versions of the species' files
        std::vector<std::unique_ptr<ObjectShape>> species;
        std::vector<uint32_t> speciesOf;  // of each tree
    };
    const ObjectShape& shapeOf(const Project& p, const std::string& file);
    void forgetChangedFiles(const Project& p);
    void followOwn(const Project& p, const Ground& ground);
    bool groundMoved(const Ground& ground);
    void followScattered(const Project& p, const Ground& ground);
    void followForests(const Project& p, const Ground& ground);
    void follow(const Project& p, uint64_t revision);
    ObjectHit hitOf(const Group& group, size_t i, double distance) const;

    std::map<std::string, ObjectShape> shapes_;  // by file
    Group own_;                                  // of StaticMesh
    std::vector<Source> sources_;                // of each in it
    std::optional<Terrain> ownGround_;           // that they stand on
    glm::dvec3 ownOrigin_{0};
    std::map<std::string, Group> rules_;   // of Scatter, by entity
    std::map<std::string, Grove> groves_;  // of Forest, by entity
    std::filesystem::path dir_;
    uint64_t revision_ = 0;
    ScatterMemory scattered_;
    size_t looked_ = 0;
};

}  // namespace sward
