// What a project file may hold: every row of what is refused, repaired and accepted, with its place and message.
#include <gtest/gtest.h>

#include <chrono>

#include "core/json.h"
#include "grass/hybrid.h"
#include "maps/map_io.h"
#include "project/project_files.h"
#include "project/project_json.h"
#include "scene/project.h"
#include "techniques.h"
#include "tests/maps/images.h"
#include "tests/rows.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {
// A project of one entity "e", one component a line from line 3 on.
std::string entity(const std::string& components) {
    return "{\"format\": 1, \"entities\": {\"e\": {\n\n" + components + "\n}}}";
}

struct Refused {
    const char* components;
    int line, column;
    const char* message;
};

// Loads, and finds the same refusal by load and by check, within a second.
Error refusal(const TempDir& dir, const std::string& text) {
    writeText(dir / "p/project.json", text);
    const auto start = std::chrono::steady_clock::now();
    const Result<Project> p = loadProject(dir / "p", rows());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
    EXPECT_FALSE(p) << text.substr(0, 300);
    const CheckReport report = checkProject(dir / "p", rows());
    EXPECT_FALSE(report.refused.empty());
    if (p || report.refused.empty()) return {};
    EXPECT_EQ(report.refused[0].text(), p.error().text());
    EXPECT_EQ(p.error().code, ExitCode::Unsound);
    return p.error();
}

// Loads with exactly these repairs, "line: message"; check finds the same.
Project repaired(const TempDir& dir, const std::string& text, const std::vector<std::string>& expected) {
    writeText(dir / "p/project.json", text);
    LoadReport report;
    Result<Project> p = loadProject(dir / "p", rows(), &report);
    EXPECT_TRUE(p) << (p ? "" : p.error().text());
    if (!p) return Project();
    std::vector<std::string> said, checked;
    const std::string prefix = (dir / "p/").string();
    for (const Fault& f : report.repaired) said.push_back(f.where.substr(prefix.size()) + ": " + f.message);
    for (const Fault& f : checkProject(dir / "p", rows()).repaired)
        checked.push_back(f.where.substr(prefix.size()) + ": " + f.message);
    EXPECT_EQ(said, expected);
    EXPECT_EQ(checked, expected);
    return std::move(*p);
}
Project accepted(const TempDir& dir, const std::string& text) { return repaired(dir, text, {}); }

const HybridTiers& tiersIn(const Project& p) { return *p.registry.get<HybridTiers>(findEntity(p, "e")); }
const GrassField& grassOf(const Project& p) { return *p.registry.get<GrassField>(findEntity(p, "e")); }
}  // namespace

TEST(RefusedProjects, AFolderWithoutAProject) {
    TempDir dir;
    const Result<Project> none = loadProject(dir / "none", rows());
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "is no folder with a project");
    EXPECT_NE(none.error().remedy.find("sward new"), std::string::npos);
    const Result<Project> empty = loadProject(dir.path, rows());
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.error().file, (dir / "project.json").string());
    EXPECT_EQ(empty.error().code, ExitCode::Unsound);
}

TEST(RefusedProjects, FaultsOfTheTextWithLineAndColumn) {
    TempDir dir;
    struct Case {
        std::string text;
        int line, column;
        const char* message;
    };
    const Case cases[] = {
        {"{\"format\": 1,\n  \"name\": \"a\",\n  \"name\": \"b\"}", 3, 3, "duplicate key \"name\""},
        {"{\"format\": 1,\n \"entities\": {\"e\": {\"Camera\": {\"fovDeg\": 1e999}}}}", 2, 0, "too large"},
        {"{\"format\": 1,\n \"entities\": {\"e\": {\"Camera\": {\"fovDeg\": NaN}}}}", 2, 42, "syntax error"},
        {"{\"format\": 1,\n \"entities\": ", 2, 0, "unexpected end"},
        {"{\"format\": 1,\n \"entities\": {}} rest", 2, 0, "syntax error"},
        {"{\"format\": 1,\n \"x\": " + std::string(200000, '[') + "}", 2, 0, "more than 64 levels"},
        {"[1, 2]", 1, 1, "a project is an object, not a list"},
        {"", 1, 1, "unexpected end"},
        {std::string("{\"format\": 1, \"name\": \"a\xff\"}"), 1, 25, "UTF-8"},
        {"{\"format\": 1,\n\"name\": \"a\"}\n" + std::string(1, '\0') + "{\"name\": \"b\"}", 3, 1, "NUL"},
    };
    for (const Case& c : cases) {
        const Error e = refusal(dir, c.text);
        EXPECT_NE(e.message.find(c.message), std::string::npos) << e.text();
        EXPECT_EQ(e.file, (dir / "p/project.json").string());
        EXPECT_EQ(e.line, c.line) << e.text();
        if (c.column > 0) {
            EXPECT_EQ(e.column, c.column) << e.text();
        }
        EXPECT_GT(e.column, 0);
    }
}

