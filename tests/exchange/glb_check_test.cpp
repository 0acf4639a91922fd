// The check of a .glb finds each kind of damage.
#include "exchange/glb_check.h"

#include <gtest/gtest.h>

#include <cstring>

#include "mesh/glb_parts.h"
#include "scenes.h"

#include <tiny_gltf.h>

namespace sward::test {
namespace {

// One triangle, two instances of it.
struct Small {
    tinygltf::Model m;
    std::vector<glm::vec4> turns{{0, 0, 0, 1}, {0, 1, 0, 0}};
    std::vector<glm::vec3> at{{0, 0, 0}, {1, 2, 3}}, scales{{1, 1, 1}, {1, 2, 1}};
    std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    std::vector<uint32_t> indices{0, 1, 2};

    tinygltf::Model made() {
        beginModel(m);
        tinygltf::Primitive p;
        p.mode = TINYGLTF_MODE_TRIANGLES;
        p.attributes["POSITION"] = addFloats(m, corners, AccessorKind::VerticesWithBounds);
        p.indices = addIndices(m, indices);
        tinygltf::Mesh mesh;
        mesh.primitives.push_back(p);
        m.meshes.push_back(mesh);
        tinygltf::Value::Object a;
        a["TRANSLATION"] = tinygltf::Value(addFloats(m, at, AccessorKind::WithBounds));
        a["ROTATION"] = tinygltf::Value(addFloats(m, turns, AccessorKind::Plain));
        a["SCALE"] = tinygltf::Value(addFloats(m, scales, AccessorKind::Plain));
        tinygltf::Node& n = m.nodes[static_cast<size_t>(addNode(m, "grass", {}))];
        n.mesh = 0;
        n.extensions["EXT_mesh_gpu_instancing"] =
            tinygltf::Value(tinygltf::Value::Object{{"attributes", tinygltf::Value(a)}});
        return m;
    }
};
std::string faultOf(const tinygltf::Model& m) {
    const auto checked = checkGlb(*glbBytes(m));
    return checked ? "" : checked.error().message;
}
void expectFault(const tinygltf::Model& m, const std::string& part) {
    EXPECT_NE(faultOf(m).find(part), std::string::npos) << faultOf(m) << " instead of " << part;
}

TEST(GlbCheck, ASoundFileIsCounted) {
    Small s;
    const auto counts = checkGlb(*glbBytes(s.made()));
    ASSERT_TRUE(counts) << counts.error().text();
    EXPECT_EQ(counts->blades, 2u);
    EXPECT_EQ(counts->cells, 1u);
    EXPECT_EQ(checkGlb(*glbBytes(s.m), {.flowers = {"grass"}})->flowers, 2u);
    EXPECT_EQ(checkGlb(*glbBytes(s.m), {.scatters = {"grass"}})->scattered, 2u);
}

TEST(GlbCheck, NumbersThatCannotBeAreFound) {
    Small turned;
    turned.turns[1] = {0, 1, 0, 0.1f};
    expectFault(turned.made(), "not of length 1");
    Small flat;
    flat.scales[1].y = 0;
    expectFault(flat.made(), "not above 0");
    Small nan;
    nan.turns[0].x = std::numeric_limits<float>::quiet_NaN();
    expectFault(nan.made(), "not finite");
    Small beyond;
    beyond.indices[2] = 3;
    expectFault(beyond.made(), "beyond its vertices");
    Small fewer;
    fewer.scales.pop_back();
    expectFault(fewer.made(), "differ in number");
}

TEST(GlbCheck, BoundsAndPlacesAreChecked) {
    Small s;
    tinygltf::Model m = s.made();
    m.accessors[0].maxValues[0] = 2;
    expectFault(m, "other bounds");
    m = s.m;
    m.accessors[0].minValues.clear(), m.accessors[0].maxValues.clear();
    expectFault(m, "without bounds");
    m = s.m;
    m.bufferViews[2].byteOffset += 2;
    expectFault(m, "multiple of 4");
    m = s.m;
    m.accessors[3].count = 1000;
    expectFault(m, "leaves its view");
}

TEST(GlbCheck, TornFilesAreFound) {
    Small s;
    const std::string bytes = *glbBytes(s.made());
    EXPECT_FALSE(checkGlb(bytes.substr(0, bytes.size() - 4)));
    EXPECT_FALSE(checkGlb(""));
    EXPECT_FALSE(checkGlb(std::string(64, 'x')));
}

}  // namespace
}  // namespace sward::test
