#include "reference/solids.h"

#include <algorithm>

#include "core/numerics.h"
#include "mesh/mesh_io.h"
#include "scene/tiling.h"
#include "world/forest_stand.h"
#include "world/placement.h"
#include "world/wind.h"

namespace sward {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

Triangles placed(const Mesh& mesh, const glm::dvec3& at, const glm::dmat3& turn) {
    Triangles out;
    out.positions.reserve(mesh.vertices.size());
    for (const MeshVertex& v : mesh.vertices) out.positions.push_back(glm::vec3(at + turn * glm::dvec3(v.position)));
    out.indices = mesh.indices;
    return out;
}

const MeshPart& partOf(const Mesh& mesh, uint32_t triangle) {
    for (const MeshPart& p : mesh.parts)
        if (3 * triangle < p.first + p.count) return p;
    return mesh.parts.back();
}

template <class V>
V across(const Mesh& mesh, const TriangleHit& h, V MeshVertex::*member) {
    const uint32_t* i = &mesh.indices[3 * static_cast<size_t>(h.triangle)];
    return mesh.vertices[i[0]].*member * (1 - h.u - h.v) + mesh.vertices[i[1]].*member * h.u +
           mesh.vertices[i[2]].*member * h.v;
}

glm::vec3 towards(const glm::vec3& n, const glm::dvec3& way) { return glm::dot(glm::dvec3(n), way) > 0 ? -n : n; }

// Places along an axis of a terrain of this size: some on it, and beyond its edges ever farther apart.
std::vector<double> landSteps(double size, double reach) {
    constexpr int kOn = 128;
    std::vector<double> out;
    for (int i = 0; i <= kOn; ++i) out.push_back(size * i / kOn);
    for (double beyond = 0, step = size / kOn; beyond < reach; step *= 1.06) {
        beyond = std::min(beyond + step, reach);
        out.push_back(size + beyond);
        out.push_back(-beyond);
    }
    std::sort(out.begin(), out.end());
    return out;
}
// Adds squares of the land around the terrain. Its corners on the terrain's edge are its inner ones; as they are fewer
// than the terrain's, squares on the edge begin a little under it, so that no ray slips through.
void addLand(Triangles& out, const Terrain& t, const Land& land) {
    const std::vector<double> xs = landSteps(t.size.x, land.reach), zs = landSteps(t.size.y, land.reach);
    const auto first = static_cast<uint32_t>(out.positions.size()), across = static_cast<uint32_t>(xs.size());
    const double under = 0.0005 * std::max(t.size.x, t.size.y);
    for (const double z : zs)
        for (const double x : xs) {
            const bool inside = f64::beyondBy({x, z}, t.size) <= 0;
            out.positions.push_back(glm::vec3(x, landHeight(t, land, x, z) - (inside ? under : 0), z));
        }
    for (uint32_t j = 0; j + 1 < zs.size(); ++j)
        for (uint32_t i = 0; i + 1 < xs.size(); ++i) {
            const bool on = xs[i] >= 0 && xs[i + 1] <= t.size.x && zs[j] >= 0 && zs[j + 1] <= t.size.y;
            const uint32_t a = first + j * across + i, b = a + across;
            if (!on) out.indices.insert(out.indices.end(), {a, b, a + 1, b + 1, a + 1, b});
        }
}

}  // namespace

Result<Solids> Solids::make(const Project& p, double time, const JobControl& control) {
    Solids s;
    s.ground_ = findGround(p);
    std::vector<Triangles> triangles(1);
    if (const Terrain* t = s.ground_.terrain) {
        s.level_ = !t->height.present();
        const Rgba8 soil = t->groundTexture.empty() ? Rgba8{} : loadColorImage(p.dir / t->groundTexture);
        s.soil_ = texelGridOf(soil.pixels.empty() ? makeSoil(256) : soil);
        s.land_ = landOf(p);
        s.surface_ = terrainSurface(*t);
        if (!s.level_) triangles[0] = s.surface_.triangles();
        if (!s.level_ && s.land_.reach > 0) addLand(triangles[0], *t, s.land_);
    }
    for (const PlacedMesh& placedMesh : placedMeshes(p)) {
        if (control.cancelled()) return failed("cancelled");
        const std::string& file = placedMesh.mesh->file;
        if (!s.meshes_.contains(file)) {
            Result<Mesh> mesh = readMesh(p.dir, file);
            if (!mesh) return mesh.error();
            for (const MeshImage& i : mesh->images) s.images_[file].push_back(texelGridOf({i.width, i.height, i.rgba}));
            s.meshes_[file] = std::move(*mesh);
        }
        const Mesh& mesh = s.meshes_[file];
        const glm::dmat3 turn = placedMesh.turn * static_cast<double>(placedMesh.mesh->scale);
        s.objects_.push_back({&mesh, placedMesh.at - s.ground_.origin, turn, turn, placedMesh.mesh->castShadows});
        s.imagesOf_.push_back(&s.images_[file]);
        triangles.push_back(placed(mesh, s.objects_.back().at, s.objects_.back().turn));
    }
    if (Status done = s.addScattered(p, time); !done) return done.error();
    auto scene = RayScene::make(triangles, s.scattered_.instances);
    if (!scene) return scene.error();
    s.scene_ = std::move(*scene);
    return s;
}