TEST(RefusedProjects, ATextBeyondTheLimitOfSize) {
    TempDir dir;
    const Error e = refusal(dir, "{\"name\": \"" + std::string(kMaxJsonBytes, 'x') + "\"}");
    EXPECT_NE(e.message.find(fmt::format("the limit is {}", kMaxJsonBytes)), std::string::npos) << e.text();
}

TEST(RefusedProjects, ANewerFormatWithTheRemedy) {
    TempDir dir;
    const Error e = refusal(dir, "{\"entities\": {},\n  \"format\": 3}");
    EXPECT_EQ(e.message, "format 3 is newer than this Sward, which reads up to 2");
    EXPECT_EQ(e.line, 2);
    EXPECT_EQ(e.column, 13);
    EXPECT_NE(e.remedy.find("newer one"), std::string::npos);
    for (const char* bad : {"0", "-1", "1.5", "\"1\"", "null"})
        EXPECT_NE(refusal(dir, std::string("{\"format\": ") + bad + "}").message.find("format"), std::string::npos);
}

TEST(RefusedProjects, ParametersWithTheirPlace) {
    TempDir dir;
    const Refused cases[] = {
        {"\"GrassField\": {\"minGeom\": -1}", 3, 27, "e.HybridTiers.minGeom: -1 must not be negative"},
        {"\"GrassField\": {\"maxGeom\": -0.5}", 3, 27, "e.HybridTiers.maxGeom: -0.5 must not be negative"},
        {"\"Terrain\": {\"lodDistance\": -3}", 3, 28, "e.Terrain.lodDistance: -3 must not be negative"},
        {"\"Fog\": {\"visibility\": -4000}", 3, 23, "e.Fog.visibility: -4000 must not be negative"},
        {"\"Camera\": {\"fovDeg\": \"inf\"}", 3, 22, "e.Camera.fovDeg: \"inf\" is not allowed here"},
        {"\"Camera\": {\"fovDeg\": \"nan\"}", 3, 22, "e.Camera.fovDeg: \"nan\" is not allowed here"},
        {"\"GrassField\": {\"minGeom\": \"-inf\"}", 3, 27, "e.HybridTiers.minGeom: \"-inf\" is not allowed here"},
        {"\"Camera\": {\"eye\": [0, \"nan\", 0]}", 3, 23, "e.Camera.eye: \"nan\" is not allowed here"},
        {"\"Camera\": {\"eye\": [0, 1]}", 3, 19, "e.Camera.eye: must be a list of 3 numbers"},
        {"\"Camera\": {\"fovDeg\": 1e39}", 3, 22, "e.Camera.fovDeg: 1e39 is out of range"},
        {"\"Camera\": {\"fovDeg\": true}", 3, 22, "e.Camera.fovDeg: must be a number, not true or false"},
        {"\"Terrain\": {\"size\": [0, 10]}", 3, 22, "e.Terrain.size: 0 is out of range"},
        {"\"Light\": {\"attenuation\": -1}", 3, 26, "e.Light.attenuation: -1 must not be negative"},
        {"\"Light\": {\"intensity\": 70000}", 3, 24, "e.Light.intensity: 70000 is out of range"},
        {"\"GrassField\": {\"seed\": 1.5}", 3, 24, "e.GrassField.seed: 1.5 is not a whole number"},
        {"\"GrassField\": {\"technique\": \"magic\"}", 3, 29,
         "e.GrassField.technique: \"magic\" is none of its values"},
        {"\"GrassField\": {\"technique\": 1}", 3, 29, "e.GrassField.technique: a number is none of its values"},
        {"\"GrassField\": {\"species\": {}}", 3, 27, "e.GrassField.species: must be a list, not an object"},
        {"\"GrassField\": {\"species\": [7]}", 3, 28, "e.GrassField.species[grass]: must be an object, not a number"},
        {"\"GrassField\": {\"species\": [{\"name\": \"a\"},\n{\"name\": \"b\", \"height\": -1}]}", 4, 25,
         "e.GrassField.species[b].height: -1 must not be negative"},
        {"\"GrassField\": {\"species\": [{\"stiffness\": 0}]}", 3, 42,
         "e.GrassField.species[grass].stiffness: 0 is out of range"},
        {"\"GrassField\": {\"species\": [{\"stiffness\": -2}]}", 3, 42,
         "e.GrassField.species[grass].stiffness: -2 must not be negative"},
        {"\"GrassField\": {\"species\": [{\"stiffness\": \"nan\"}]}", 3, 42,
         "e.GrassField.species[grass].stiffness: \"nan\" is not allowed here"},
        {"\"GrassField\": {\"species\": [{\"name\": 7}]}", 3, 37,
         "e.GrassField.species[grass].name: must be a string, not a number"},
        {"\"GrassField\": 7", 3, 15, "e.GrassField: must be an object, not a number"},
        {"\"Terrain\": {\"height\": 7}", 3, 23, "e.Terrain.height: must be a string, not a number"},
    };
    for (const Refused& c : cases) {
        const Error e = refusal(dir, entity(c.components));
        EXPECT_EQ(e.message, c.message);
        EXPECT_EQ(e.line, c.line) << e.text();
        EXPECT_EQ(e.column, c.column) << e.text();
    }
}

