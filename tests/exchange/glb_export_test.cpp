// A scene in a .glb, read back by tinygltf and held against the scene itself.
#include "exchange/glb_export.h"

#include <tiny_gltf.h>

#include <cstring>
#include <glm/gtc/quaternion.hpp>

#include "exchange/glb_check.h"
#include "exchange/glb_growth.h"
#include "grass/cells.h"
#include "objects.h"
#include "reference/standing.h"
#include "scene/scatter.h"
#include "world/forest_stand.h"
#include "world/lights.h"
#include "world/placement.h"
#include "world/scatter.h"

namespace sward::test {
namespace {

using tinygltf::Model;

// 6 x 4 m of hilly ground with two species, one of them painted; flowers, a cube, a lamp, a camera.
Project meadow(const std::filesystem::path& dir) {
    Project p = lawn();
    p.dir = dir;
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    t.size = {6, 4};
    Map heights({24, 16, 1, PixelType::F32});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 24; ++x) heights.set(x, y, 0, 0.3f * std::sin(static_cast<float>(x) * 0.4f));
    t.height = field(heights, "maps/h.exr");
    put<Transform>(p, "ground", {{100, 2, -50}});
    GrassField& f = *p.registry.get<GrassField>(findEntity(p, "grass"));
    f.species.push_back(f.species[0]);
    f.species[1].name = "painted";
    f.species[1].bladesPerM2 = 300;
    Map density({12, 8, 1, PixelType::U16});
    for (int y = 0; y < 8; ++y)
        for (int x = 6; x < 12; ++x) density.set(x, y, 0, 0.6f);
    f.species[1].density = field(density);
    put<Flowers>(p, "daisies", {.flowersPerM2 = 5});
    putObject(p, "cube", {{.color = {0.2f, 0.3f, 0.4f}}}, {103, 0, -48});
    put<Light>(p, "lamp", {.type = LightType::Point, .attenuation = 2});
    put<Transform>(p, "lamp", {{101, 5, -49}});
    put<Camera>(p, "eye", {.eye = {101, 4, -49}, .target = {103, 2, -47}, .fovDeg = 40});
    return p;
}

Glb encoded(const Project& p, const GlbOptions& o = {}) {
    JobControl control;
    Result<Glb> glb = encodeScene(p, o, control);
    EXPECT_TRUE(glb) << (glb ? "" : glb.error().text());
    return glb ? std::move(*glb) : Glb{};
}
Model read(const std::string& bytes) {
    Model m;
    std::string error, warning;
    tinygltf::TinyGLTF reader;
    EXPECT_TRUE(reader.LoadBinaryFromMemory(&m, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                            static_cast<unsigned>(bytes.size())))
        << error;
    EXPECT_EQ(warning, "");
    return m;
}
const tinygltf::Node* node(const Model& m, const std::string& name) {
    for (const tinygltf::Node& n : m.nodes)
        if (n.name == name) return &n;
    ADD_FAILURE() << "no node " << name;
    return nullptr;
}
glm::dvec3 placeOf(const tinygltf::Node& n) {
    return n.translation.empty() ? glm::dvec3(0) : glm::dvec3(n.translation[0], n.translation[1], n.translation[2]);
}
glm::dvec3 forwardOf(const tinygltf::Node& n) {
    return glm::dquat(n.rotation[3], n.rotation[0], n.rotation[1], n.rotation[2]) * glm::dvec3(0, 0, -1);
}
template <class V>
std::vector<V> values(const Model& m, int accessor) {
    const tinygltf::Accessor& a = m.accessors[static_cast<size_t>(accessor)];
    const tinygltf::BufferView& view = m.bufferViews[static_cast<size_t>(a.bufferView)];
    std::vector<V> out(a.count);
    std::memcpy(out.data(), m.buffers[0].data.data() + view.byteOffset + a.byteOffset, a.count * sizeof(V));
    return out;
}
const tinygltf::Value* attributesOf(const tinygltf::Node& n) {
    const auto found = n.extensions.find("EXT_mesh_gpu_instancing");
    return found == n.extensions.end() ? nullptr : &found->second.Get("attributes");
}

// Blades as the GPU's choice of cells counts them, each species by its own.
uint64_t countedBlades(const Project& p) {
    const Terrain& t = *findGround(p).terrain;
    const GrassField& f = *p.registry.get<GrassField>(findEntity(p, "grass"));
    HeightBounds bounds;
    updateHeightBounds(bounds, t);
    Frustum everywhere;
    everywhere.planes.fill(glm::vec4(0, 0, 0, 1));
    uint64_t n = 0;
    for (const Species& s : f.species) {
        const Patch patch = makePatch(s, f.cellSize, static_cast<uint32_t>(f.seed));
        const FadeRange always = fadeRange(1e8f, 2e8f);
        n += countVisible(cellQuery({t, bounds, f, s, patch, always, 0}, {{3, 1, 2}, everywhere, 200}));
    }
    return n;
}

TEST(GlbExport, CountsAreThoseOfTheScene) {
    const TempDir dir;
    const Project p = meadow(dir.path);
    const Glb glb = encoded(p);
    const Model m = read(glb.bytes);
    JobControl control;
    EXPECT_EQ(glb.counts.blades, countedBlades(p));
    EXPECT_NEAR(static_cast<double>(glb.counts.blades), 24 * 200 + 12 * 180, 200) << "density times area";
    EXPECT_EQ(glb.counts.flowers, standingFlowers(p, 0, control)->size());
    EXPECT_GT(glb.counts.flowers, 50u);
    EXPECT_EQ(glb.counts.objects, 1u);
    EXPECT_EQ(glb.counts.lights, 2u);
    EXPECT_EQ(glb.counts.cameras, 1u);
    EXPECT_EQ(glb.counts.bytes, glb.bytes.size());
    size_t instances = 0, nodes = 0;
    for (const tinygltf::Node& n : m.nodes)
        if (const tinygltf::Value* a = attributesOf(n)) {
            instances += m.accessors[static_cast<size_t>(a->Get("ROTATION").GetNumberAsInt())].count;
            ++nodes;
        }
    EXPECT_EQ(instances, glb.counts.blades + glb.counts.flowers);
    EXPECT_EQ(nodes, glb.counts.cells);
    EXPECT_EQ(m.extensionsUsed.size(), 2u);
}

// Root and tip of every instance, in the world.
TEST(GlbExport, BladesStandWhereTheSceneHasThem) {
    const TempDir dir;
    const Project p = meadow(dir.path);
    const Model m = read(encoded(p).bytes);
    JobControl control;
    const auto species = standingBlades(p, 0, {}, 1'000'000, control);
    ASSERT_TRUE(species);
    const glm::dvec3 origin = findGround(p).origin;
    size_t at = 0;
    for (const StandingSpecies& s : *species)
        for (const StandingCell& cell : s.cells) {
            while (at < m.nodes.size() && m.nodes[at].name != s.field + "." + s.species->name) ++at;
            ASSERT_LT(at, m.nodes.size());
            const tinygltf::Node& n = m.nodes[at++];
            const tinygltf::Value& a = *attributesOf(n);
            const auto roots = values<glm::vec3>(m, a.Get("TRANSLATION").GetNumberAsInt());
            const auto turns = values<glm::vec4>(m, a.Get("ROTATION").GetNumberAsInt());
            const auto scales = values<glm::vec3>(m, a.Get("SCALE").GetNumberAsInt());
            ASSERT_EQ(roots.size(), cell.blades.size());
            for (size_t i = 0; i < roots.size(); ++i) {
                const Posed& b = cell.blades[i];
                const glm::dvec3 root = placeOf(n) + glm::dvec3(roots[i]);
                ASSERT_LT(glm::distance(root, origin + cell.corner + glm::dvec3(b.root)), 1e-5);
                ASSERT_NEAR(root.y,
                            origin.y + terrainHeight(*findGround(p).terrain, root.x - origin.x, root.z - origin.z),
                            1e-5);
                const glm::quat turn(turns[i].w, turns[i].x, turns[i].y, turns[i].z);
                const glm::vec3 tip = turn * (scales[i] * glm::vec3(0, 1, 1));
                ASSERT_LT(glm::distance(tip, b.tip), 0.03f * glm::length(b.tip));
                ASSERT_NEAR(scales[i].x, b.width * (turn * glm::vec3(0, 1, 0)).y, 1e-6f) << "as wide at one height";
                const glm::vec3 side = turn * glm::vec3(1, 0, 0);
                ASSERT_NEAR(glm::dot(side, glm::vec3(b.facing.x, 0, b.facing.y)), 0, 1e-5f) << "it is wide across";
            }
        }
}

TEST(GlbExport, TheGroundIsTheTerrain) {
    const TempDir dir;
    const Project p = meadow(dir.path);
    const Glb glb = encoded(p);
    const Model m = read(glb.bytes);
    EXPECT_EQ(glb.counts.chunks, 1u);
    const tinygltf::Node& n = *node(m, "ground/0,0");
    const tinygltf::Primitive& prim = m.meshes[static_cast<size_t>(n.mesh)].primitives[0];
    const auto at = values<glm::vec3>(m, prim.attributes.at("POSITION"));
    const auto normals = values<glm::vec3>(m, prim.attributes.at("NORMAL"));
    ASSERT_EQ(at.size(), 25u * 17);
    const Terrain& t = *findGround(p).terrain;
    for (size_t i = 0; i < at.size(); ++i) {
        EXPECT_NEAR(static_cast<double>(at[i].y),
                    terrainHeight(t, static_cast<double>(at[i].x), static_cast<double>(at[i].z)), 1e-5);
        EXPECT_NEAR(glm::length(normals[i]), 1, 1e-5f);
        EXPECT_GT(normals[i].y, 0.5f);
    }
    EXPECT_EQ(placeOf(n), glm::dvec3(100, 2, -50));
    const auto corners = values<uint32_t>(m, prim.indices);
    for (size_t i = 0; i < corners.size(); i += 3)
        EXPECT_GT(glm::cross(at[corners[i + 1]] - at[corners[i]], at[corners[i + 2]] - at[corners[i]]).y, 0)
            << "counter-clockwise from above";
}

TEST(GlbExport, LargeGroundComesInChunksThatMeet) {
    Project p;
    Terrain t;
    t.size = {300, 150};
    t.terrainMap = field(filled({300, 150, 4, PixelType::U8}, 0.5f));
    put(p, "ground", t);
    const Glb glb = encoded(p);
    EXPECT_EQ(glb.counts.chunks, 6u);
    const Model m = read(glb.bytes);
    EXPECT_EQ(placeOf(*node(m, "ground/1,0")), glm::dvec3(128, 0, 0));
    const auto& bounds = m.accessors[static_cast<size_t>(
        m.meshes[static_cast<size_t>(node(m, "ground/0,0")->mesh)].primitives[0].attributes.at("POSITION"))];
    EXPECT_EQ(bounds.maxValues, (std::vector<double>{128, 0, 128}));
}

TEST(GlbExport, ObjectsLightsAndCamerasStandAsTheyAre) {
    const TempDir dir;
    Project p = meadow(dir.path);
    p.registry.get<StaticMesh>(findEntity(p, "cube"))->scale = 2;
    const Model m = read(encoded(p).bytes);
    const PlacedMesh placed = placedMeshes(p)[0];
    EXPECT_LT(glm::distance(placeOf(*node(m, "cube")), placed.at), 1e-9);
    EXPECT_EQ(node(m, "cube")->scale, (std::vector<double>{2, 2, 2}));
    EXPECT_EQ(placeOf(*node(m, "lamp")), glm::dvec3(101, 5, -49));
    ASSERT_EQ(m.lights.size(), 2u);
    EXPECT_EQ(m.lights[0].type, "point");
    EXPECT_NEAR(m.lights[0].intensity, 22500, 1) << "45 klx / beta";
    EXPECT_EQ(m.lights[1].type, "directional");
    EXPECT_GT(m.lights[1].intensity, 50000);
    EXPECT_LT(m.lights[1].intensity, 133000) << "lux of a sun through air";
    const Light& sun = *p.registry.get<Light>(findEntity(p, "sun"));
    EXPECT_LT(glm::distance(forwardOf(*node(m, "sun")), -glm::dvec3(directionTo(sun, 0))), 1e-6);
    const tinygltf::Node& eye = *node(m, "eye");
    EXPECT_LT(glm::distance(forwardOf(eye), glm::normalize(glm::dvec3(2, -2, 2))), 1e-9);
    EXPECT_NEAR(m.cameras[static_cast<size_t>(eye.camera)].perspective.yfov, glm::radians(40.0), 1e-9);
}

TEST(GlbExport, ScatteredObjectsAreInstances) {
    const TempDir dir;
    Project p = meadow(dir.path);
    const Scatter rule{.meshes = {{"cube", "cube.glb"}}, .perHectare = 20000, .distance = 0.2f};
    put(p, "stones", rule);
    const Glb glb = encoded(p);
    const auto there = scatterIn(p, rule, findGround(p)).objects;
    EXPECT_EQ(glb.counts.scattered, there.size());
    const Model m = read(glb.bytes);
    const auto at = values<glm::vec3>(m, attributesOf(*node(m, "stones"))->Get("TRANSLATION").GetNumberAsInt());
    ASSERT_EQ(at.size(), there.size());
    EXPECT_LT(glm::distance(placeOf(*node(m, "stones")) + glm::dvec3(at[3]), there[3].at), 1e-5);
}

TEST(GlbExport, TreesOfAForestAreInstances) {
    const TempDir dir;
    Project p = meadow(dir.path);
    const TreeSpecies spruce{.height = 1, .leaves = 30},
        oak{.name = "oak", .kind = TreeKind::Broadleaf, .height = 1, .leaves = 30};
    const Forest rule{
        .species = {spruce, oak}, .perHectare = 15000, .distance = 0.4f, .tileSize = 4, .verticalScale = 1.5f};
    put(p, "trees", rule);
    const Glb glb = encoded(p);
    const auto there = standingForest(rule, findGround(p)).trees;
    ASSERT_GT(there.size(), 10u);
    EXPECT_EQ(glb.counts.scattered, there.size());
    const Model m = read(glb.bytes);
    const auto first = std::find_if(there.begin(), there.end(), [](const StandingTree& t) { return t.species == 0; });
    const auto at = values<glm::vec3>(m, attributesOf(*node(m, "trees"))->Get("TRANSLATION").GetNumberAsInt());
    EXPECT_LT(glm::distance(placeOf(*node(m, "trees")) + glm::dvec3(at[0]), first->at), 1e-5);
    const auto scale = values<glm::vec3>(m, attributesOf(*node(m, "trees"))->Get("SCALE").GetNumberAsInt());
    EXPECT_EQ(scale[0], glm::vec3(first->size, 1.5f * first->size, first->size));
}

TEST(GlbExport, AnEmptySceneAndOneWithoutGrassAreSound) {
    EXPECT_EQ(encoded(Project{}).counts.cells, 0u);
    Project bare = lawn();
    bare.registry.get<GrassField>(findEntity(bare, "grass"))->species.clear();
    const Glb glb = encoded(bare);
    EXPECT_EQ(glb.counts.blades, 0u);
    EXPECT_EQ(read(glb.bytes).extensionsUsed, (std::vector<std::string>{"KHR_lights_punctual"}));
}

TEST(GlbExport, BladesWithinADistanceOfTheCamera) {
    const TempDir dir;
    const Project p = meadow(dir.path);
    const Glb glb = encoded(p, {.bladesWithin = 1.0});
    EXPECT_NEAR(static_cast<double>(glb.counts.blades), 3.14 * 200, 60);
    const Model m = read(glb.bytes);
    for (const tinygltf::Node& n : m.nodes)
        if (const tinygltf::Value* a = attributesOf(n))
            for (const glm::vec3& root : values<glm::vec3>(m, a->Get("TRANSLATION").GetNumberAsInt())) {
                const glm::dvec3 at = placeOf(n) + glm::dvec3(root);
                EXPECT_LE(std::hypot(at.x - 101, at.z + 49), 1.0001);
            }
    EXPECT_EQ(encoded(p, {.bladesWithin = 0.0}).counts.blades, 0u);
}

TEST(GlbExport, TooManyBladesAreRefusedWithTheRemedy) {
    const TempDir dir;
    const Project p = meadow(dir.path);
    JobControl control;
    const auto refused = encodeScene(p, {.mostBlades = 1000}, control);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ExitCode::Failed);
    EXPECT_NE(refused.error().remedy.find("--blades-within"), std::string::npos) << refused.error().text();
    EXPECT_TRUE(encodeScene(p, {.bladesWithin = 0.5, .mostBlades = 1000}, control));
    EXPECT_FALSE(encodeScene(p, {.bladesWithin = 5, .mostBlades = 1000}, control));
}

