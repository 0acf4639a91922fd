// Ground and objects as rays meet them. Does not: grass, light.
#pragma once
#include <optional>

#include "core/jobs.h"
#include "mesh/mesh.h"
#include "reference/ray_scene.h"
#include "reference/scene_rays.h"
#include "reference/surface.h"
#include "scene/project.h"
#include "world/ground.h"
#include "world/land.h"

namespace sward {

class Solids {
  public:
    // At a scene time (s), at which wind leans trees. `p` must outlive it. Errors: an object's file that cannot be
    // read; Failed without memory or when cancelled.
    static Result<Solids> make(const Project& p, double time, const JobControl& control);
    // The first surface on the ray.
    std::optional<Surface> closest(const Ray& ray) const;
    // Whether a shadow falls: only what casts shadows counts.
    bool blocks(const Ray& ray) const;
    const Ground& ground() const { return ground_; }
    const Land& land() const { return land_; }
    // The point of the terrain's triangles over or under these terrain-relative metres, clamped to the terrain.
    glm::dvec3 onGround(double x, double z) const;
    // Unit, upward; by the terrain's own map.
    glm::vec3 groundNormal(double x, double z) const;

  private:
    struct Object {
        const Mesh* mesh;
        glm::dvec3 at;
        glm::dmat3 turn, normals;  // of its places; of its normals, which leaning turns otherwise
        bool casts;
        bool instanced = false;                       // its triangles' normals are not turned
        bool isTree = false;                          // of a forest
        const std::vector<float>* through = nullptr;  // by part, of a tree
    };
    Solids() = default;
    Status addScattered(const Project& p, double time);
    Surface groundAt(const Ray& ray, double t) const;
    Surface objectAt(const Ray& ray, const TriangleHit& hit) const;
    glm::dvec2 soilPlace(double x, double z, uint32_t grain) const;
    glm::vec3 soilAt(double x, double z, uint32_t grain) const;
    bool isCutOut(const TriangleHit& hit) const;
    template <class F>
    std::optional<TriangleHit> closestOf(const RayScene& scene, const Ray& ray, F counts) const;
    double flatGround(const Ray& ray) const;

    Ground ground_;
    Land land_;
    bool level_ = true;
    TerrainSurface surface_;
    TexelGrid soil_;
    std::map<std::string, Mesh> meshes_;
    std::map<std::string, std::vector<TexelGrid>> images_;
    std::vector<Object> objects_;  // mesh i + 1 of the scene; mesh 0 is the ground; at last the scattered ones
    std::vector<const std::vector<TexelGrid>*> imagesOf_;
    ScatteredTriangles scattered_;
    std::vector<std::vector<TexelGrid>> scatteredImages_;  // as its meshes
    std::optional<RayScene> scene_;
};

}  // namespace sward