Status Solids::addScattered(const Project& p, double time) {
    auto made = scatteredTriangles(p, ground_.origin, false, time);
    if (!made) return made.error();
    scattered_ = std::move(*made);
    for (const Mesh& mesh : scattered_.meshes) {
        std::vector<TexelGrid>& images = scatteredImages_.emplace_back();
        for (const MeshImage& i : mesh.images) images.push_back(texelGridOf({i.width, i.height, i.rgba}));
    }
    // Trees that lean, or stand higher than their meshes, are not turned alone.
    const auto forests = forestsOf(p);
    const bool skewed = windOf(p) != nullptr || std::any_of(forests.begin(), forests.end(),
                                                            [](const auto& f) { return f.second->verticalScale != 1; });
    for (size_t i = 0; i < scattered_.casts.size(); ++i) {
        const TriangleInstances::Placed& at = scattered_.instances.placed[i];
        const bool isTree = i >= scattered_.firstTree;
        const glm::dmat3 turn(at.turn), normals = isTree && skewed ? glm::transpose(glm::inverse(turn)) : turn;
        objects_.push_back({&scattered_.meshes[at.mesh], glm::dvec3(at.at), turn, normals, scattered_.casts[i], true,
                            isTree, isTree ? &scattered_.through[at.mesh] : nullptr});
        imagesOf_.push_back(&scatteredImages_[at.mesh]);
    }
    return {};
}

// Where level ground is met; infinitely far where it is not.
double Solids::flatGround(const Ray& ray) const {
    if (!ground_.terrain || !level_ || ray.way.y == 0) return kNone;
    const double t = -ray.origin.y / ray.way.y;
    const glm::dvec3 at = ray.origin + ray.way * t;
    const bool there = f64::beyondBy({at.x, at.z}, ground_.terrain->size) <= land_.reach;
    return t > ray.near && t < ray.far && there ? t : kNone;
}

bool Solids::isCutOut(const TriangleHit& h) const {
    if (h.mesh == 0) return false;
    const Object& o = objects_[h.mesh - 1];
    const MeshPart& part = partOf(*o.mesh, h.triangle);
    if (part.cutoff <= 0 || part.image < 0) return false;
    const glm::vec2 uv = across(*o.mesh, h, &MeshVertex::uv);
    return (*imagesOf_[h.mesh - 1])[static_cast<size_t>(part.image)].at(uv.x, uv.y, true).w < part.cutoff;
}

// The first triangle that is not cut out and counts.
template <class F>
std::optional<TriangleHit> Solids::closestOf(const RayScene& scene, const Ray& ray, F counts) const {
    double from = ray.near;
    const glm::vec3 way(ray.way);
    while (true) {
        // Begun anew from where it has come to, so that floats count from there.
        const double far = std::min(ray.far - from, 1e30);
        auto hit = scene.closest(glm::vec3(ray.origin + ray.way * from), way, 0, static_cast<float>(far));
        if (!hit) return std::nullopt;
        const double t = from + static_cast<double>(hit->t);
        if (counts(*hit) && !isCutOut(*hit)) {
            hit->t = static_cast<float>(t);
            return hit;
        }
        from = std::max(t + 1e-4, std::nextafter(t, kNone));
    }
}

std::optional<Surface> Solids::closest(const Ray& ray) const {
    const double level = flatGround(ray);
    Ray shorter = ray;
    shorter.far = std::min(ray.far, level);
    const auto hit = closestOf(*scene_, shorter, [](const TriangleHit&) { return true; });
    if (hit) return hit->mesh == 0 ? groundAt(ray, static_cast<double>(hit->t)) : objectAt(ray, *hit);
    if (level < kNone) return groundAt(ray, level);
    return std::nullopt;
}