TEST(RefusedProjects, ValuesOutsideTheRangeOfAnyField) {
    TempDir dir;
    for (const ComponentRow& row : rows())
        for (const FieldRow& field : row.fields) {
            if (field.type != FieldType::Float && field.type != FieldType::Int) continue;
            for (const double value : {field.hardMin - 1, field.hardMax * 2 + 1}) {
                const std::string number = shortestText(value);
                const Error e =
                    refusal(dir, entity(fmt::format("\"{}\": {{\"{}\": {}}}", row.name, field.name, number)));
                EXPECT_NE(e.message.find(fmt::format("e.{}.{}: {}", row.name, field.name, number)), std::string::npos)
                    << e.text();
                EXPECT_NE(e.remedy.find("it takes"), std::string::npos);
            }
        }
}

TEST(RefusedProjects, PathsThatLeaveTheProject) {
    TempDir dir;
    writeText(dir / "secret.png", "secret");
    for (const char* path : {"/etc/passwd", "../secret.png", "maps/../../secret.png", ".sward-save/x.png"})
        for (const char* field : {"\"Terrain\": {\"height\": \"", "\"Terrain\": {\"groundTexture\": \""}) {
            const Error e = refusal(dir, entity(std::string(field) + path + "\"}"));
            EXPECT_EQ(e.line, 3);
            EXPECT_NE(e.message.find("e.Terrain."), std::string::npos);
            EXPECT_EQ(e.remedy, "name a file inside the project's folder");
        }
}

TEST(RefusedProjects, SymbolicLinksThatLeaveTheProject) {
    TempDir dir;
    ASSERT_TRUE(writeMap(dir / "outside.png", patternMap({8, 8, 1, PixelType::U16})));
    fs::create_directories(dir / "p/maps");
    fs::create_symlink(dir / "outside.png", dir / "p/maps/link.png");
    EXPECT_NE(refusal(dir, entity("\"Terrain\": {\"height\": \"maps/link.png\"}")).message.find("symbolic link"),
              std::string::npos);
    fs::create_symlink(dir.path, dir / "p/folder");
    EXPECT_NE(
        refusal(dir, entity("\"Terrain\": {\"groundTexture\": \"folder/outside.png\"}")).message.find("symbolic link"),
        std::string::npos);
    ASSERT_TRUE(writeMap(dir / "p/maps/real.png", patternMap({8, 8, 1, PixelType::U16})));
    fs::create_symlink("real.png", dir / "p/maps/inside.png");
    accepted(dir, entity("\"Terrain\": {\"height\": \"maps/inside.png\"}"));
}

