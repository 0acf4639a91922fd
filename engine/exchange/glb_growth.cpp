#include "exchange/glb_growth.h"

#include <tiny_gltf.h>

#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "core/numerics.h"
#include "frame/flower_image.h"
#include "grass/grown.h"
#include "mesh/glb_parts.h"
#include "mesh/mesh_io.h"
#include "reference/surface.h"
#include "world/forest_stand.h"
#include "world/scatter.h"

namespace sward {
namespace {

constexpr float kThin = 1e-5f;  // least scale (m): what has none cannot be turned back

// A mesh of one material whose colours are the vertices'.
struct Colored {
    std::vector<glm::vec3> positions, normals, colors;
    std::vector<uint32_t> indices;

    uint32_t add(const glm::vec3& at, const glm::vec3& normal, const glm::vec3& color) {
        positions.push_back(at), normals.push_back(glm::normalize(normal));
        colors.push_back(glm::clamp(color, 0.0f, 1.0f));
        return static_cast<uint32_t>(positions.size()) - 1;
    }
};

int addColored(tinygltf::Model& m, const Colored& c, float roughness) {
    tinygltf::Material material;
    material.doubleSided = true;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = static_cast<double>(roughness);
    m.materials.push_back(material);
    tinygltf::Primitive p;
    p.mode = TINYGLTF_MODE_TRIANGLES;
    p.attributes = {{"POSITION", addFloats(m, c.positions, AccessorKind::VerticesWithBounds)},
                    {"NORMAL", addFloats(m, c.normals, AccessorKind::Vertices)},
                    {"COLOR_0", addFloats(m, c.colors, AccessorKind::Vertices)}};
    p.indices = addIndices(m, c.indices);
    p.material = static_cast<int>(m.materials.size()) - 1;
    tinygltf::Mesh mesh;
    mesh.primitives.push_back(p);
    m.meshes.push_back(mesh);
    return static_cast<int>(m.meshes.size()) - 1;
}

// What a blade's image has between two shares of its height.
struct ImageBand {
    float covered = 0;  // share of its width
    glm::vec3 tint{0};  // factor of the species' colour
};
ImageBand bandOf(const TexelGrid& image, float from, float to) {
    constexpr int kAcross = 32, kAlong = 4;
    glm::vec3 sum(0);
    int covered = 0;
    for (int j = 0; j < kAlong; ++j)
        for (int i = 0; i < kAcross; ++i) {
            const double v = static_cast<double>(glm::mix(from, to, (static_cast<float>(j) + 0.5f) / kAlong));
            const glm::vec4 texel = image.at((i + 0.5) / kAcross, v, false);
            if (texel.w < 0.5f) continue;
            ++covered;
            sum += glm::vec3(texel);
        }
    if (covered == 0) return {};
    return {static_cast<float>(covered) / (kAcross * kAlong), 2.0f * sum / static_cast<float>(covered)};
}

// A blade's own axes: z level, the way that it faces to which its tip reaches; y from there to the tip, aslant where
// the place leans the blade sideways; x across both, along its width. An instance's axes are at right angles and a
// blade's are not quite: its level width stays level there, and here is turned with the blade.
struct BladeAxes {
    glm::vec3 x, y, z;
    float rise, reach;  // of its tip along y and z
};
BladeAxes axesOf(const Posed& b) {
    BladeAxes a;
    const float along = glm::dot(glm::vec2(b.tip.x, b.tip.z), b.facing), way = along < 0 ? -1.0f : 1.0f;
    a.z = way * glm::vec3(b.facing.x, 0, b.facing.y);
    a.reach = way * along;
    const glm::vec3 up = b.tip - a.z * a.reach;
    a.rise = glm::length(up);
    a.y = a.rise > kThin ? up / a.rise : glm::vec3(0, 1, 0);
    a.x = glm::cross(a.y, a.z);
    return a;
}

// The mean curve of blades whose tips are at (1, 1): the control's share of the way out and up.
class MeanCurve {
  public:
    void add(const Posed& b) {
        const BladeAxes a = axesOf(b);
        out_ += glm::vec2(glm::dot(b.control, a.z), glm::dot(b.control, a.y));
        tips_ += glm::vec2(a.reach, a.rise);
    }
    glm::vec2 control() const {
        return glm::clamp(out_ / glm::max(tips_, glm::vec2(1e-12f)), glm::vec2(0), glm::vec2(2));
    }

