// glTF files: what is read, what is refused and how it is said, and that no damage crashes the reader.
#include "mesh/mesh_io.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "core/json.h"
#include "mesh/gltf_head.h"
#include "mesh/mesh_shapes.h"
#include "project/project_files.h"
#include "scene/project.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {
using test::readText, test::TempDir, test::writeText;
namespace fs = std::filesystem;

template <class T>
void append(std::string& to, std::initializer_list<T> values) {
    for (const T v : values) to.append(reinterpret_cast<const char*>(&v), sizeof(T));
}

// A .gltf and its .bin, as a table of texts that tests change: one triangle (0,0,0), (1,0,0), (0,0,-1).
struct Parts {
    std::string bin;
    std::string nodes = R"([{"mesh": 0}])";
    std::string primitive = R"({"attributes": {"POSITION": 0}, "indices": 1})";
    std::string accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                                {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}])";
    std::string views = R"([{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}])";
    std::string buffers;
    std::string more, asset = R"({"version": "2.0"})";
    Parts() {
        append<float>(bin, {0, 0, 0, 1, 0, 0, 0, 0, -1});
        append<uint16_t>(bin, {0, 1, 2});
    }
    std::string text() const {
        const std::string uri =
            buffers.empty() ? fmt::format(R"([{{"byteLength": {}, "uri": "part.bin"}}])", bin.size()) : buffers;
        return fmt::format(
            R"({{"asset": {}, "scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": {}, "meshes": [{{"primitives": [{}]}}],
 "accessors": {}, "bufferViews": {}, "buffers": {}{}}})",
            asset, nodes, primitive, accessors, views, uri, more);
    }
    void write(const fs::path& dir) const {
        writeText(dir / "models/thing.gltf", text());
        writeText(dir / "models/part.bin", bin);
    }
};
Result<Mesh> readParts(const Parts& parts) {
    const TempDir dir;
    parts.write(dir.path);
    return readMesh(dir.path, "models/thing.gltf");
}
void expectSound(const Mesh& m) {
    EXPECT_FALSE(m.indices.empty());
    EXPECT_LE(m.indices.size() / 3, kMaxMeshTriangles);
    for (const uint32_t i : m.indices) ASSERT_LT(i, m.vertices.size());
    for (const MeshVertex& v : m.vertices) {
        ASSERT_TRUE(std::isfinite(v.position.x + v.position.y + v.position.z));
        ASSERT_NEAR(glm::length(v.normal), 1, 1e-3);
    }
    size_t sum = 0;
    for (const MeshPart& p : m.parts) sum += p.count;
    EXPECT_EQ(sum, m.indices.size());
}

TEST(MeshIo, ATriangleIsReadWithTheNormalOfItsFace) {
    const Result<Mesh> m = readParts({});
    ASSERT_TRUE(m) << m.error().text();
    ASSERT_EQ(m->vertices.size(), 3u);
    EXPECT_EQ(m->indices, (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(m->vertices[0].normal, glm::vec3(0, 1, 0)) << "counter-clockwise from above";
    EXPECT_EQ(m->low, glm::vec3(0, 0, -1));
    EXPECT_EQ(m->high, glm::vec3(1, 0, 0));
    EXPECT_EQ(m->files, (std::vector<std::string>{"models/thing.gltf", "models/part.bin"}));
}

TEST(MeshIo, IndicesOfEveryWidthAndNoneGiveTheSameTriangles) {
    const std::vector<MeshVertex> expected = readParts({})->vertices;
    for (const auto& [type, size] : {std::pair{5121, 1}, {5125, 4}, {0, 0}}) {
        Parts p;
        p.bin.resize(36);
        if (size == 1) append<uint8_t>(p.bin, {0, 1, 2});
        if (size == 4) append<uint32_t>(p.bin, {0, 1, 2});
        p.views =
            fmt::format(R"([{{"buffer": 0, "byteLength": 36}}, {{"buffer": 0, "byteOffset": {}, "byteLength": {}}}])",
                        size ? 36 : 0, size ? 3 * size : 36);
        p.accessors = fmt::format(R"([{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
                                      {{"bufferView": 1, "componentType": {}, "count": 3, "type": "SCALAR"}}])",
                                  size ? type : 5126);
        if (!size) p.primitive = R"({"attributes": {"POSITION": 0}})";
        const Result<Mesh> m = readParts(p);
        ASSERT_TRUE(m) << type << m.error().text();
        ASSERT_EQ(m->vertices.size(), 3u);
        for (size_t i = 0; i < 3; ++i) EXPECT_EQ(m->vertices[i].position, expected[i].position);
    }
}

