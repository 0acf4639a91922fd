#include "grass/on_mesh.h"

#include <fmt/format.h>

#include "frame/gpu_mesh.h"
#include "world/placement.h"

namespace sward {

MeshMaps mapsOn(DrawContext& ctx, const Field& field, const GrassyMesh& on, bool blades) {
    constexpr const char* kOwner = "grass/mesh-grass";
    const MeshGrass& g = *on.grows;
    const auto texture = [&](const MapField& m, const char* name, bool srgb) {
        return m.present()
                   ? ctx.maps.get(fmt::format("{}/{}", kOwner, name), on.name + ".MeshGrass." + name, m.map, srgb, true)
                   : 0;
    };
    MeshMaps maps;
    maps.density = texture(g.density, "density", false);
    maps.vegetation = texture(g.vegetation, "vegetation", true);
    maps.orientation = texture(g.orientation, "orientation", false);
    FeatureSet own =
        field.view->own & featureSet(Feature::Grass, Feature::GrassOnMeshes, Feature::GrassMeshGeometry,
                                     Feature::GrassClumps, Feature::Translucency, Feature::Gloss, Feature::GrassBlended,
                                     Feature::BladeShadows, Feature::GrassTraced, Feature::FarDarkening);
    if (!blades) own &= ~featureSet(Feature::GrassMeshGeometry);
    if (maps.density) own |= featureSet(Feature::GrassDensity);
    if (maps.vegetation) own |= featureSet(Feature::GrassVegetation);
    if (maps.orientation) own |= featureSet(Feature::GrassOrientation);
    maps.features = featureConstants(featuresFor(ctx, own));
    return maps;
}

void bindMaps(const MeshMaps& maps) {
    for (const auto& [unit, texture] : {std::pair<GLuint, GLuint>{TEX_DENSITY, maps.density},
                                        {TEX_VEGETATION, maps.vegetation},
                                        {TEX_ORIENTATION, maps.orientation}})
        if (texture) glBindTextureUnit(unit, texture);
}

const Field* fieldNamed(const DrawContext& ctx, const std::string& name) {
    for (const std::unique_ptr<Field>& field : ctx.shared.grass->all)
        if (field->grown->name == name) return field.get();
    return nullptr;
}

glm::vec3 MeshPlace::operator()(const glm::vec3& at) const {
    const glm::vec4 p(at, 1);
    return {glm::dot(rows[0], p), glm::dot(rows[1], p), glm::dot(rows[2], p)};
}

glm::vec3 MeshPlace::turned(const glm::vec3& way) const {
    return glm::vec3(glm::dot(glm::vec3(rows[0]), way), glm::dot(glm::vec3(rows[1]), way),
                     glm::dot(glm::vec3(rows[2]), way)) /
           scale;
}

void MeshPlace::set() const {
    glUniform4fv(10, 3, &rows[0].x);
    glUniform1f(13, scale);
}

MeshPlace placeOn(const DrawContext& ctx, Entity mesh) {
    const PlacedMesh placed = placeMesh(ctx.project, mesh);
    MeshPlace out;
    out.scale = placed.mesh->scale;
    // As the object is drawn by: the surface lies exactly where that was.
    const ObjectInstance on = instanceAt(placed.at - ctx.camera.eye, placed.turn * double(out.scale));
    std::copy(std::begin(on.row), std::end(on.row), std::begin(out.rows));
    return out;
}

}  // namespace sward