  private:
    glm::vec2 out_{0}, tips_{0};
};

// Along z it bends, along x it is wide.
Colored bladeMesh(const Species& s, const TexelGrid& image, const glm::vec2& control) {
    Colored c;
    const int rows = std::max(s.segments, 1);
    for (int i = 0; i <= rows; ++i) {
        const float v = static_cast<float>(i) / static_cast<float>(rows), half = 0.5f / static_cast<float>(rows);
        const ImageBand band = bandOf(image, std::max(v - half, 0.0f), std::min(v + half, 1.0f));
        const glm::vec2 at = control * (2 * v * (1 - v)) + glm::vec2(v * v),
                        along = control * (1 - v) + (glm::vec2(1) - control) * v;
        const glm::vec3 normal(0, std::max(along.x, 1e-3f), -std::max(along.y, 1e-3f));
        const glm::vec3 color = f32::bladeGradient(s.rootColor, s.midColor, s.tipColor, v) * band.tint;
        const float width = 0.5f * std::max(band.covered, 0.02f);
        c.add({-width, at.y, at.x}, normal, color);
        c.add({width, at.y, at.x}, normal, color);
    }
    for (uint32_t i = 0; i < static_cast<uint32_t>(rows); ++i)
        for (const uint32_t k : {0, 1, 2, 2, 1, 3}) c.indices.push_back(2 * i + k);
    return c;
}

// Instances of one node, and what the extension calls them.
struct Instances {
    std::vector<glm::vec3> at, scale;
    std::vector<glm::vec4> turn;
    void add(const GlbInstance& i) { at.push_back(i.at), turn.push_back(i.turn), scale.push_back(i.scale); }
};
void addInstances(tinygltf::Model& m, const std::string& name, int mesh, const glm::dvec3& at, const Instances& all) {
    tinygltf::Value::Object attributes;
    attributes["TRANSLATION"] = tinygltf::Value(addFloats(m, all.at, AccessorKind::WithBounds));
    attributes["ROTATION"] = tinygltf::Value(addFloats(m, all.turn, AccessorKind::Plain));
    attributes["SCALE"] = tinygltf::Value(addFloats(m, all.scale, AccessorKind::Plain));
    tinygltf::Node& node = m.nodes[static_cast<size_t>(addNode(m, name, at))];
    node.mesh = mesh;
    node.extensions["EXT_mesh_gpu_instancing"] =
        tinygltf::Value(tinygltf::Value::Object{{"attributes", tinygltf::Value(attributes)}});
}

// Stem up y, 1 long; head across x and z, 1 wide, at its end.
Colored flowerMesh(const Flowers& f) {
    Colored c;
    constexpr float kHalf = 0.06f;
    for (const glm::vec3 side : {glm::vec3(kHalf, 0, 0), glm::vec3(0, 0, kHalf)}) {
        const glm::vec3 normal(side.z, 0, side.x);
        const uint32_t first = c.add(-side, normal, f.stemColor);
        c.add(side, normal, f.stemColor);
        c.add(glm::vec3(0, 1, 0) - side, normal, f.stemColor);
        c.add(glm::vec3(0, 1, 0) + side, normal, f.stemColor);
        for (const uint32_t k : {0, 1, 2, 2, 1, 3}) c.indices.push_back(first + k);
    }
    constexpr uint32_t kCorners = 12;
    const auto disc = [&](float radius, float y, const glm::vec3& color) {
        const uint32_t middle = c.add({0, y, 0}, {0, 1, 0}, color);
        for (uint32_t i = 0; i < kCorners; ++i) {
            const float a = static_cast<float>(i) * 6.2831853f / kCorners;
            c.add({radius * std::sin(a), y, radius * std::cos(a)}, {0, 1, 0}, color);
        }
        for (uint32_t i = 0; i < kCorners; ++i)
            for (const uint32_t k : {0u, 1 + i, 1 + (i + 1) % kCorners}) c.indices.push_back(middle + k);
    };
    disc(0.5f, 1, (f.color + f.secondColor) * 0.5f);
    disc(0.17f, 1.01f, f.centerColor);
    return c;
}

glm::vec4 quaternionOf(const glm::mat3& turn) {
    const glm::quat q = glm::normalize(glm::quat_cast(turn));
    return {q.x, q.y, q.z, q.w};
}

GlbInstance flowerInstance(const StandingFlower& f, const glm::dvec3& corner) {
    const float length = glm::length(f.stem);
    const glm::vec3 up = f.stem / std::max(length, 1e-6f);
    const glm::vec3 across = glm::normalize(glm::cross(glm::vec3(f.facing.y, 0, -f.facing.x), up));
    GlbInstance i;
    i.at = glm::vec3(glm::dvec3(f.root) - corner);
    i.turn = quaternionOf(glm::mat3(glm::cross(up, across), up, across));
    i.scale = glm::max(glm::vec3(2 * f.half, length, 2 * f.half), glm::vec3(kThin));
    return i;
}

}  // namespace

GlbInstance instanceOf(const Posed& b, const glm::mat3& axes) {
    const BladeAxes own = axesOf(b);
    GlbInstance i;
    i.at = b.root;
    i.turn = quaternionOf(axes * glm::mat3(own.x, own.y, own.z));
    i.scale = glm::max(glm::vec3(b.width * own.y.y, own.rise, own.reach), glm::vec3(kThin));
    return i;
}

void addBlades(tinygltf::Model& m, const Project& p, std::span<const StandingSpecies> all, const glm::dvec3& origin,
               GlbCounts& counts) {
    for (const StandingSpecies& s : all) {
        if (s.cells.empty()) continue;
        MeanCurve curve;
        for (const StandingCell& cell : s.cells)
            for (const Posed& b : cell.blades) curve.add(b);
        const TexelGrid image = texelGridOf(bladeImage(p, *s.species));
        const int mesh = addColored(m, bladeMesh(*s.species, image, curve.control()), s.species->roughness);
        m.meshes.back().name = s.field + "." + s.species->name;
        for (const StandingCell& cell : s.cells) {
            Instances instances;
            for (const Posed& b : cell.blades) instances.add(instanceOf(b));
            addInstances(m, s.field + "." + s.species->name, mesh, origin + cell.corner, instances);
            ++counts.cells;
            counts.blades += cell.blades.size();
        }
    }
}

void addBladesOnMeshes(tinygltf::Model& m, const Project& p, std::span<const StandingOnMesh> all,
                       const glm::dvec3& origin, GlbCounts& counts) {
    for (const StandingOnMesh& s : all) {
        if (s.blades.empty()) continue;
        MeanCurve curve;
        Instances instances;
        for (const PosedOnMesh& b : s.blades) curve.add(b.blade), instances.add(instanceOf(b.blade, b.axes));
        const TexelGrid image = texelGridOf(bladeImage(p, *s.species));
        const int mesh = addColored(m, bladeMesh(*s.species, image, curve.control()), s.species->roughness);
        m.meshes.back().name = s.entity + "." + s.species->name;
        addInstances(m, m.meshes.back().name, mesh, origin + s.at, instances);
        ++counts.cells;
        counts.blades += s.blades.size();
    }
}

namespace {

// A node for each mesh that has instances; meshOf(i) reads the i-th.
template <class F>
Status addInstanced(tinygltf::Model& m, const std::string& entity, const glm::dvec3& origin,
                    std::vector<Instances>& byMesh, const F& meshOf) {
    for (size_t i = 0; i < byMesh.size(); ++i) {
        if (byMesh[i].at.empty()) continue;
        const auto& [mesh, name] = meshOf(i);
        if (!mesh) return mesh.error();
        const Result<int> number = addObject(m, *mesh, true);
        if (!number) return number.error();
        m.meshes.back().name = name;
        addInstances(m, entity, *number, origin, byMesh[i]);
    }
    return {};
}

}  // namespace

Status addScattered(tinygltf::Model& m, const Project& p, const Ground& ground, GlbCounts& counts) {
    for (const auto& [entity, rule] : scattersOf(p)) {
        const Scatter& scatter = *rule;
        std::vector<Instances> byMesh(scatter.meshes.size());
        const Scattering all = scatterIn(p, scatter, ground);
        for (const ScatteredObject& o : all.objects)
            byMesh[o.mesh].add({glm::vec3(o.at - ground.origin), quaternionOf(o.turn), glm::vec3(o.scale)});
        const auto meshOf = [&](size_t i) {
            return std::pair(readMesh(p.dir, scatter.meshes[i].file), scatter.meshes[i].file);
        };
        if (Status s = addInstanced(m, entity, ground.origin, byMesh, meshOf); !s) return s;
        counts.scattered += all.objects.size();
    }
    for (const auto& [entity, rule] : forestsOf(p)) {
        const Forest& forest = *rule;
        std::vector<Instances> byMesh(forest.species.size());
        const StandingForest all = standingForest(forest, ground);
        for (StandingTree t : all.trees) {
            const glm::vec3 scale(t.size, t.size * std::exchange(t.upright, 1.0f), t.size);
            byMesh[t.species].add(
                {glm::vec3(t.at - ground.origin), quaternionOf(glm::mat3(turnOf(t)) / t.size), scale});
        }
        const auto meshOf = [&](size_t i) {
            return std::pair(treeMesh(p.dir, forest.species[i]), forest.species[i].name);
        };
        if (Status s = addInstanced(m, entity, ground.origin, byMesh, meshOf); !s) return s;
        counts.scattered += all.trees.size();
    }
    return {};
}

void addFlowers(tinygltf::Model& m, const Project& p, std::span<const StandingFlower> flowers, const glm::dvec3& origin,
                GlbCounts& counts) {
    const auto kinds = flowersOf(p);
    int mesh = -1;
    for (size_t i = 0, end = 0; i < flowers.size(); i = end) {
        const uint32_t kind = flowers[i].kind;
        const auto& [name, shown] = kinds[kind];
        const double side = flowerGrid(*shown).side;
        const auto cellOf = [&](const StandingFlower& f) {
            return glm::dvec2(glm::floor(f.root.x / side), glm::floor(f.root.z / side));
        };
        if (i == 0 || flowers[i - 1].kind != kind) {
            mesh = addColored(m, flowerMesh(*shown), 0.8f);
            m.meshes.back().name = name;
        }
        const glm::dvec2 cell = cellOf(flowers[i]);
        const glm::dvec3 corner(cell.x * side, static_cast<double>(flowers[i].root.y), cell.y * side);
        Instances instances;
        for (; end < flowers.size() && flowers[end].kind == kind && cellOf(flowers[end]) == cell; ++end)
            instances.add(flowerInstance(flowers[end], corner));
        addInstances(m, name, mesh, origin + corner, instances);
        ++counts.cells;
        counts.flowers += instances.at.size();
    }
}

}  // namespace sward