TEST(MeshIo, NodesMoveTurnAndMirrorTheirMeshes) {
    Parts p;
    p.nodes = R"([{"children": [1], "translation": [0, 5, 0]},
                  {"mesh": 0, "rotation": [0, 0.70710678, 0, 0.70710678], "scale": [2, 2, 2], "translation": [1, 0, 0]}])";
    Result<Mesh> m = readParts(p);
    ASSERT_TRUE(m) << m.error().text();
    // (1, 0, 0) doubled, turned by a quarter about y to -z, moved.
    EXPECT_NEAR(glm::distance(m->vertices[1].position, glm::vec3(1, 5, -2)), 0, 1e-5);
    p.nodes = R"([{"mesh": 0, "matrix": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])";
    m = readParts(p);
    ASSERT_TRUE(m) << m.error().text();
    EXPECT_EQ(m->vertices[0].normal, glm::vec3(0, 1, 0)) << "a mirrored face is still seen from its outside";
}

TEST(MeshIo, StripsFansAndBaseColoursAreRead) {
    Parts p;
    p.bin.clear();
    append<float>(p.bin, {0, 0, 0, 1, 0, 0, 0, 0, -1, 1, 0, -1});
    p.views = R"([{"buffer": 0, "byteLength": 48}])";
    p.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}])";
    p.more =
        R"(, "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 1]}, "alphaMode": "MASK", "alphaCutoff": 0.25}])";
    for (const int mode : {5, 6}) {
        p.primitive = fmt::format(R"({{"attributes": {{"POSITION": 0}}, "mode": {}, "material": 0}})", mode);
        const Result<Mesh> m = readParts(p);
        ASSERT_TRUE(m) << m.error().text();
        EXPECT_EQ(m->indices.size(), 6u) << mode;
        if (mode == 5) {
            for (const MeshVertex& v : m->vertices)
                EXPECT_EQ(v.normal, glm::vec3(0, 1, 0)) << "every second triangle of a strip is turned";
        }
        EXPECT_EQ(m->parts[0].color, glm::vec3(0.1f, 0.2f, 0.3f));
        EXPECT_EQ(m->parts[0].cutoff, 0.25f);
    }
}

TEST(MeshIo, WhatIsWrittenReadsBackTheSame) {
    const Solid solids[] = {{},
                            {.kind = SolidKind::Ball, .at = {3, 0, 0}, .color = {0.1f, 0.2f, 0.3f}, .rough = 0.2f},
                            {.kind = SolidKind::Cylinder, .size = {1, 2, 0}, .at = {0, 0, 4}},
                            {.kind = SolidKind::Leaves, .count = 60}};
    const Mesh mesh = makeMesh(solids);
    const auto bytes = encodeGlb(mesh);
    ASSERT_TRUE(bytes);
    const TempDir dir;
    writeText(dir / "a.glb", *bytes);
    const Result<Mesh> back = readMesh(dir.path, "a.glb");
    ASSERT_TRUE(back) << back.error().text();
    expectSound(*back);
    ASSERT_EQ(back->parts.size(), mesh.parts.size());
    ASSERT_EQ(back->indices.size(), mesh.indices.size());
    EXPECT_EQ(back->vertices.size(), mesh.vertices.size())
        << "vertices that parts share the accessor of are not repeated";
    for (size_t i = 0; i < mesh.indices.size(); ++i)
        ASSERT_EQ(back->vertices[back->indices[i]].position, mesh.vertices[mesh.indices[i]].position);
    EXPECT_EQ(back->low, mesh.low);
    EXPECT_EQ(back->high, mesh.high);
}

