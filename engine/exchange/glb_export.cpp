#include "exchange/glb_export.h"

#include <tiny_gltf.h>

#include <glm/gtc/quaternion.hpp>

#include "core/file.h"
#include "core/numerics.h"
#include "exchange/glb_check.h"
#include "exchange/glb_ground.h"
#include "exchange/glb_growth.h"
#include "frame/flower_image.h"
#include "mesh/glb_parts.h"
#include "mesh/mesh_io.h"
#include "sky/daylight.h"
#include "world/forest_stand.h"
#include "world/lights.h"
#include "world/placement.h"
#include "world/scatter.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kLampLux = 45'000;  // of intensity 1 (scene/components.h, Light)

void turnNode(tinygltf::Node& node, const glm::dmat3& turn) {
    const glm::dquat q = glm::normalize(glm::quat_cast(turn));
    node.rotation = {q.x, q.y, q.z, q.w};
}
// Axes of what looks along `way`, as cameras and lights do in glTF: along their -z.
glm::dmat3 looking(const glm::dvec3& way) {
    const glm::dvec3 back = -glm::normalize(way),
                     up = std::abs(back.y) > 0.9999 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    return {right, glm::cross(back, right), back};
}

// --- objects -----------------------------------------------------------------------------------------------------
Status addObjects(tinygltf::Model& m, const Project& p, GlbCounts& counts) {
    std::map<std::string, int> meshes;  // by file
    for (const PlacedMesh& placed : placedMeshes(p)) {
        const std::string& file = placed.mesh->file;
        if (!meshes.contains(file)) {
            const Result<Mesh> mesh = readMesh(p.dir, file);
            if (!mesh) return mesh.error();
            const Result<int> number = addObject(m, *mesh, true);
            if (!number) return number.error();
            meshes[file] = *number;
            m.meshes.back().name = file;
        }
        tinygltf::Node& node = m.nodes[static_cast<size_t>(addNode(m, entityOf(p, *placed.mesh), placed.at))];
        node.mesh = meshes[file];
        turnNode(node, placed.turn);
        node.scale.assign(3, static_cast<double>(placed.mesh->scale));
        ++counts.objects;
    }
    return {};
}

// --- lights and cameras ------------------------------------------------------------------------------------------
float brightest(const glm::vec3& c) { return std::max({c.x, c.y, c.z}); }

// Newer versions of the library hold a node's light in a member, and write no other.
template <class Node>
void lightNode(Node& node, int light) {
    node.extensions["KHR_lights_punctual"] =
        tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(light)}});
    if constexpr (requires { node.light = light; }) node.light = light;
}

// Colour at most 1, and its factor: lux of a directional light, candela of a point light.
void addLight(tinygltf::Model& m, const std::string& name, const Light& light, const glm::dvec3& centre,
              const glm::vec3& strength, GlbCounts& counts) {
    const bool isPoint = light.type == LightType::Point;
    tinygltf::Light l;
    l.name = name;
    l.type = isPoint ? "point" : "directional";
    const glm::vec3 color = strength / brightest(strength);
    l.color = {color.x, color.y, color.z};
    l.intensity = static_cast<double>(brightest(strength));
    m.lights.push_back(l);
    const glm::dvec3 at = isPoint ? placeOf(light, centre, 0) : glm::dvec3(0);
    tinygltf::Node& node = m.nodes[static_cast<size_t>(addNode(m, name, at))];
    if (!isPoint) turnNode(node, looking(-glm::dvec3(directionTo(light, 0))));
    lightNode(node, static_cast<int>(m.lights.size()) - 1);
    ++counts.lights;
}

// The sun's is what the sky leaves of it. A point light of ours is intensity / (1 + beta d2), and far away falls with
// the square of the distance as theirs does: candela are intensity / beta.
glm::vec3 strengthOf(const Project& p, const Light& light, bool isSun) {
    if (isSun) {
        return sunKlx(p, directionTo(light, 0)) * 1000.0f * light.color * light.intensity;
    }
    const float lux = light.intensity * static_cast<float>(kLampLux);
    const float share = light.type == LightType::Point ? 1 / std::max(light.attenuation, 1e-3f) : 1;
    return light.color * (lux * share);
}