TEST(RefusedProjects, MapsThatCannotBeUsed) {
    TempDir dir;
    const auto heightRefusal = [&](const char* file) {
        return refusal(dir, entity(fmt::format("\"Terrain\": {{\"height\": \"maps/{}\"}}", file)));
    };
    const Error missing = heightRefusal("none.exr");
    EXPECT_EQ(missing.message, "e.Terrain.height: cannot be read: No such file or directory");
    EXPECT_EQ(missing.file, (dir / "p/maps/none.exr").string());
    fs::create_directories(dir / "p/maps");
    ASSERT_TRUE(writeMap(dir / "p/maps/h.png", patternMap({8, 8, 1, PixelType::U8})));
    EXPECT_NE(heightRefusal("h.png").message.find("8 bits"), std::string::npos);
    ASSERT_TRUE(writeMap(dir / "p/maps/rgb.png", patternMap({8, 8, 3, PixelType::U16})));
    EXPECT_EQ(heightRefusal("rgb.png").message, "e.Terrain.height: has 3 channels, not 1");
    writeText(dir / "p/maps/bomb.exr", exrBomb(8166272, 23));
    EXPECT_NE(heightRefusal("bomb.exr").message.find("the limit is 16384"), std::string::npos);
    writeText(dir / "p/maps/bomb.png", pngBomb(30000, 30000));
    EXPECT_NE(heightRefusal("bomb.png").message.find("the limit is 16384"), std::string::npos);
    writeText(dir / "p/maps/zero.png", pngBomb(0, 0));
    EXPECT_EQ(heightRefusal("zero.png").message, "e.Terrain.height: has size 0 x 0");
    writeText(dir / "p/maps/a.json", R"({"width": 2, "height": 2})");
    writeText(dir / "p/maps/a.r16", "12345678");
    EXPECT_NE(heightRefusal("a.r16").remedy.find("import"), std::string::npos);
}

TEST(RefusedProjects, ImagesThatCannotBeUsed) {
    TempDir dir;
    const Error e =
        refusal(dir, entity("\"GrassField\": {\"species\": [{\"name\": \"a\", \"texture\": \"blade.png\"}]}"));
    EXPECT_EQ(e.message, "e.GrassField.species[a].texture: cannot be read: No such file or directory");
    writeText(dir / "p/blade.png", pngBomb(30000, 30000));
    EXPECT_NE(
        refusal(dir, entity("\"Terrain\": {\"groundTexture\": \"blade.png\"}")).message.find("the limit is 16384"),
        std::string::npos);
}

// Its header is sound: only who decodes it all finds the fault.
TEST(RefusedProjects, ImagesWithADamagedByte) {
    TempDir dir;
    std::vector<uint8_t> pixels(64 * 64 * 4);
    for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<uint8_t>(i * i >> 3);
    ASSERT_TRUE(writeImagePng(dir / "sound.png", 64, 64, 4, pixels));
    const std::string sound = readText(dir / "sound.png");
    const std::string fields[] = {entity("\"Terrain\": {\"groundTexture\": \"t.png\"}"),
                                  entity("\"GrassField\": {\"species\": [{\"name\": \"a\", \"texture\": \"t.png\"}]}")};
    for (const std::string& field : fields) {
        std::string broken = sound;
        broken[broken.size() / 2] = static_cast<char>(broken[broken.size() / 2] ^ 0x10);
        writeText(dir / "p/t.png", broken);
        const Error e = refusal(dir, field);
        EXPECT_EQ(e.code, ExitCode::Unsound);
        EXPECT_NE(e.message.find("exture: is truncated or damaged"), std::string::npos) << e.text();
        EXPECT_TRUE(e.file.ends_with("t.png")) << e.text();
    }
}

TEST(RefusedProjects, EntitiesAndListsThatCannotBe) {
    TempDir dir;
    EXPECT_NE(refusal(dir, "{\"entities\": {\"a b\": {}}}").message.find("cannot name an entity"), std::string::npos);
    EXPECT_EQ(refusal(dir, "{\"entities\": {\"a\": 7}}").message, "a: must be an object of components, not a number");
    EXPECT_EQ(refusal(dir, "{\"entities\": []}").message, "entities: must be an object, not a list");
    EXPECT_EQ(refusal(dir, "{\"name\": 1}").message, "name: must be a string, not a number");
    EXPECT_EQ(refusal(dir, "{\"imports\": 1}").message, "imports: must be an object, not a number");
    std::string many;
    for (size_t i = 0; i <= kMaxListElements; ++i) many += i ? ",{}" : "{}";
    EXPECT_NE(refusal(dir, entity("\"GrassField\": {\"species\": [" + many + "]}")).message.find("the limit is 1024"),
              std::string::npos);
}

