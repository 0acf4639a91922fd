#include "reference/scene_rays.h"

#include "core/hash.h"
#include "core/save_folder.h"
#include "mesh/facing.h"
#include "mesh/mesh_io.h"
#include "scene/tiling.h"
#include "world/forest_stand.h"
#include "world/forest_sway.h"
#include "world/ground.h"
#include "world/placement.h"
#include "world/scatter.h"

namespace sward {
namespace {

constexpr int kMaxQuads = 1024;

size_t vertexAt(const TerrainSurface& s, int x, int z) {
    return static_cast<size_t>(z) * static_cast<size_t>(s.quadsX + 1) + static_cast<size_t>(x);
}

Triangles placedTriangles(const Mesh& mesh, const PlacedMesh& placed, const glm::dvec3& origin) {
    Triangles out;
    out.positions.reserve(mesh.vertices.size());
    const glm::dvec3 at = placed.at - origin;
    for (const MeshVertex& v : mesh.vertices)
        out.positions.push_back(
            glm::vec3(at + placed.turn * (glm::dvec3(v.position) * static_cast<double>(placed.mesh->scale))));
    out.indices = mesh.indices;
    return out;
}

bool isTaken(const Project& p, const PlacedMesh& m, SolidsTaken taken) {
    return m.mesh->castShadows && (taken == SolidsTaken::All || !hasTracedLight(p, m));
}

// Adds a mesh that is shown by instances; returns its number.
uint32_t addMesh(ScatteredTriangles& out, Mesh mesh, const std::string& file, std::vector<float> through = {}) {
    Triangles& shown = out.instances.meshes.emplace_back();
    for (const MeshVertex& v : mesh.vertices) shown.positions.push_back(v.position);
    shown.indices = mesh.indices;
    out.files.push_back(file);
    out.through.push_back(std::move(through));
    out.meshes.push_back(std::move(mesh));
    return static_cast<uint32_t>(out.meshes.size()) - 1;
}

Status addForests(ScatteredTriangles& out, const Project& p, const Ground& ground, const glm::dvec3& origin,
                  bool castersAlone, std::optional<double> time) {
    TreeSway sway;
    sway.follow(time ? windOf(p) : nullptr, {0, 0}, time.value_or(0));
    for (const auto& [entity, forest] : forestsOf(p)) {
        if (castersAlone && !forest->castShadows) continue;
        std::vector<uint32_t> meshOf(forest->species.size());
        for (size_t i = 0; i < meshOf.size(); ++i) {
            if (!stands(forest->species[i])) continue;
            Result<Mesh> mesh = treeMesh(p.dir, forest->species[i]);
            if (!mesh) return mesh.error();
            std::vector<float> through = leafParts(*mesh);
            for (float& part : through) part *= forest->species[i].translucency;
            meshOf[i] = addMesh(out, std::move(*mesh), forest->species[i].file, std::move(through));
        }
        for (const StandingTree& t : standingForest(*forest, ground).trees) {
            const glm::dvec3 from = t.at - ground.origin;
            glm::dmat3 turn = turnOf(t);
            if (sway.blows()) turn = sway.at(*forest, {from.x, from.z}) * turn;
            out.instances.placed.push_back({meshOf[t.species], glm::vec3(t.at - origin), glm::mat3(turn)});
            out.casts.push_back(forest->castShadows);
        }
    }
    return {};
}

}  // namespace

TerrainSurface terrainSurface(const Terrain& t) {
    TerrainSurface s;
    s.size = t.size;
    if (t.height.present()) {
        const glm::dvec2 repeats = t.size / tilingOf(t, t.heightTiling).metres;  // a quad a texel, as far as that goes
        const auto quads = [](double texels) {
            return static_cast<int>(std::clamp(std::ceil(texels), 1.0, static_cast<double>(kMaxQuads)));
        };
        s.quadsX = quads(t.height.map.info().width * repeats.x);
        s.quadsZ = quads(t.height.map.info().height * repeats.y);
    }
    s.heights.resize(static_cast<size_t>(s.quadsX + 1) * static_cast<size_t>(s.quadsZ + 1));
    parallelFor(static_cast<size_t>(s.quadsZ + 1), [&](size_t z) {
        for (int x = 0; x <= s.quadsX; ++x)
            s.heights[vertexAt(s, x, static_cast<int>(z))] = static_cast<float>(
                terrainHeight(t, t.size.x * x / s.quadsX, t.size.y * static_cast<double>(z) / s.quadsZ));
    });
    return s;
}

// A square's diagonal runs from (1, 0) to (0, 1).
glm::vec3 TerrainSurface::at(double x, double z) const {
    x = std::clamp(x, 0.0, size.x), z = std::clamp(z, 0.0, size.y);
    const double u = x / size.x * quadsX, v = z / size.y * quadsZ;
    const int i = std::min(static_cast<int>(u), quadsX - 1), j = std::min(static_cast<int>(v), quadsZ - 1);
    const double a = u - i, b = v - j;
    const double h10 = heights[vertexAt(*this, i + 1, j)], h01 = heights[vertexAt(*this, i, j + 1)];
    const double h00 = heights[vertexAt(*this, i, j)], h11 = heights[vertexAt(*this, i + 1, j + 1)];
    const double h =
        a + b <= 1 ? h00 + (h10 - h00) * a + (h01 - h00) * b : h11 + (h01 - h11) * (1 - a) + (h10 - h11) * (1 - b);
    return {static_cast<float>(x), static_cast<float>(h), static_cast<float>(z)};
}

glm::vec3 TerrainSurface::normalAt(double x, double z) const {
    const double dx = size.x / quadsX, dz = size.y / quadsZ;
    const glm::vec3 e = at(x + dx, z), w = at(x - dx, z), s = at(x, z + dz), n = at(x, z - dz);
    return glm::normalize(
        glm::vec3(-(e.y - w.y) / std::max(e.x - w.x, 1e-6f), 1, -(s.y - n.y) / std::max(s.z - n.z, 1e-6f)));
}

Triangles TerrainSurface::triangles() const {
    Triangles t;
    for (int z = 0; z <= quadsZ; ++z)
        for (int x = 0; x <= quadsX; ++x)
            t.positions.push_back({static_cast<float>(size.x * x / quadsX), heights[vertexAt(*this, x, z)],
                                   static_cast<float>(size.y * z / quadsZ)});
    for (int z = 0; z < quadsZ; ++z)
        for (int x = 0; x < quadsX; ++x) {
            const auto v = [&](int i, int j) { return static_cast<uint32_t>(vertexAt(*this, x + i, z + j)); };
            t.indices.insert(t.indices.end(), {v(0, 0), v(0, 1), v(1, 0), v(1, 1), v(1, 0), v(0, 1)});
        }
    return t;
}

Result<ScatteredTriangles> scatteredTriangles(const Project& p, const glm::dvec3& origin, bool castersAlone,
                                              std::optional<double> time) {
    ScatteredTriangles out;
    const Ground ground = findGround(p);
    for (const auto& [entity, scatter] : scattersOf(p)) {
        if (castersAlone && !scatter->castShadows) continue;
        std::vector<uint32_t> meshOf(scatter->meshes.size());
        for (size_t i = 0; i < scatter->meshes.size(); ++i) {
            if (!isScattered(scatter->meshes[i])) continue;
            Result<Mesh> mesh = readMesh(p.dir, scatter->meshes[i].file);
            if (!mesh) return mesh.error();
            meshOf[i] = addMesh(out, std::move(*mesh), scatter->meshes[i].file);
        }
        for (const ScatteredObject& o : scatterIn(p, *scatter, ground).objects) {
            out.instances.placed.push_back({meshOf[o.mesh], glm::vec3(o.at - origin), o.turn * o.scale});
            out.casts.push_back(scatter->castShadows);
        }
    }
    out.firstTree = out.instances.placed.size();
    if (Status s = addForests(out, p, ground, origin, castersAlone, time); !s) return s.error();
    return out;
}

Result<SceneTriangles> sceneTriangles(const Project& p, const JobControl& control, SolidsTaken taken) {
    const Ground ground = findGround(p);
    SceneTriangles out;
    if (ground.terrain && ground.terrain->height.present())
        out.meshes.push_back(terrainSurface(*ground.terrain).triangles());
    std::map<std::string, Mesh> read;
    for (const PlacedMesh& placed : placedMeshes(p)) {
        if (control.cancelled()) return failed("cancelled");
        if (!isTaken(p, placed, taken)) continue;
        const std::string& file = placed.mesh->file;
        if (!read.contains(file)) {
            Result<Mesh> mesh = readMesh(p.dir, file);
            if (!mesh) return mesh.error();
            read[file] = std::move(*mesh);
        }
        out.meshes.push_back(placedTriangles(read[file], placed, ground.origin));
    }
    auto scattered = scatteredTriangles(p, ground.origin, true);
    if (!scattered) return scattered.error();
    out.scattered = std::move(scattered->instances);
    return out;
}

uint64_t sceneTrianglesHash(const Project& p, SolidsTaken taken) {
    Hasher h;
    const auto add = [&](const auto& v) { h.add(&v, sizeof(v)); };
    const auto addFile = [&](const std::string& name) {
        std::error_code fault;
        const auto file = currentFile(p.dir, name);
        const auto time = file ? std::filesystem::last_write_time(*file, fault) : std::filesystem::file_time_type{};
        add(time.time_since_epoch().count());
        h.add(name.data(), name.size());
    };
    const Ground ground = findGround(p);
    if (ground.terrain) {
        add(ground.terrain->size), add(ground.terrain->heightRange), add(ground.origin),
            add(ground.terrain->heightTiling), add(ground.terrain->mapSize);
        if (ground.terrain->height.present()) add(ground.terrain->height.map.hash());
    }
    for (const PlacedMesh& placed : placedMeshes(p)) {
        if (!isTaken(p, placed, taken)) continue;
        add(placed.at), add(placed.turn), add(placed.mesh->scale);
        addFile(placed.mesh->file);
    }
    for (const auto& [entity, scatter] : scattersOf(p)) {
        if (!scatter->castShadows) continue;
        add(scatterIn(p, *scatter, ground).hash);
        for (const ScatterMesh& m : scatter->meshes) addFile(m.file);
    }
    for (const auto& [entity, forest] : forestsOf(p)) {
        if (!forest->castShadows) continue;
        add(standingForest(*forest, ground).hash);
        for (const TreeSpecies& s : forest->species) {
            add(s.kind), add(s.height), add(s.crown), add(s.leaves), add(s.seed);
            if (!s.file.empty()) addFile(s.file);
        }
    }
    return h.value();
}

}  // namespace sward