TEST(GlbExport, WhatCannotBeIsRefusedAndNothingIsWritten) {
    const TempDir dir;
    const Project p = meadow(dir.path);
    JobControl control;
    const auto codeOf = [&](const GlbOptions& o, const std::filesystem::path& file) {
        const auto made = exportScene(p, o, file, control);
        EXPECT_FALSE(std::filesystem::is_regular_file(file)) << file;
        return made ? ExitCode::Done : made.error().code;
    };
    EXPECT_EQ(codeOf({}, dir / "scene.gltf"), ExitCode::Usage);
    EXPECT_EQ(codeOf({}, dir / "nowhere/scene.glb"), ExitCode::Failed);
    EXPECT_EQ(codeOf({.camera = "nobody"}, dir / "scene.glb"), ExitCode::Usage);
    EXPECT_EQ(codeOf({.bladesWithin = -1.0}, dir / "scene.glb"), ExitCode::Usage);
    std::filesystem::create_directory(dir / "folder.glb");
    EXPECT_EQ(codeOf({}, dir / "folder.glb"), ExitCode::Usage);
    Project without = meadow(dir.path);
    without.registry.get<StaticMesh>(findEntity(without, "cube"))->file = "gone.glb";
    EXPECT_EQ(exportScene(without, {}, dir / "scene.glb", control).error().code, ExitCode::Unsound);
    control.cancel();
    EXPECT_EQ(codeOf({}, dir / "scene.glb"), ExitCode::Failed);
    size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(dir.path)) files += entry.is_regular_file();
    EXPECT_EQ(files, 1u) << "cube.glb alone";
}

TEST(GlbExport, AFileThatIsThereIsReplacedAtOnce) {
    const TempDir dir;
    const Project p = meadow(dir.path);
    writeText(dir / "scene.glb", "old");
    JobControl control;
    const auto made = exportScene(p, {}, dir / "scene.glb", control);
    ASSERT_TRUE(made);
    EXPECT_EQ(readText(dir / "scene.glb"), encoded(p).bytes) << "the same scene gives the same bytes";
}

}  // namespace
}  // namespace sward::test