struct Bad {
    const char* what;
    std::function<void(Parts&)> damage;
    const char* says;  // in the message
};
const std::string kPositions = R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"})";
const Bad kBad[] = {
    {"no JSON", [](Parts& p) { p.nodes = "["; }, "thing.gltf:"},
    {"no meshes", [](Parts& p) { p.nodes = "[{}]"; }, "no mesh with triangles"},
    {"points only", [](Parts& p) { p.primitive = R"({"attributes": {"POSITION": 0}, "mode": 0})"; },
     "no mesh with triangles"},
    {"no positions", [](Parts& p) { p.primitive = R"({"attributes": {}})"; }, "POSITION"},
    {"accessor out of range", [](Parts& p) { p.primitive = R"({"attributes": {"POSITION": 7}})"; }, "accessor 7"},
    {"index out of range", [](Parts& p) { p.bin[40] = 9; }, "index 9 is out of range"},
    {"more elements than bytes",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 4000000000, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}])";
     },
     "reach beyond"},
    {"view beyond the buffer",
     [](Parts& p) {
         p.views =
             R"([{"buffer": 0, "byteOffset": 30, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}])";
     },
     "beyond its buffer"},
    {"no such view",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 12, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}])";
     },
     "buffer view"},
    {"positions of another type",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC2"},
        {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}])";
     },
     "type"},
    {"NaN position",
     [](Parts& p) {
         const float nan = NAN;
         std::memcpy(&p.bin[4], &nan, 4);
     },
     "vertex 0 lies nowhere"},
    {"infinite position",
     [](Parts& p) {
         const float inf = INFINITY;
         std::memcpy(&p.bin[4], &inf, 4);
     },
     "vertex 0 lies nowhere"},
    {"node in a circle", [](Parts& p) { p.nodes = R"([{"mesh": 0, "children": [1]}, {"children": [0]}])"; }, "trees"},
    {"no such node", [](Parts& p) { p.nodes = R"([{"children": [5]}])"; }, "node 5"},
    {"no such mesh", [](Parts& p) { p.nodes = R"([{"mesh": 3}])"; }, "mesh 3"},
    {"no such material", [](Parts& p) { p.primitive = R"({"attributes": {"POSITION": 0}, "material": 4})"; },
     "material"},
    {"a buffer of 4 GB", [](Parts& p) { p.buffers = R"([{"byteLength": 4000000000, "uri": "part.bin"}])"; }, "limits"},
    {"a missing buffer", [](Parts& p) { p.buffers = R"([{"byteLength": 42, "uri": "other.bin"}])"; }, "other.bin"},
    {"a buffer outside the project", [](Parts& p) { p.buffers = R"([{"byteLength": 42, "uri": "../../other.bin"}])"; },
     "refers to ../other.bin"},
    {"compression", [](Parts& p) { p.more = R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])"; },
     "KHR_draco_mesh_compression"},
    {"a later version", [](Parts& p) { p.asset = R"({"version": "3.0"})"; }, "glTF version 3.0; only 2.x is read"},
    {"an earlier version", [](Parts& p) { p.asset = R"({"version": "1.0"})"; }, "glTF version 1.0"},
    {"no version", [](Parts& p) { p.asset = "{}"; }, "asset.version"},
    {"a reader of a later version", [](Parts& p) { p.asset = R"({"version": "2.1", "minVersion": "2.1"})"; },
     "asset.minVersion"},
    {"a negative offset of a view",
     [](Parts& p) {
         p.views = R"([{"buffer": 0, "byteOffset": -4, "byteLength": 36},
        {"buffer": 0, "byteOffset": 36, "byteLength": 6}])";
     },
     "bufferViews[0].byteOffset is -4"},
    {"a negative length",
     [](Parts& p) {
         p.views = R"([{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": -6}])";
     },
     "bufferViews[1].byteLength is -6"},
    {"a negative offset of an accessor",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 0, "byteOffset": -1, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}])";
     },
     "accessors[0].byteOffset is -1"},
    {"a count that is no whole number",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 2.5, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}])";
     },
     "accessors[0].count is 2.5"},
    {"a buffer shorter than nothing", [](Parts& p) { p.buffers = R"([{"byteLength": -42, "uri": "part.bin"}])"; },
     "buffers[0].byteLength is -42"},
    {"materials without end",
     [](Parts& p) {
         p.more = R"(, "materials": [{})";
         for (size_t i = 0; i < kMaxGltfElements; ++i) p.more += ",{}";
         p.more += "]";
     },
     "65537 materials"},
    {"a broken image",
     [](Parts& p) {
         p.more =
             R"(, "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}], "textures": [{"source": 0}],
        "images": [{"uri": "part.bin"}])";
         p.primitive = R"({"attributes": {"POSITION": 0}, "material": 0})";
     },
     "neither PNG nor JPEG"},
};