void addLights(tinygltf::Model& m, const Project& p, GlbCounts& counts) {
    const Entity sun = sunEntity(p.registry);
    for (const auto& [name, e] : p.entities) {
        const Light* light = p.registry.get<Light>(e);
        if (!light || !shines(*light)) continue;
        const glm::vec3 strength = strengthOf(p, *light, e == sun);
        if (!(brightest(strength) > 0)) continue;  // below the horizon
        const Transform* at = p.registry.get<Transform>(e);
        addLight(m, name, *light, at ? at->position : glm::dvec3(0), strength, counts);
    }
}

void addCameras(tinygltf::Model& m, const Project& p, GlbCounts& counts) {
    for (const auto& [name, e] : p.entities) {
        const Camera* c = p.registry.get<Camera>(e);
        if (!c) continue;
        tinygltf::Camera camera;
        camera.name = name;
        camera.type = "perspective";
        camera.perspective.yfov = glm::radians(static_cast<double>(c->fovDeg));
        camera.perspective.znear = 0.05;
        camera.perspective.zfar = 1e5;
        m.cameras.push_back(camera);
        tinygltf::Node& node = m.nodes[static_cast<size_t>(addNode(m, name, c->eye))];
        node.camera = static_cast<int>(m.cameras.size()) - 1;
        if (c->eye != c->target) turnNode(node, looking(c->target - c->eye));
        ++counts.cameras;
    }
}

// --- what grows --------------------------------------------------------------------------------------------------
Result<StandingWithin> withinOf(const Project& p, const GlbOptions& o, const Ground& ground) {
    const Camera* camera = findCamera(p, o.camera);
    if (!camera && !o.camera.empty())
        return usage("there is no camera \"" + o.camera + "\"", "name one of the project's");
    if (!o.bladesWithin) return StandingWithin{};
    if (!(*o.bladesWithin >= 0) || !std::isfinite(*o.bladesWithin))
        return usage(fmt::format("{} is no distance for blades", *o.bladesWithin), "give metres, 0 or more");
    if (!camera) return usage("there is no camera to measure the distance of blades from", "add a Camera");
    return StandingWithin{glm::dvec2(camera->eye.x - ground.origin.x, camera->eye.z - ground.origin.z),
                          *o.bladesWithin};
}

Error tooMany(const Project& p, const GlbOptions& o) {
    if (o.bladesWithin)
        return failed(fmt::format("more than {} blades and flowers stand within {} m of the camera", o.mostBlades,
                                  *o.bladesWithin),
                      "give a shorter --blades-within");
    const Terrain& t = *findGround(p).terrain;
    const double perM2 = std::max(virtualBlades(p) / (t.size.x * t.size.y), 1e-9);
    const double metres = std::sqrt(static_cast<double>(o.mostBlades) / perM2 / 3.14159265358979);
    const double shown = metres < 10 ? std::floor(metres * 10) / 10 : std::floor(metres);
    return failed(fmt::format("the scene has about {:.3g} million blades; a .glb takes {:.3g} million",
                              virtualBlades(p) / 1e6, static_cast<double>(o.mostBlades) / 1e6),
                  fmt::format("write those near a camera alone: --blades-within {0}, or {0} at Blades Within in the "
                              "editor's dialog",
                              shown));
}

Status addGrowth(tinygltf::Model& m, const Project& p, const GlbOptions& o, const Ground& ground, JobControl& control,
                 GlbCounts& counts) {
    if (Status s = checkExport(p, o); !s) return s;
    const Result<StandingWithin> within = withinOf(p, o, ground);
    const auto blades = standingBlades(p, 0, *within, o.mostBlades, control);
    if (!blades) return blades.error();
    auto onMeshes = standingOnMeshes(p, 0, control);
    if (!onMeshes) return onMeshes.error();
    for (StandingOnMesh& s : *onMeshes)
        std::erase_if(s.blades, [&](const PosedOnMesh& b) {
            return !within->holds(
                {s.at.x + static_cast<double>(b.blade.root.x), s.at.z + static_cast<double>(b.blade.root.z)});
        });
    auto flowers = standingFlowers(p, 0, control);
    if (!flowers) return flowers.error();
    std::erase_if(*flowers, [&](const StandingFlower& f) { return !within->holds({f.root.x, f.root.z}); });
    size_t count = flowers->size();
    for (const StandingSpecies& s : *blades)
        for (const StandingCell& cell : s.cells) count += cell.blades.size();
    for (const StandingOnMesh& s : *onMeshes) count += s.blades.size();
    if (count > o.mostBlades) return tooMany(p, o);
    addBlades(m, p, *blades, ground.origin, counts);
    addBladesOnMeshes(m, p, *onMeshes, ground.origin, counts);
    addFlowers(m, p, *flowers, ground.origin, counts);
    return {};
}