TEST(RefusedProjects, CheckGoesOnAfterTheFirstFault) {
    TempDir dir;
    writeText(dir / "p/project.json", entity("\"Camera\": {\"fovDeg\": -1, \"exposure\": 99},\n\"Terrain\": "
                                             "{\"height\": \"maps/none.exr\"},\n\"Wings\": {}"));
    const CheckReport report = checkProject(dir / "p", rows());
    ASSERT_EQ(report.refused.size(), 3u);
    EXPECT_NE(report.refused[0].message.find("exposure"), std::string::npos);
    EXPECT_NE(report.refused[1].message.find("fovDeg"), std::string::npos);
    EXPECT_NE(report.refused[2].message.find("height"), std::string::npos);
    EXPECT_EQ(report.repaired.size(), 1u);
}

TEST(RepairedProjects, TierDistancesThatAreSwappedOrEqual) {
    TempDir dir;
    const Project swapped =
        repaired(dir, entity("\"GrassField\": {\"minGeom\": 12, \"maxGeom\": 4}"),
                 {"project.json:3: e.HybridTiers: minGeom was greater than maxGeom; swapped to 4 and 12"});
    EXPECT_EQ(tiersIn(swapped).minGeom, 4.0f);
    EXPECT_EQ(tiersIn(swapped).maxGeom, 12.0f);
    const Project equal =
        repaired(dir, entity("\"GrassField\": {\"minGeom\": 10, \"maxGeom\": 10}"),
                 {"project.json:3: e.HybridTiers: minGeom and maxGeom were both 10; maxGeom is now 11"});
    EXPECT_GT(tiersIn(equal).maxGeom, tiersIn(equal).minGeom);
    const Project infinite =
        repaired(dir, entity("\"GrassField\": {\"minGeom\": \"inf\", \"maxGeom\": 10}"),
                 {"project.json:3: e.HybridTiers: minGeom was greater than maxGeom; swapped to 10 and inf"});
    EXPECT_EQ(tiersIn(infinite).minGeom, 10.0f);
    const Project zero =
        repaired(dir, entity("\"GrassField\": {\"minGeom\": 0, \"maxGeom\": 0}"),
                 {"project.json:3: e.HybridTiers: minGeom and maxGeom were both 0; maxGeom is now 0.1"});
    EXPECT_EQ(tiersIn(zero).minGeom, 0.0f);
}

TEST(RepairedProjects, ACameraThatLooksAtItself) {
    TempDir dir;
    const Project p =
        repaired(dir, entity("\"Camera\": {\"eye\": [1, 2, 3], \"target\": [1, 2, 3]}"),
                 {"project.json:3: e.Camera: eye and target were the same point; target is now 1 m to the north"});
    EXPECT_EQ(p.registry.get<Camera>(findEntity(p, "e"))->target, glm::dvec3(1, 2, 2));
}

TEST(RepairedProjects, TexelsThatAreNotFiniteAreCountedAndTheNextSaveWritesThem) {
    TempDir dir;
    Map map = patternMap({16, 16, 1, PixelType::F32});
    map.set(5, 6, 0, std::numeric_limits<float>::quiet_NaN());
    fs::create_directories(dir / "p/maps");
    ASSERT_TRUE(writeMap(dir / "p/maps/h.exr", map));
    const std::string text = entity("\"Terrain\": {\"height\": \"maps/h.exr\"}");
    const Project p = repaired(
        dir, text, {"maps/h.exr: e.Terrain.height: texel (5, 6) is not finite; replaced by the nearest finite texel"});
    const Project same = snapshot(p, rows());
    EXPECT_EQ(*saveProject(p, rows(), &same), std::vector<std::string>{"maps/h.exr"});
    accepted(dir, text);
    EXPECT_EQ(*saveProject(p, rows(), &same), std::vector<std::string>{});
}

TEST(RepairedProjects, AMapOfOneTexel) {
    TempDir dir;
    fs::create_directories(dir / "p/maps");
    ASSERT_TRUE(writeMap(dir / "p/maps/h.png", Map({1, 1, 1, PixelType::U16})));
    const Project p = repaired(dir, entity("\"Terrain\": {\"height\": \"maps/h.png\"}"),
                               {"maps/h.png: e.Terrain.height: texel (0, 0) is the only one; the map is constant"});
    EXPECT_EQ(*saveProject(p, rows()), std::vector<std::string>{});
}

