// The structs that C++ and GLSL share: what GL made of their members' places in linked programs is where C++ has them.
#include "gpu/layout.h"

#include <epoxy/gl.h>

#include <set>

#include "frame/draw_context.h"
#include "gpu/program.h"
#include "project/project_files.h"
#include "scenes.h"

namespace sward::test {
namespace {
namespace fs = std::filesystem;

// Which struct a block holds, alone or in an array; "": words that are no struct.
const std::map<std::string, std::string> kBlocks = {{"BladeBlock", "Blade"},
                                                    {"RootBlock", "MeshBladeRoot"},
                                                    {"FeetBlock", "TreeInView"},
                                                    {"ForestBlock", "ForestGlobals"},
                                                    {"TilesBlock", "TileInView"},
                                                    {"CellBlock", "CellInstance"},
                                                    {"ChosenBlock", "ChosenCell"},
                                                    {"CommandBlock", ""},
                                                    {"CountBlock", "ChosenCounts"},
                                                    {"FieldBlock", "FieldGlobals"},
                                                    {"CullBlock", "CullGlobals"},
                                                    {"FlowerBlock", "FlowerGlobals"},
                                                    {"ForceBlock", "ForceGlobals"},
                                                    {"FrameBlock", "FrameGlobals"},
                                                    {"LightsBlock", "LightsGlobals"},
                                                    {"ListBlock", ""},
                                                    {"NodeBlock", "TerrainNode"},
                                                    {"ObjectLightBlock", ""},
                                                    {"NodeListBlock", "NodeOfCells"},
                                                    {"ShadowBlock", "ShadowGlobals"},
                                                    {"LampShadowBlock", "LampShadowGlobals"},
                                                    {"SliceBlock", "SliceGlobals"},
                                                    {"SlicesBlock", ""},
                                                    {"SoilBlock", "SoilGlobals"},
                                                    {"SpeciesBlock", "SpeciesGlobals"},
                                                    {"TessBlock", "TessGlobals"},
                                                    {"TessCellBlock", "TessCell"},
                                                    {"UpToBlock", ""},
                                                    {"VertexBlock", ""},
                                                    {"WaterBlock", "WaterGlobals"},
                                                    {"WindBlock", "WindGlobals"}};

std::vector<SharedMember> membersOf(const std::string& name) {
    std::vector<SharedMember> out;
    for (const SharedMember& m : sharedMembers())
        if (m.of == name) out.push_back(m);
    return out;
}
size_t endOf(const SharedMember& m) { return m.offset + m.stride * m.count; }
// Bytes from one struct to the next in an array of them: uniform blocks and structs with vectors of three or four begin
// at multiples of 16, and all that are shared are as long as C++ has them.
size_t sizeOf(const std::string& name) {
    static const std::map<std::string, size_t> kPlain = {{"CellInstance", 32}, {"ChosenCell", 16}, {"ChosenCounts", 8},
                                                         {"NodeOfCells", 16},  {"TessCell", 48},   {"TreeInView", 24}};
    if (const auto it = kPlain.find(name); it != kPlain.end()) return it->second;
    return (endOf(membersOf(name).back()) + 15) / 16 * 16;
}

// "name[3]" -> name and 3.
std::pair<std::string, size_t> indexed(const std::string& part) {
    const size_t bracket = part.find('[');
    if (bracket == std::string::npos) return {part, 0};
    return {part.substr(0, bracket), std::stoul(part.substr(bracket + 1))};
}

// Where C++ has what GL calls so, and how far apart its elements are: "lamps.lights[2].color" of LightsGlobals.
struct Place {
    size_t offset = 0, stride = 0;
    bool isArray = false;
};
std::optional<Place> placeOf(const std::string& resource, std::string name, std::set<std::string>& seen) {
    Place at;
    size_t begin = resource.find('.');
    at.offset = indexed(resource.substr(0, begin)).second * sizeOf(name);
    while (begin != std::string::npos) {
        const size_t end = resource.find('.', begin + 1);
        const auto [member, index] = indexed(resource.substr(begin + 1, end - begin - 1));
        const auto all = membersOf(name);
        const auto it = std::find_if(all.begin(), all.end(), [&m = member](const auto& o) { return o.name == m; });
        if (it == all.end() || index >= it->count) return std::nullopt;
        seen.insert(name + "." + member);
        at = {at.offset + it->offset + index * it->stride, it->stride, it->count > 1};
        name = it->type;
        begin = end;
    }
    return at;
}

std::string nameIn(GLuint program, GLenum what, GLuint index) {
    char text[256] = "";
    glGetProgramResourceName(program, what, index, sizeof(text), nullptr, text);
    return text;
}
GLint propertyOf(GLuint program, GLenum what, GLuint index, GLenum property) {
    GLint value = 0;
    glGetProgramResourceiv(program, what, index, 1, &property, 1, nullptr, &value);
    return value;
}

// Compares one kind of blocks: uniform blocks and their members, or storage blocks and theirs.
struct Kind {
    GLenum block, member;
};
constexpr Kind kKinds[] = {{GL_UNIFORM_BLOCK, GL_UNIFORM}, {GL_SHADER_STORAGE_BLOCK, GL_BUFFER_VARIABLE}};

void compareMember(GLuint program, GLenum kind, GLuint index, const std::string& block, std::set<std::string>& seen) {
    const std::string name = nameIn(program, kind, index);
    ASSERT_TRUE(kBlocks.contains(block)) << block << ": say in this test which struct it holds";
    const std::string of = kBlocks.at(block);
    if (of.empty()) return;
    const auto place = placeOf(name, of, seen);
    ASSERT_TRUE(place) << name << " is no member of " << of;
    EXPECT_EQ(propertyOf(program, kind, index, GL_OFFSET), static_cast<GLint>(place->offset)) << of << ", " << name;
    if (place->isArray)
        EXPECT_EQ(propertyOf(program, kind, index, GL_ARRAY_STRIDE), static_cast<GLint>(place->stride)) << name;
}

void compare(GLuint program, std::set<std::string>& seen) {
    for (const Kind& kind : kKinds) {
        GLint count = 0;
        glGetProgramInterfaceiv(program, kind.member, GL_ACTIVE_RESOURCES, &count);
        for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
            const GLint block = propertyOf(program, kind.member, i, GL_BLOCK_INDEX);
            if (block >= 0)
                compareMember(program, kind.member, i, nameIn(program, kind.block, static_cast<GLuint>(block)), seen);
        }
    }
}

std::vector<FeatureSet> featuresOfSamples() {
    std::vector<FeatureSet> out;
    const fs::path source(SWARD_SOURCE_DIR);
    for (const char* folder : {"projects", "tests/scenes"})
        for (const auto& entry : fs::directory_iterator(source / folder)) {
            if (!fs::exists(entry.path() / "project.json")) continue;  // presets, templates
            const auto p = loadProject(entry.path(), tables().components);
            EXPECT_TRUE(p) << (p ? "" : p.error().text());
            if (p) out.push_back(sceneFeatures(p->registry, tables()));
        }
    return out;
}

// Of one scene, those programs that no scene before it had: where members lie is said by their struct alone.
void comparePrograms(Programs& programs, const Pass& pass, const FeatureSet& scene, std::set<std::string>& linked,
                     std::set<std::string>& seen) {
    for (const ProgramRow& p : pass.programs) {
        if (!linked.insert(p.name).second) continue;
        const std::string constants = p.variants ? p.variants().front() : "";
        const auto program = programs.get(sourcesOf(p), featureConstants(scene) + constants);
        ASSERT_TRUE(program) << program.error().text();
        compare(*program, seen);
    }
}

TEST(Layout, MembersOfSharedStructsLieWhereLinkedProgramsReadThem) {
    NoGlErrors errors;
    gpu();
    Programs programs;
    std::set<std::string> linked, seen;
    std::vector<FeatureSet> samples = featuresOfSamples();
    EXPECT_GE(samples.size(), 8u);
    // What a program does not read in one scene is not in it: scenes that ask for most come first.
    std::ranges::stable_sort(samples, std::greater{}, [](const FeatureSet& scene) { return scene.count(); });
    for (const FeatureSet& scene : samples)
        for (const Pass* pass : planFrame(scene, ~0u, tables().effects).passes())
            comparePrograms(programs, *pass, scene, linked, seen);
    // Attributes are no blocks; every other struct has been compared, each member of it.
    const std::set<std::string> attributes = {"FlowerCell", "ObjectInstance"};
    for (const SharedMember& m : sharedMembers())
        if (!attributes.contains(std::string(m.of)))
            EXPECT_TRUE(seen.contains(std::string(m.of) + "." + std::string(m.name))) << m.of << "." << m.name;
}

}  // namespace
}  // namespace sward::test