TEST(MeshIo, EveryFaultIsNamedWithItsFileAndARemedy) {
    for (const Bad& bad : kBad) {
        Parts p;
        bad.damage(p);
        const Result<Mesh> m = readParts(p);
        ASSERT_FALSE(m) << bad.what;
        EXPECT_EQ(m.error().code, ExitCode::Unsound) << bad.what;
        EXPECT_NE(m.error().text().find(bad.says), std::string::npos) << bad.what << ": " << m.error().text();
        EXPECT_NE(m.error().file.find("models/thing.gltf"), std::string::npos) << bad.what;
    }
}

TEST(MeshIo, FilesThatAreNotThereEmptyTooLongOrOutsideAreRefused) {
    const TempDir dir;
    const auto says = [&](const std::string& file) {
        const auto m = readMesh(dir.path, file);
        return m ? "" : m.error().text();
    };
    EXPECT_NE(says("none.glb").find("none.glb"), std::string::npos);
    EXPECT_NE(says("../none.glb").find(".."), std::string::npos);
    EXPECT_NE(says("/etc/passwd"), "");
    writeText(dir / "empty.glb", "");
    EXPECT_NE(says("empty.glb").find("empty"), std::string::npos);
    writeText(dir / "huge.glb", "");
    fs::resize_file(dir / "huge.glb", kMaxMeshBytes + 1);
    EXPECT_NE(says("huge.glb").find("limit"), std::string::npos) << says("huge.glb");
    writeText(dir / "text.glb", "Hello.");
    EXPECT_NE(says("text.glb").find("text.glb"), std::string::npos);
}

TEST(MeshIo, MoreTrianglesThanTheLimitAreRefusedHoweverTheyComeAbout) {
    Parts p;
    p.bin.resize(36 + 3 * (kMaxMeshTriangles / 2 + 1));
    p.views = fmt::format(R"([{{"buffer": 0, "byteLength": 36}}, {{"buffer": 0, "byteOffset": 36, "byteLength": {}}}])",
                          p.bin.size() - 36);
    p.accessors = fmt::format(R"([{}, {{"bufferView": 1, "componentType": 5121, "count": {}, "type": "SCALAR"}}])",
                              kPositions, p.bin.size() - 36);
    EXPECT_TRUE(readParts(p));
    p.nodes = R"([{"mesh": 0, "children": [1]}, {"mesh": 0}])";
    const Result<Mesh> twice = readParts(p);
    ASSERT_FALSE(twice);
    EXPECT_NE(twice.error().text().find("more than 2000000 triangles"), std::string::npos) << twice.error().text();
}

// What mesh.write makes is never beyond what can be read.
TEST(MeshIo, NoMoreIsWrittenThanIsRead) {
    Mesh mesh;
    mesh.vertices.resize(3);
    for (size_t i = 0; i < 3; ++i) mesh.vertices[i] = {glm::vec3(i == 1, 0, i == 2), {0, 1, 0}, {}};
    mesh.indices = {0, 2, 1};
    mesh.parts = {{0, 3, glm::vec3(1), -1, 0}};
    updateBounds(mesh);
    EXPECT_TRUE(encodeGlb(mesh));
    mesh.indices.resize(3 * (kMaxMeshTriangles + 1));
    const auto large = encodeGlb(mesh);
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().code, ExitCode::Failed);
    EXPECT_NE(large.error().text().find("more than 2000000 triangles: 2000001"), std::string::npos)
        << large.error().text();
    mesh.indices = {0, 2, 1};
    mesh.vertices[1].position.x = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(encodeGlb(mesh));
}