TEST(RepairedProjects, WhatIsUnknownIsKeptAndWrittenBack) {
    TempDir dir;
    const std::string text = R"({"format": 1, "colour scheme": {"a": [1, 2, 3, 4, 5]},
 "entities": {"e": {
  "Camera": {"fovDeg": 40, "lens.kind": {"blades": 7, "big": 12345678901234567890}},
  "GrassField": {"species": [{"name": "lawn", "scent": 0.1}, {"name": "lawn", "scent": 2}]},
  "Wings": [null, true, "x"]}}})";
    Project p = repaired(dir, text,
                         {"project.json:1: unknown entry \"colour scheme\" (kept as it is)",
                          "project.json:3: unknown field \"e.Camera.lens.kind\" (kept as it is)",
                          "project.json:4: unknown field \"e.GrassField.species[0].scent\" (kept as it is)",
                          "project.json:4: unknown field \"e.GrassField.species[1].scent\" (kept as it is)",
                          "project.json:5: unknown component \"e.Wings\" (kept as it is)"});
    EXPECT_EQ(*saveProject(p, rows()), std::vector<std::string>{}) << "nothing changed";
    p.registry.get<Camera>(findEntity(p, "e"))->fovDeg = 41;
    EXPECT_EQ(*saveProject(p, rows()), std::vector<std::string>{"project.json"});
    const Result<Json> j = readJson(dir / "p/project.json");
    ASSERT_TRUE(j);
    EXPECT_EQ(j->find("colour scheme")->find("a")->array.size(), 5u);
    const Json& e = *j->find("entities")->find("e");
    EXPECT_EQ(e.find("Camera")->find("lens.kind")->find("big")->text, "12345678901234567890");
    EXPECT_EQ(e.find("GrassField")->find("species")->array[1].find("scent")->text, "2");
    EXPECT_EQ(e.find("Wings")->array[2].text, "x");
    Project again = std::move(*loadProject(dir / "p", rows()));
    EXPECT_EQ(again.unknown, p.unknown);
    EXPECT_TRUE(removeEntity(again, "e"));
    ASSERT_TRUE(saveProject(again, rows()));
    EXPECT_EQ(readJson(dir / "p/project.json")->find("entities")->object.size(), 0u)
        << "what is gone takes the unknown with it";
}

// What loads, so that the editor can mend it, and what no verb would draw.
TEST(CheckedScenes, AUniquePopulationBeyondItsLimitIsRefusedAtItsPlace) {
    TempDir dir;
    const auto checked = [&](const char* size) {
        writeText(
            dir / "p/project.json",
            entity(fmt::format("\"Terrain\": {{\"size\": [{}, {}]}},\n\"GrassField\": {{\"population\": \"unique\"}}",
                               size, size)));
        EXPECT_TRUE(loadProject(dir / "p", rows()));
        return checkProject(dir / "p", rows());
    };
    EXPECT_TRUE(checked("30").refused.empty());
    const CheckReport r = checked("40");
    ASSERT_EQ(r.refused.size(), 1u);
    EXPECT_EQ(r.refused[0].code, ExitCode::Unsound);
    EXPECT_EQ(r.refused[0].text().substr(
                  0, (dir / "p/project.json:4:30: e.GrassField.population: 3200000 blades").string().size()),
              (dir / "p/project.json:4:30: e.GrassField.population: 3200000 blades").string());
    EXPECT_NE(r.refused[0].remedy.find("\"patch\""), std::string::npos);
}

TEST(CheckedScenes, AnOutlineOfNoMeshIsAFaultWithItsRemedy) {
    TempDir dir;
    const auto checked = [&](const char* components) {
        writeText(dir / "p/project.json", entity(components));
        const CheckReport r = checkProject(dir / "p", rows());
        EXPECT_TRUE(r.refused.empty());
        return r.repaired;
    };
    const std::vector<Fault> faults =
        checked("\"Transform\": {},\n\"ForceSource\": {\"radius\": 1, \"shape\": \"outline\"}");
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].where, (dir / "p/project.json:4").string());
    EXPECT_NE(
        faults[0].message.find(
            "e.ForceSource.shape: an outline is that of the entity's StaticMesh, and it has none with a file: add one"),
        std::string::npos)
        << faults[0].message;
    EXPECT_EQ(checked("\"ForceSource\": {\"shape\": \"outline\"},\n\"StaticMesh\": {}").size(), 1u);
    EXPECT_TRUE(checked("\"ForceSource\": {\"shape\": \"object\"}").empty());
}

