#include "grass/mesh_grass_settings.h"

#include "mesh/mesh_io.h"
#include "scene/field_rows.h"

namespace sward {
namespace {

bool hasBlades(const GrassField& field) {
    return std::any_of(field.species.begin(), field.species.end(), [](const Species& s) { return s.bladesPerM2 > 0; });
}

// The entity of the field that a mesh carries; kNoEntity: there is none.
Entity fieldOf(const Registry& registry, const MeshGrass& grows) {
    Entity found = kNoEntity;
    std::string_view first;
    registry.each<GrassField>([&](Entity e, const GrassField&) {
        const Name* name = registry.get<Name>(e);
        if (!name || (!grows.field.empty() && name->value != grows.field)) return;
        if (found != kNoEntity && name->value >= first) return;
        found = e;
        first = name->value;
    });
    return found;
}

bool isCarrier(const Registry& registry, Entity e) {
    const StaticMesh* mesh = registry.get<StaticMesh>(e);
    return mesh && !mesh->file.empty();
}

FeatureSet featuresOfMeshGrass(const Registry& registry, Entity e, const Tables&, bool) {
    const Entity field = fieldOf(registry, *registry.get<MeshGrass>(e));
    const bool grows = isCarrier(registry, e) && field != kNoEntity && hasBlades(*registry.get<GrassField>(field));
    return grows ? featureSet(Feature::GrassOnMeshes) : FeatureSet{};
}

void checkMeshGrass(const Registry& registry, Entity e, const std::string& path, std::vector<ComponentFault>& out) {
    const MeshGrass& grows = *registry.get<MeshGrass>(e);
    if (!isCarrier(registry, e))
        out.push_back({"", path + ": its entity has no StaticMesh with a file: nothing grows; add one", true});
    if (fieldOf(registry, grows) != kNoEntity) return;
    out.push_back({"field",
                   grows.field.empty()
                       ? path + ".field: there is no GrassField whose blades could grow on the mesh; add one"
                       : fmt::format("{}.field: \"{}\" is no entity with a GrassField; name one, or leave it empty for "
                                     "the first",
                                     path, grows.field),
                   true});
}

void checkFiles(const Project& p, Entity e, const std::string& path, std::vector<Error>& refused,
                std::vector<ComponentFault>& noticed) {
    if (!isCarrier(p.registry, e)) return;
    const std::string& file = p.registry.get<StaticMesh>(e)->file;
    const Result<Mesh> mesh = readMesh(p.dir, file);
    if (!mesh) return;  // refused with the StaticMesh
    const MeshCarrier carrier = carrierOf(*mesh);
    if (carrier.surface == 0) return refused.push_back(noTextureCoordinates(p.registry.get<Name>(e)->value, file));
    if (carrier.unmapped > 0) noticed.push_back({"", path + ": " + unmappedTriangles(file, carrier)});
}

constexpr MapRow kMeshDensity{.onMesh = true};
constexpr MapRow kMeshOrientation{.kind = MapKind::Directions, .channels = 2, .onMesh = true};
constexpr MapRow kMeshVegetation{.kind = MapKind::Colours,
                                 .channels = 4,
                                 .type = PixelType::U8,
                                 .least = "0 grass",
                                 .most = "1 covered",
                                 .onMesh = true};

}  // namespace

ComponentRow meshGrassRow() {
    static constexpr FieldRow kFields[] = {
        entityName("field", offsetof(MeshGrass, field),
                   "entity of the GrassField whose species grow on the mesh; none: the first by name"),
        titled("Length of one uv",
               real("uvLength", offsetof(MeshGrass, uvLength), "m", {0, 1e4, 0, 10},
                    "length that one unit of the mesh's texture coordinates is; 0: what it is in the mean")),
        map("density", offsetof(MeshGrass, density), &kMeshDensity,
            "where it grows: share of the species' bladesPerM2, over the texture coordinates; none: everywhere"),
        map("vegetation", offsetof(MeshGrass, vegetation), &kMeshVegetation,
            "colour and opacity over the blades' own colour, over the texture coordinates"),
        map("orientation", offsetof(MeshGrass, orientation), &kMeshOrientation,
            "direction along u, v about 0.5 in which blades lean, over the texture coordinates"),
    };
    ComponentRow row = componentRow<MeshGrass>("MeshGrass", "A field's grass grows on this entity's StaticMesh.",
                                               kFields, [](const void*) { return FeatureSet{}; });
    row.featuresOnEntity = featuresOfMeshGrass;
    row.check = checkMeshGrass;
    row.checkFiles = checkFiles;
    return row;
}

std::vector<GrassyMesh> grassyMeshes(const Project& project) {
    std::vector<GrassyMesh> out;
    for (const auto& [name, e] : project.entities) {
        const MeshGrass* grows = project.registry.get<MeshGrass>(e);
        if (!grows || !isCarrier(project.registry, e)) continue;
        const Entity field = fieldOf(project.registry, *grows);
        if (field == kNoEntity || !hasBlades(*project.registry.get<GrassField>(field))) continue;
        out.push_back({name, e, grows, project.registry.get<Name>(field)->value});
    }
    return out;
}

double uvLengthOf(const MeshGrass& grows, const MeshCarrier& carrier, double scale) {
    return grows.uvLength > 0 ? static_cast<double>(grows.uvLength) : lengthOfUv(carrier) * scale;
}

Error noTextureCoordinates(const std::string& entity, const std::string& file) {
    return unsound(entity + ".MeshGrass: " + file + " has no texture coordinates on which grass could grow",
                   "unwrap the object where you made it, or remove MeshGrass");
}

std::string unmappedTriangles(const std::string& file, const MeshCarrier& carrier) {
    return fmt::format("{} of {}'s triangles have no area in texture coordinates: no grass grows on them",
                       carrier.unmapped, file);
}

bool growsOnMeshes(const FieldEntity& field) {
    bool found = false;
    field.registry.each<MeshGrass>([&](Entity e, const MeshGrass& grows) {
        found = found || (isCarrier(field.registry, e) && fieldOf(field.registry, grows) == field.entity);
    });
    return found;
}

}  // namespace sward