bool Solids::blocks(const Ray& ray) const {
    const bool hillsCast = ground_.terrain && ground_.terrain->castShadows;
    return closestOf(*scene_, ray,
                     [&](const TriangleHit& h) { return h.mesh == 0 ? hillsCast : objects_[h.mesh - 1].casts; })
        .has_value();
}

glm::dvec3 Solids::onGround(double x, double z) const {
    return ground_.terrain ? glm::dvec3(surface_.at(x, z)) : glm::dvec3(x, 0, z);
}

glm::vec3 Solids::groundNormal(double x, double z) const {
    if (!ground_.terrain) return glm::vec3(0, 1, 0);
    const Terrain& t = *ground_.terrain;
    if (level_ || f64::beyondBy({x, z}, t.size) <= 0) return glm::vec3(terrainNormal(t, x, z));
    const double step = std::max<double>(t.gridSpacing, 0.01 * std::max(t.size.x, t.size.y));
    const auto at = [&](double dx, double dz) { return landHeight(t, land_, x + dx * step, z + dz * step); };
    return glm::vec3(glm::normalize(glm::dvec3(at(-1, 0) - at(1, 0), 2 * step, at(0, -1) - at(0, 1))));
}

// Where the colour of soil comes from: beyond the terrain from along its edge, by the ray's chance.
glm::dvec2 Solids::soilPlace(double x, double z, uint32_t grain) const {
    const glm::dvec2 size = ground_.terrain->size;
    const double beyond = land_.reach > 0 ? f64::beyondBy({x, z}, size) : 0;
    if (!(beyond > 0)) return {x, z};
    return f64::edgePlace({x, z}, size, f64::landSpread(beyond) * (2 * f64::hashUnit(f64::hashMix(grain)) - 1));
}

glm::vec3 Solids::soilAt(double x, double z, uint32_t grain) const {
    const Terrain& t = *ground_.terrain;
    const glm::vec3 soil = glm::vec3(soil_.at(x / t.tileSize, z / t.tileSize, true)) * 2.0f * t.groundColor;
    if (!t.terrainMap.present()) return soil;
    const Tiling tiling = tilingOf(t, t.terrainMapTiling);
    const glm::dvec2 place = (tiling.repeats ? glm::dvec2(x, z) : soilPlace(x, z, grain)) / tiling.metres;
    const glm::vec4 paint = paintedAt(
        t.terrainMap.map, tiling.repeats ? place : glm::clamp(place, glm::dvec2(1e-9), glm::dvec2(1 - 1e-9)), 1, true);
    return f32::soilColor(soil, t.groundColor, glm::vec3(paint), paint.w);
}

Surface Solids::groundAt(const Ray& ray, double t) const {
    Surface s;
    s.met = Met::Ground;
    s.t = t;
    s.at = ray.origin + ray.way * t;
    s.normal = groundNormal(s.at.x, s.at.z);
    s.face = s.normal;
    if (ray.way.y > 0 && level_) s.normal = s.face = -s.normal;
    s.color = soilAt(s.at.x, s.at.z, ray.grain);
    s.beyond = land_.reach > 0 && f64::beyondBy({s.at.x, s.at.z}, ground_.terrain->size) > 0;
    s.place = glm::dvec2(s.at.x, s.at.z) / mapExtent(*ground_.terrain);
    return s;
}

Surface Solids::objectAt(const Ray& ray, const TriangleHit& h) const {
    const Object& o = objects_[h.mesh - 1];
    const MeshPart& part = partOf(*o.mesh, h.triangle);
    Surface s;
    s.met = Met::Object;
    s.ofTree = o.isTree;
    s.object = h.mesh - 1;
    s.t = static_cast<double>(h.t);
    s.at = ray.origin + ray.way * s.t;
    const glm::vec3 flat = o.instanced ? glm::vec3(o.normals * glm::dvec3(h.normal)) : h.normal;
    s.face = towards(glm::normalize(flat), ray.way);
    const glm::vec3 smooth = glm::normalize(glm::vec3(o.normals * glm::dvec3(across(*o.mesh, h, &MeshVertex::normal))));
    s.normal = glm::dot(smooth, s.face) < 0 ? -smooth : smooth;
    s.color = part.color;
    if (o.through) s.looks.x = (*o.through)[static_cast<size_t>(&part - o.mesh->parts.data())];
    if (part.image >= 0) {
        const glm::vec2 uv = across(*o.mesh, h, &MeshVertex::uv);
        s.color *= glm::vec3((*imagesOf_[h.mesh - 1])[static_cast<size_t>(part.image)].at(uv.x, uv.y, true));
    }
    return s;
}

}  // namespace sward