TEST(CheckedScenes, ASpeciesWithoutHeightOrWidthIsNoticedButSound) {
    TempDir dir;
    writeText(
        dir / "p/project.json",
        entity("\"GrassField\": {\"species\": [{\"name\": \"a\", \"height\": 0},\n{\"name\": \"b\", \"width\": 0},\n"
               "{\"name\": \"c\", \"width\": 0, \"bladesPerM2\": 0}, {\"name\": \"d\"}]}"));
    const CheckReport r = checkProject(dir / "p", rows());
    EXPECT_TRUE(r.refused.empty());
    EXPECT_TRUE(r.repaired.empty());
    ASSERT_EQ(r.noticed.size(), 2u) << "what does not grow, and what has both, is as meant";
    EXPECT_EQ(r.noticed[0].where, (dir / "p/project.json:3").string());
    EXPECT_EQ(r.noticed[1].where, (dir / "p/project.json:4").string());
    EXPECT_EQ(r.noticed[0].message.find("e.GrassField.species[a].height is 0"), 0u) << r.noticed[0].message;
    EXPECT_EQ(r.noticed[1].message.find("e.GrassField.species[b].width is 0"), 0u) << r.noticed[1].message;
}

TEST(AcceptedProjects, InfiniteTierDistances) {
    TempDir dir;
    const Project p = accepted(
        dir, entity("\"GrassField\": {\"minGeom\": 3, \"maxGeom\": \"inf\"},\n\"Fog\": {\"visibility\": \"inf\"}"));
    EXPECT_TRUE(std::isinf(tiersIn(p).maxGeom));
    EXPECT_FALSE(has(sceneFeatures(p.registry, tables()), Feature::Fog)) << "no haze";
    accepted(dir, entity("\"GrassField\": {\"minGeom\": \"inf\", \"maxGeom\": \"inf\"}"));
    ASSERT_TRUE(saveProject(p, rows()));
    EXPECT_NE(readText(dir / "p/project.json").find("\"maxGeom\": \"inf\""), std::string::npos);
}

TEST(AcceptedProjects, FieldsThatAreAbsentHaveTheirDefaults) {
    TempDir dir;
    const Project p = accepted(dir, entity("\"Camera\": {},\n\"GrassField\": {},\n\"Terrain\": {}"));
    EXPECT_EQ(p.registry.get<Camera>(findEntity(p, "e"))->fovDeg, Camera().fovDeg);
    EXPECT_EQ(grassOf(p).species.size(), 1u);
    EXPECT_TRUE(accepted(dir, "{}").entities.empty());
    EXPECT_EQ(accepted(dir, "{}").name, "p");
}

TEST(AcceptedProjects, AnEmptySpeciesListGrowsNothing) {
    TempDir dir;
    const Project p = accepted(dir, entity("\"GrassField\": {\"species\": []}"));
    EXPECT_TRUE(sceneFeatures(p.registry, tables()).none());
    EXPECT_EQ(virtualBlades(p), 0);
}

TEST(AcceptedProjects, OneFileMayServeTwoFields) {
    TempDir dir;
    fs::create_directories(dir / "p/maps");
    ASSERT_TRUE(writeMap(dir / "p/maps/d.png", patternMap({8, 8, 1, PixelType::U16})));
    Project p = accepted(dir, entity("\"GrassField\": {\"species\": [{\"name\": \"a\", \"density\": \"maps/d.png\"},"
                                     "{\"name\": \"b\", \"density\": \"maps/d.png\"}]}"));
    EXPECT_EQ(*saveProject(p, rows()), std::vector<std::string>{});
    auto& field = *p.registry.get<GrassField>(findEntity(p, "e"));
    EXPECT_TRUE(field.species[0].density.map.sameTiles(field.species[1].density.map));
    field.species[1].density.map.set(0, 0, 0, 0.5f);
    EXPECT_EQ(*saveProject(p, rows()), (std::vector<std::string>{"maps/e.b.density.png", "project.json"}));
    EXPECT_EQ(*saveProject(p, rows()), std::vector<std::string>{}) << "the same name again";
    const Project again = std::move(*loadProject(dir / "p", rows()));
    EXPECT_EQ(grassOf(again).species[0].density.map.hash(), field.species[0].density.map.hash());
    EXPECT_EQ(grassOf(again).species[1].density.map.hash(), field.species[1].density.map.hash());
}