// Deterministic damage of every kind: the reader refuses, or reads something sound.
void expectNoCrash(const fs::path& dir, const std::string& file, const std::string& good, int rounds) {
    std::mt19937 random(7);
    int read = 0;
    for (int i = 0; i < rounds; ++i) {
        std::string bad = good;
        const auto at = [&] { return random() % bad.size(); };
        switch (i % 4) {
            case 0:
                bad[at()] = static_cast<char>(random());
                break;
            case 1:
                bad.resize(at());
                break;
            case 2:
                for (int k = 0; k < 8; ++k) bad[at()] = "0123456789-[]{},\"e"[random() % 18];
                break;
            default:
                bad.erase(at(), random() % 16);
                break;
        }
        writeText(dir / file, bad);
        const Result<Mesh> m = readMesh(dir, file);
        if (m)
            expectSound(*m), ++read;
        else
            EXPECT_EQ(m.error().code, ExitCode::Unsound);
    }
    EXPECT_LT(read, rounds);
}
TEST(MeshIo, DamageOfEveryKindIsRefusedOrReadAsSomethingSound) {
    const TempDir dir;
    Parts p;
    p.primitive = R"({"attributes": {"POSITION": 0}, "indices": 1, "material": 0})";
    p.more = R"(, "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 1]}}])";
    p.write(dir.path);
    expectNoCrash(dir.path, "models/thing.gltf", p.text(), 1500);
    const Solid solid;
    expectNoCrash(dir.path, "a.glb", *encodeGlb(makeMesh({&solid, 1})), 1500);
}

TEST(MeshIo, ABinaryFileOfAnotherVersionIsRefused) {
    const TempDir dir;
    const Solid solid;
    std::string bytes = *encodeGlb(makeMesh({&solid, 1}));
    bytes[4] = 3;
    writeText(dir / "a.glb", bytes);
    const Result<Mesh> m = readMesh(dir.path, "a.glb");
    ASSERT_FALSE(m);
    EXPECT_NE(m.error().text().find(".glb of version 3; only 2"), std::string::npos) << m.error().text();
}

// --- in a project ------------------------------------------------------------------------------------------------
Project withObject(const fs::path& dir) {
    auto p = newProject(dir, tables().components);
    EXPECT_TRUE(p);
    const Entity e = *addEntity(*p, "thing");
    p->registry.add<StaticMesh>(e, {.file = "models/thing.gltf"});
    return std::move(*p);
}
TEST(MeshProject, CheckAndLoadRefuseABadObjectAndNameTheField) {
    const TempDir dir;
    Project p = withObject(dir / "p");
    Parts parts;
    parts.write(dir / "p");
    ASSERT_TRUE(saveProject(p, tables().components));
    ASSERT_TRUE(loadProject(dir / "p", tables().components));
    EXPECT_TRUE(checkProject(dir / "p", tables().components).refused.empty());
    parts.bin.resize(20);
    parts.write(dir / "p");
    const CheckReport report = checkProject(dir / "p", tables().components);
    ASSERT_EQ(report.refused.size(), 1u);
    EXPECT_NE(report.refused[0].text().find("thing.StaticMesh.file"), std::string::npos) << report.refused[0].text();
    const auto loaded = loadProject(dir / "p", tables().components);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ExitCode::Unsound);
}
TEST(MeshProject, SavingElsewhereTakesTheObjectAndWhatItRefersToAlong) {
    const TempDir dir;
    Project p = withObject(dir / "p");
    Parts().write(dir / "p");
    ASSERT_TRUE(saveProject(p, tables().components));
    const Project saved = snapshot(p, tables().components);
    p.dir = dir / "q";
    const auto written = saveProject(p, tables().components, &saved);
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_EQ(readText(dir / "q/models/part.bin"), Parts().bin);
    EXPECT_TRUE(loadProject(dir / "q", tables().components));
}

}  // namespace
}  // namespace sward
