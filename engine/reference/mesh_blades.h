// Rays through the grass that grows on meshes: every blade that a MeshGrass calls for, posed on its own frame of the
// surface and met exactly (numerics/ribbon.h). Blades keep their size where texture coordinates stretch; only where
// they stand follows these. Does not: the terrain's grass (grass_rays.h), nor forces, which press on the terrain's
// alone. Cost: 150 bytes and 1 us a blade to plant, of which there are at most kMaxMeshBlades.
#pragma once
#include <memory>
#include <optional>

#include "core/jobs.h"
#include "reference/standing.h"
#include "reference/surface.h"
#include "scene/project.h"

namespace sward {

struct MeshShell;

class MeshBlades {
  public:
    // As the project's wind bends them at a scene time; `p` must outlive it. Errors: a mesh that cannot be read or has
    // no texture coordinates; too many blades; Failed without memory or when cancelled.
    static Result<MeshBlades> make(const Project& p, double time, const JobControl& control);
    MeshBlades(MeshBlades&&) noexcept;
    MeshBlades& operator=(MeshBlades&&) noexcept;
    ~MeshBlades();
    // From any thread.
    std::optional<Surface> closest(const Ray& ray) const;
    bool blocks(const Ray& ray) const;
    size_t count() const;  // blades of all meshes
    // Each of them where it stands.
    std::vector<StandingOnMesh> standing() const;

  private:
    MeshBlades();
    std::vector<std::unique_ptr<MeshShell>> shells_;
};

}  // namespace sward
