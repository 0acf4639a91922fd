// The order of the table of effects means nothing: plans and pictures stay as they are when it is shuffled.
#include "frame/plan.h"

#include <epoxy/gl.h>

#include <random>

#include "frame/draw_context.h"

#include "project/project_files.h"
#include "scenes.h"
#include "techniques.h"

namespace sward::test {
namespace {
namespace fs = std::filesystem;

// The sample projects and the test scenes.
std::vector<Project> samples() {
    std::vector<Project> out;
    for (const char* folder : {"projects", "tests/scenes"})
        for (const auto& entry : fs::directory_iterator(fs::path(SWARD_SOURCE_DIR) / folder)) {
            if (!fs::exists(entry.path() / "project.json")) continue;  // presets, templates
            auto project = loadProject(entry.path(), tables().components);
            EXPECT_TRUE(project) << project.error().text();
            if (project) out.push_back(std::move(*project));
        }
    return out;
}

using Names = std::vector<std::string>;
Names stepNames(const FeatureSet& features, unsigned views, std::span<const EffectRow> effects) {
    Names names;
    for (const Step& s : planFrame(features, views, effects).steps) names.push_back(s.name());
    return names;
}

TEST(PlanOrder, OfEverySampleIsTheSameForAHundredShuffledTables) {
    std::vector<std::pair<std::string, FeatureSet>> features;
    for (const Project& p : samples()) features.emplace_back(p.name, sceneFeatures(p.registry, tables()));
    ASSERT_GE(features.size(), 8u);
    std::vector<EffectRow> rows(tables().effects.begin(), tables().effects.end());
    std::mt19937 random(11);
    for (int i = 0; i < 100; ++i) {
        std::shuffle(rows.begin(), rows.end(), random);
        for (const auto& [name, asked] : features)
            for (const unsigned view : {kViewMain, kViewReflection})
                ASSERT_EQ(stepNames(asked, view, tables().effects), stepNames(asked, view, rows)) << name;
    }
}

std::vector<uint8_t> picture(const Tables& all, Project& p) {
    Renderer renderer(gpu(), all);
    ViewSettings s;
    s.width = 48, s.height = 36, s.msaa = 1, s.time = 1;
    const Status drawn = renderer.draw(p, viewOf(*findCamera(p, "")), s);
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    return renderer.readImage();
}

TEST(PlanOrder, PicturesAreTheSameForShuffledTables) {
    NoGlErrors errors;
    std::vector<EffectRow> rows(tables().effects.begin(), tables().effects.end());
    Tables shuffled = tables();
    shuffled.effects = rows;
    std::mt19937 random(5);
    for (const char* folder : {"tests/scenes/field40", "projects/oasis"}) {
        auto p = loadProject(fs::path(SWARD_SOURCE_DIR) / folder, tables().components);
        ASSERT_TRUE(p) << p.error().text();
        const std::vector<uint8_t> expected = picture(tables(), *p);
        std::shuffle(rows.begin(), rows.end(), random);
        EXPECT_TRUE(picture(shuffled, *p) == expected) << folder;
    }
}

// A picture of which the driver has refused a part may be black: whoever waits for it is told, the editor goes on.
TEST(Refused, APictureThatOpenGLRefusesAPartOfIsAFailureButForWhoIsAtWork) {
    const System refused[] = {{"test/refused", {}, [](DrawContext&) { glEnable(0xFFFF); }}};
    std::vector<EffectRow> rows(tables().effects.begin(), tables().effects.end());
    EffectRow row{};
    row.name = "test/refused", row.systems = refused;
    rows.push_back(row);
    Tables broken = tables();
    broken.effects = rows;
    Project p = lawn();
    Renderer renderer(gpu(), broken);
    ViewSettings s;
    s.width = 48, s.height = 36, s.msaa = 1;
    const Status drawn = renderer.draw(p, eyeHeight(), s);
    ASSERT_FALSE(drawn);
    EXPECT_NE(drawn.error().text().find("OpenGL refused"), std::string::npos) << drawn.error().text();
    s.background = true;
    EXPECT_TRUE(renderer.draw(p, eyeHeight(), s));
}

}  // namespace
}  // namespace sward::test
