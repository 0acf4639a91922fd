// Objects' meshes on the GPU, one a file however often it is shown, and how instances of one are drawn. For the effects
// of objects and of forests. Does not: know where instances stand.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "frame/draw_context.h"
#include "mesh/mesh.h"
#include "shared/objects.h"

namespace sward {

struct GpuMesh {
    std::string version = "?";  // of the file, as it was read
    Buffer vertices, indices;
    VertexArray mesh;
    std::vector<Texture> images;
    std::vector<MeshPart> parts;  // none: the file cannot be read
    std::vector<float> leaves;    // by part: share through which light shines (mesh/facing.h); none: not asked for
    glm::vec3 centre{0};
    float radius = 0;
};

// The mesh on the GPU, charged to `owner`.
GpuMesh uploadMesh(Gpu& gpu, const char* owner, const Mesh& mesh);
// Draws instances [first, first + count[ of the buffer that the mesh's vertex array has; the program is current. white:
// a texture of one white texel, for parts without an image.
void drawMesh(DrawContext& ctx, const GpuMesh& mesh, const Texture& white, size_t first, size_t count);

class GpuMeshes {
  public:
    // `owner` ("domain/stem") is charged for their bytes; it must outlive this.
    GpuMeshes(Gpu& gpu, const char* owner);
    // The file's mesh; read again when the file changed. What cannot be read is told once and not drawn.
    const GpuMesh& of(DrawContext& ctx, const std::string& file);
    // The version of a file that `of` has seen.
    const std::string& version(const std::string& file) const { return meshes_.at(file).version; }
    // Forgets the files for which it is false.
    template <class F>
    void keepIf(const F& wanted) {
        std::erase_if(meshes_, [&](const auto& m) { return !wanted(m.first); });
    }
    // drawMesh with the white texture of these.
    void draw(DrawContext& ctx, const GpuMesh& mesh, size_t first, size_t count) const {
        drawMesh(ctx, mesh, white_, first, count);
    }

  private:
    const char* owner_;
    std::map<std::string, GpuMesh> meshes_;  // by file
    Texture white_;
};

// A matrix (rotation and scale) at a place relative to the eye.
ObjectInstance instanceAt(const glm::dvec3& at, const glm::dmat3& turn);
// Adds the mesh's triangles to what casts shadows, within a ball relative to the eye.
void addCaster(DrawContext& ctx, const GpuMesh& mesh, size_t first, size_t count, const glm::vec3& centre,
               float radius);

}  // namespace sward