// What was written is what was meant.
Status compareCounts(const Project& p, const std::string& bytes, const GlbCounts& meant) {
    GlbNames names;
    for (const auto& [name, f] : flowersOf(p)) names.flowers.insert(name);
    for (const auto& [name, s] : scattersOf(p)) names.scatters.insert(name);
    for (const auto& [name, f] : forestsOf(p)) names.scatters.insert(name);
    const Result<GlbCounts> found = checkGlb(bytes, names);
    if (!found) return found.error();
    if (*found == meant) return {};
    return failed(
        fmt::format("the .glb is not what was meant: {} instead of {}", countsText(*found), countsText(meant)),
        "please report this");
}

}  // namespace

std::vector<std::pair<const char*, size_t>> namedCounts(const GlbCounts& c) {
    return {{"blades", c.blades}, {"flowers", c.flowers}, {"cells", c.cells},
            {"chunks", c.chunks}, {"objects", c.objects}, {"scattered", c.scattered},
            {"lights", c.lights}, {"cameras", c.cameras}, {"bytes", c.bytes}};
}

std::string countsText(const GlbCounts& c) {
    return fmt::format(
        "{} blades, {} flowers in {} cells, {} chunks of ground, {} objects, {} scattered, {} lights, {} cameras, {} "
        "bytes",
        c.blades, c.flowers, c.cells, c.chunks, c.objects, c.scattered, c.lights, c.cameras, c.bytes);
}

Status checkExport(const Project& p, const GlbOptions& o) {
    const Result<StandingWithin> within = withinOf(p, o, findGround(p));
    if (!within) return within.error();
    if (!o.bladesWithin && virtualBlades(p) > 1.5 * static_cast<double>(o.mostBlades)) return tooMany(p, o);
    return {};
}

Result<Glb> encodeScene(const Project& p, const GlbOptions& o, JobControl& control) {
    tinygltf::Model m;
    Glb out;
    const Ground ground = findGround(p);
    beginModel(m);
    m.scenes[0].name = p.name.empty() ? "scene" : p.name;  // tinygltf cannot read one without a name or nodes
    addGround(m, p, ground, out.counts);
    if (Status s = addObjects(m, p, out.counts); !s) return s.error();
    if (Status s = addScattered(m, p, ground, out.counts); !s) return s.error();
    addLights(m, p, out.counts);
    addCameras(m, p, out.counts);
    if (Status s = addGrowth(m, p, o, ground, control, out.counts); !s) return s.error();
    if (out.counts.lights > 0) m.extensionsUsed.push_back("KHR_lights_punctual");
    if (out.counts.cells + out.counts.scattered > 0) m.extensionsUsed.push_back("EXT_mesh_gpu_instancing");
    Result<std::string> bytes = glbBytes(m);
    if (!bytes) return bytes.error();
    m = {};
    out.bytes = std::move(*bytes);
    out.counts.bytes = out.bytes.size();
    if (control.cancelled()) return failed("cancelled");
    if (Status s = compareCounts(p, out.bytes, out.counts); !s) return s.error();
    return out;
}

Result<GlbCounts> exportScene(const Project& p, const GlbOptions& o, const std::filesystem::path& file,
                              JobControl& control) {
    if (file.extension() != ".glb") return usage("is no name of a .glb", "end it in .glb").at(file.string());
    if (std::error_code fault; std::filesystem::is_directory(file, fault))
        return usage("is a folder", "name a file in it").at(file.string());
    Result<Glb> glb = encodeScene(p, o, control);
    if (!glb) return glb.error();
    if (control.cancelled()) return failed("cancelled");
    if (Status s = writeFileAtomic(file, glb->bytes); !s) return s.error();
    return glb->counts;
}

}  // namespace sward
