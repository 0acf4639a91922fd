#include "exchange/glb_ground.h"

#include <tiny_gltf.h>

#include "core/numerics.h"
#include "mesh/glb_parts.h"
#include "reference/surface.h"
#include "scene/tiling.h"

namespace sward {
namespace {

// The soil's mean reflectance.
glm::vec3 soilOf(const Project& p, const Terrain& t) {
    if (t.groundTexture.empty()) return t.groundColor;
    const TexelGrid image = texelGridOf(loadColorImage(p.dir / t.groundTexture));
    if (image.texels.empty()) return t.groundColor;
    glm::dvec3 sum(0);
    for (const glm::vec4& texel : image.texels) sum += glm::dvec3(texel);
    return glm::vec3(sum / static_cast<double>(image.texels.size())) * 2.0f * t.groundColor;
}

glm::vec3 colorAt(const Terrain& t, const glm::vec3& soil, const glm::dvec2& at) {
    if (!t.terrainMap.present()) return soil;
    const Tiling tiling = tilingOf(t, t.terrainMapTiling);
    const glm::dvec2 place = at / tiling.metres;
    const glm::vec4 paint = paintedAt(
        t.terrainMap.map, tiling.repeats ? place : glm::clamp(place, glm::dvec2(1e-9), glm::dvec2(1 - 1e-9)), 1, true);
    return f32::soilColor(soil, t.groundColor, glm::vec3(paint), paint.w);
}

struct Chunk {
    std::vector<glm::vec3> positions, normals, colors;
    std::vector<uint32_t> indices;
};

// Quads [from, to[ of all, relative to the corner at `from`.
Chunk chunkOf(const Terrain& t, const glm::vec3& soil, const glm::ivec2& quads, const glm::ivec2& from,
              const glm::ivec2& to) {
    Chunk c;
    const auto placeOf = [&](int x, int z) { return t.size * glm::dvec2(x, z) / glm::dvec2(quads); };
    const glm::dvec2 corner = placeOf(from.x, from.y);
    for (int z = from.y; z <= to.y; ++z)
        for (int x = from.x; x <= to.x; ++x) {
            const glm::dvec2 at = placeOf(x, z), in = at - corner;
            c.positions.push_back(glm::vec3(glm::dvec3(in.x, terrainHeight(t, at.x, at.y), in.y)));
            c.normals.push_back(glm::vec3(terrainNormal(t, at.x, at.y)));
            c.colors.push_back(glm::clamp(colorAt(t, soil, at), 0.0f, 1.0f));
        }
    const uint32_t across = static_cast<uint32_t>(to.x - from.x) + 1;
    for (uint32_t z = 0; z < static_cast<uint32_t>(to.y - from.y); ++z)
        for (uint32_t x = 0; x + 1 < across; ++x) {
            const uint32_t i = z * across + x;
            c.indices.insert(c.indices.end(), {i, i + across, i + 1, i + across + 1, i + 1, i + across});
        }
    return c;
}

void addChunk(tinygltf::Model& m, const Chunk& c, const std::string& name, const glm::dvec3& at) {
    tinygltf::Primitive p;
    p.mode = TINYGLTF_MODE_TRIANGLES;
    p.attributes = {{"POSITION", addFloats(m, c.positions, AccessorKind::VerticesWithBounds)},
                    {"NORMAL", addFloats(m, c.normals, AccessorKind::Vertices)},
                    {"COLOR_0", addFloats(m, c.colors, AccessorKind::Vertices)}};
    p.indices = addIndices(m, c.indices);
    p.material = 0;
    tinygltf::Mesh mesh;
    mesh.name = name;
    mesh.primitives.push_back(p);
    m.meshes.push_back(mesh);
    m.nodes[static_cast<size_t>(addNode(m, name, at))].mesh = static_cast<int>(m.meshes.size()) - 1;
}

}  // namespace

glm::ivec2 groundQuads(const Terrain& t) {
    glm::ivec2 quads(1);
    const auto texels = [&](const MapField& f, float tiling) {
        if (!f.present()) return;
        const MapInfo& info = f.map.info();
        const glm::dvec2 n = glm::ceil(glm::dvec2(info.width, info.height) * t.size / tilingOf(t, tiling).metres);
        quads = glm::max(quads, glm::ivec2(glm::min(n, glm::dvec2(kGroundQuads))));
    };
    texels(t.height, t.heightTiling);
    texels(t.terrainMap, t.terrainMapTiling);
    return quads;
}

void addGround(tinygltf::Model& m, const Project& p, const Ground& ground, GlbCounts& counts) {
    if (!ground.terrain) return;
    const Terrain& t = *ground.terrain;
    CHECK(m.materials.empty());  // its material is the first
    tinygltf::Material material;
    material.pbrMetallicRoughness.metallicFactor = 0;
    m.materials.push_back(material);
    const glm::vec3 soil = soilOf(p, t);
    const glm::ivec2 quads = groundQuads(t), chunks = (quads + kChunkQuads - 1) / kChunkQuads;
    std::vector<Chunk> made(static_cast<size_t>(chunks.x) * static_cast<size_t>(chunks.y));
    const auto from = [&](size_t i) {
        return glm::ivec2(static_cast<int>(i) % chunks.x, static_cast<int>(i) / chunks.x) * kChunkQuads;
    };
    parallelFor(made.size(),
                [&](size_t i) { made[i] = chunkOf(t, soil, quads, from(i), glm::min(from(i) + kChunkQuads, quads)); });
    for (size_t i = 0; i < made.size(); ++i) {
        const glm::dvec2 corner = t.size * glm::dvec2(from(i)) / glm::dvec2(quads);
        const glm::ivec2 number = from(i) / kChunkQuads;
        addChunk(m, made[i], fmt::format("{}/{},{}", entityOf(p, t), number.x, number.y),
                 ground.origin + glm::dvec3(corner.x, 0, corner.y));
        made[i] = {};
    }
    counts.chunks = made.size();
}

}  // namespace sward
