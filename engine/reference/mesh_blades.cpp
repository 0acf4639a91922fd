#include "reference/mesh_blades.h"

#include "core/numerics.h"
#include "grass/grown.h"
#include "grass/mesh_planting.h"
#include "mesh/carrier.h"
#include "mesh/mesh_io.h"
#include "reference/blade_hits.h"
#include "reference/standing.h"
#include "scene/population.h"
#include "world/ground.h"
#include "world/placement.h"
#include "world/wind.h"

namespace sward {
namespace {

// The carrier's axes at a blade's root, in the world: a blade stands in them as it would on level ground.
struct Axes {
    glm::vec3 tangent, normal, bitangent;
    glm::vec3 inside(const glm::vec3& v) const {
        return {glm::dot(v, tangent), glm::dot(v, normal), glm::dot(v, bitangent)};
    }
    glm::vec3 outside(const glm::vec3& v) const { return tangent * v.x + normal * v.y + bitangent * v.z; }
};
struct PlantedBlade {
    glm::vec3 root;  // relative to the mesh's origin
    Axes axes;
    glm::vec3 control, tip;
    glm::vec2 facing, uv;
    float width, lighter;
    uint32_t kind, blade;  // of the kind's patch
};

// One species on a mesh.
struct MeshKind {
    const Species* species;
    Patch patch;
    TexelGrid image;
    float leanAtFull;
    glm::vec3 clumps;
    WindGlobals wind{};  // about the mesh's origin, as strong as the species feels it
};

// What grows on a mesh where that stands, in which wind.
struct Planting {
    MeshPlanting what;
    glm::dmat3 turn;  // with the scale
    const Wind* wind;
    const Map* gusts;
};

f32::BladeStand standOn(const Planting& p, const MeshKind& kind, const Blade& b, const MeshRoot& root,
                        const PlantedBlade& planted) {
    f32::BladeStand s = f32::emptyStand();
    const MeshGrass& grows = *p.what.on.grows;
    const GrassField& field = p.what.field;
    if (grows.orientation.present()) {
        const glm::vec4 t = paintedAt(grows.orientation.map, glm::dvec2(planted.uv), 1, false);
        s.paint = f32::paintOf(t.x, t.y), s.leanAtFull = kind.leanAtFull;
    }
    if (kind.clumps != glm::vec3(0))
        s.clump = f32::clumpValues(root.cellX, root.cellZ, root.inCell, field.cellSize, kind.species->clumpSize,
                                   static_cast<uint32_t>(field.seed));
    s.clumpLean = kind.clumps.x, s.clumpHeight = kind.clumps.y, s.clumpLightness = kind.clumps.z;
    if (p.wind) {
        const glm::vec2 lean = windLeanAt(kind.wind, *p.gusts, {planted.root.x, planted.root.z}, b.dither);
        const glm::vec3 own = planted.axes.inside({lean.x, 0, lean.y});
        s.wind = {own.x, own.z};
    }
    return s;
}

PlantedBlade pose(const Planting& p, const MeshKind& kind, const MeshRoot& root) {
    const Blade& b = kind.patch.blades[root.blade];
    PlantedBlade out{};
    out.uv = root.uv;
    const glm::vec3 n(glm::normalize(p.turn * root.normal));
    const CarrierFrame f = carrierFrame(n, glm::vec3(p.turn * root.alongU), glm::vec3(p.turn * root.alongV));
    out.axes = {f.tangent, n, f.bitangent};
    out.root = glm::vec3(p.turn * root.position);
    const f32::BladeLean lean = f32::leanOf(standOn(p, kind, b, root, out), b.facing * root.mirror);
    const f32::BladePose pose = f32::poseBlade(b.control, b.tip, b.facing, root.mirror, lean.lean, lean.scale);
    out.control = pose.control, out.tip = pose.tip, out.facing = pose.facing;
    out.width = b.width, out.lighter = lean.lighter, out.blade = root.blade;
    return out;
}

}  // namespace

// The blades of one mesh, and Embree's boxes around them.
struct MeshShell {
    std::string entity;
    glm::dvec3 at{0};  // the mesh's origin
    uint32_t field = 0;
    const MeshGrass* grows = nullptr;
    std::vector<MeshKind> kinds;
    std::vector<PlantedBlade> blades;
    DevicePtr device;
    ScenePtr scene;
};

namespace {

// A ray at one shell, as Embree's callbacks see it. First member: Embree's.
struct ShellQuery {
    RayContext context;
    const MeshShell* shell;
    glm::vec3 origin, way;  // relative to the mesh's origin
    uint32_t grain;
    uint32_t blade = 0;  // of the closest hit
    f32::RibbonHit hit{};
};

// The nearest place in ]near, far[ where the ray meets the blade, and its image's opacity there lets it.
std::optional<f32::RibbonHit> bladeMet(const ShellQuery& q, uint32_t blade, float near, float far) {
    const PlantedBlade& b = q.shell->blades[blade];
    const float chance = f32::hashUnit(f32::hash3(q.grain, blade, b.kind));
    return bladeMetBy({b.axes.inside(q.origin - b.root), b.axes.inside(q.way), b.control, b.tip, b.facing, b.width,
                       q.shell->kinds[b.kind].image, chance},
                      near, far);
}

// The curve lies in the hull of root, control and tip.
void placedBounds(const RTCBoundsFunctionArguments* a) {
    const PlantedBlade& b = static_cast<const MeshShell*>(a->geometryUserPtr)->blades[a->primID];
    const glm::vec3 control = b.root + b.axes.outside(b.control), tip = b.root + b.axes.outside(b.tip);
    const float side = 0.5f * b.width + 1e-5f;
    const glm::vec3 low = glm::min(b.root, glm::min(control, tip)) - side,
                    high = glm::max(b.root, glm::max(control, tip)) + side;
    *a->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
}

Status makeScene(MeshShell& s) {
    s.device.reset(rtcNewDevice(nullptr));
    if (!s.device)
        return failed("rays cannot be prepared: Embree has no memory, or does not know this processor",
                      "close other programs");
    s.scene = sceneOfBoxes<placedBounds>(s.device.get(), s.blades.size(), &s, meetClosestBlade<ShellQuery, bladeMet>,
                                         meetAnyBlade<ShellQuery, bladeMet>);
    return {};
}

MeshKind kindOf(const Project& p, const Species& s, const GrassField& field) {
    const uint32_t seed = static_cast<uint32_t>(field.seed);
    return {&s, makePatch(s, field.cellSize, seed), texelGridOf(bladeImage(p, s)), leanAtFull(s), clumpStrengths(s)};
}

Status growOn(MeshShell& s, const Project& project, const Planting& p, double time, const JobControl& control) {
    const auto cells = cellsOf(p.what);
    if (!cells) return cells.error();
    for (const Species& species : p.what.field.species) {
        MeshKind kind = kindOf(project, species, p.what.field);
        if (kind.patch.blades.empty()) continue;
        if (p.wind)
            kind.wind = windGlobals(*p.wind, {s.at.x, s.at.z}, time),
            kind.wind.strength = windStrength(*p.wind, species);
        const size_t before = s.blades.size();
        if (!plantOn(p.what, *cells, species, kind.patch, control,
                     [&](const MeshRoot& root) { s.blades.push_back(pose(p, kind, root)); }))
            return failed("cancelled");
        for (size_t i = before; i < s.blades.size(); ++i) s.blades[i].kind = static_cast<uint32_t>(s.kinds.size());
        s.kinds.push_back(std::move(kind));
    }
    return makeScene(s);
}

Surface surfaceOf(const MeshShell& shell, const Ray& ray, const ShellQuery& q, double t) {
    const PlantedBlade& b = shell.blades[q.blade];
    const MeshKind& kind = shell.kinds[b.kind];
    const Species& species = *kind.species;
    const Blade& own = kind.patch.blades[b.blade];
    const float v = q.hit.v;
    Surface s;
    s.met = Met::Blade;
    s.onMesh = true;
    s.t = t;
    s.at = ray.origin + ray.way * t;
    s.normal = b.axes.outside(f32::bladeFrameFacing(b.control, b.tip, b.facing, v).normal);
    if (glm::dot(glm::dvec3(s.normal), ray.way) > 0) s.normal = -s.normal;
    s.face = s.normal;
    s.color = f32::bladeTint(f32::bladeGradient(species.rootColor, species.midColor, species.tipColor, v), own.hue,
                             own.lightness * b.lighter);
    if (shell.grows->vegetation.present()) {
        const glm::vec4 paint = paintedAt(shell.grows->vegetation.map, glm::dvec2(b.uv), 1, true);
        s.color = glm::mix(s.color, glm::vec3(paint), paint.w);
    }
    s.looks = {species.translucency, species.gloss, species.roughness};
    s.tint = 2.0f * glm::vec3(kind.image.at(static_cast<double>(q.hit.across) + 0.5, static_cast<double>(v), false));
    s.open = glm::mix(species.rootOcclusion, 1.0f, v);
    s.field = shell.field;
    return s;
}

ShellQuery queryOf(const MeshShell& shell, const Ray& ray) {
    return {{}, &shell, glm::vec3(ray.origin + ray.way * ray.near - shell.at), glm::vec3(ray.way), ray.grain};
}
float lengthOf(const Ray& ray) { return static_cast<float>(std::min(ray.far - ray.near, 1e30)); }

}  // namespace

MeshBlades::MeshBlades() = default;
MeshBlades::MeshBlades(MeshBlades&&) noexcept = default;
MeshBlades& MeshBlades::operator=(MeshBlades&&) noexcept = default;
MeshBlades::~MeshBlades() = default;

Result<MeshBlades> MeshBlades::make(const Project& p, double time, const JobControl& control) {
    MeshBlades out;
    const Ground ground = findGround(p);
    const Wind* wind = windOf(p);
    Map made;
    const Map* gusts = wind ? &gustsOf(*wind, made) : nullptr;
    std::map<std::string, MeshCarrier> carriers;
    std::map<std::string, std::pair<uint32_t, const GrassField*>> fields;
    for (const auto& [name, field] : fieldsOf(p)) fields[name] = {static_cast<uint32_t>(fields.size()), &field.grows};
    double asked = 0;
    for (const GrassyMesh& on : grassyMeshes(p)) {
        const PlacedMesh placed = placeMesh(p, on.entity);
        const std::string& file = placed.mesh->file;
        if (!carriers.contains(file)) {
            const Result<Mesh> mesh = readMesh(p.dir, file);
            if (!mesh) return mesh.error();
            carriers[file] = carrierOf(*mesh);
        }
        const MeshCarrier& carrier = carriers[file];
        if (carrier.surface == 0) return noTextureCoordinates(on.name, file);
        const double scale = static_cast<double>(placed.mesh->scale);
        const auto& [number, field] = fields.at(on.field);
        const Planting planting{
            {carrier, on, *field, uvLengthOf(*on.grows, carrier, scale)}, placed.turn * scale, wind, gusts};
        asked += bladesAsked(planting.what);
        if (asked > kMaxMeshBlades)
            return unsound(
                fmt::format("{}.MeshGrass: with it {:.1f} million blades stand on meshes; the truth traces {:.0f} "
                            "million",
                            on.name, asked / 1e6, kMaxMeshBlades / 1e6),
                "lower bladesPerM2, or the objects' sizes");
        auto shell = std::make_unique<MeshShell>();
        shell->entity = on.name;
        shell->at = placed.at - ground.origin;
        shell->field = number;
        shell->grows = on.grows;
        if (Status s = growOn(*shell, p, planting, time, control); !s) return s.error();
        out.shells_.push_back(std::move(shell));
    }
    return out;
}

std::optional<Surface> MeshBlades::closest(const Ray& ray) const {
    Ray left = ray;
    std::optional<Surface> found;
    for (const auto& shell : shells_) {
        ShellQuery q = queryOf(*shell, left);
        RTCRayHit hit{embreeRay(q.origin, q.way, 0, lengthOf(left)), {}};
        closestHit(shell->scene.get(), q.context, hit);
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
        left.far = left.near + static_cast<double>(hit.ray.tfar);
        found = surfaceOf(*shell, ray, q, left.far);
    }
    return found;
}

bool MeshBlades::blocks(const Ray& ray) const {
    for (const auto& shell : shells_) {
        ShellQuery q = queryOf(*shell, ray);
        if (anyHit(shell->scene.get(), q.context, embreeRay(q.origin, q.way, 0, lengthOf(ray)))) return true;
    }
    return false;
}

Result<std::vector<StandingOnMesh>> standingOnMeshes(const Project& p, double time, const JobControl& control) {
    const auto all = MeshBlades::make(p, time, control);
    if (!all) return all.error();
    return all->standing();
}

std::vector<StandingOnMesh> MeshBlades::standing() const {
    std::vector<StandingOnMesh> out;
    for (const auto& shell : shells_) {
        const size_t first = out.size();
        for (const MeshKind& kind : shell->kinds) out.push_back({shell->entity, kind.species, shell->at, {}});
        for (const PlantedBlade& b : shell->blades)
            out[first + b.kind].blades.push_back({{b.root, b.control, b.tip, b.facing, b.width, b.lighter},
                                                  {b.axes.tangent, b.axes.normal, b.axes.bitangent}});
    }
    return out;
}

size_t MeshBlades::count() const {
    size_t n = 0;
    for (const auto& shell : shells_) n += shell->blades.size();
    return n;
}

}  // namespace sward
