// A technique that is known here alone, in the programs that draw: rendered by --technique, explained, compared with,
// chosen in the inspector.
#include "techniques.h"

#include "cli/cli.h"
#include "editor/editor_fixture.h"
#include "fields.h"
#include "maps/image_file.h"
#include "project/project_files.h"

namespace sward::test {
namespace {

FieldTiers nearTiers(const FieldEntity&, float) {
    FieldTiers t;
    t.blades = fadeRange(1, 3);
    return t;
}
TechniqueRow stubble() {
    TechniqueRow row = *findTechnique(tables().techniques, nameOf(Technique::Geometry));
    row.name = "stubble", row.label = "Stubble", row.help = "blades near the eye and nothing beyond";
    row.color = 0x123456;
    row.tiers = nearTiers;
    return row;
}

// The technique comes before the editor that reads the table.
struct WithStubble {
    AddedTechnique added{stubble()};
};
class AddedTechniqueEditor : WithStubble, public EditorFixture {};

int run(std::vector<std::string> args) {
    args.insert(args.begin(), "sward");
    std::vector<char*> argv;
    for (std::string& a : args) argv.push_back(a.data());
    return runCommandLine(static_cast<int>(argv.size()), argv.data());
}

TEST_F(AddedTechniqueEditor, IsChosenInTheInspectorComparedWithAndExplained) {
    ok(ui->set("Inspector/lawn.GrassField.technique", "stubble"));
    EXPECT_EQ(field("lawn.GrassField.technique"), "stubble");
    ok(ui->wait(2));
    const std::string told = app->renderer->explain(doc.project(), false);
    EXPECT_NE(told.find("lawn is drawn by stubble"), std::string::npos) << told;
    ok(ui->set("Inspector/lawn.GrassField.technique", "hybrid"));
    ok(ui->set("Accuracy/Against", "stubble"));
    ok(ui->screenshot(dir / "shot.png"));
    EXPECT_EQ(app->accuracy.comparison.against, Against::Technique);
    ASSERT_TRUE(app->accuracy.comparison.metrics);
    EXPECT_GT(app->accuracy.comparison.metrics->appearance.distance, 0.001) << "most blades are missing";
    ok(ui->set("Accuracy/Against", "off"));
    ok(ui->wait(1));
}

TEST_F(AddedTechniqueEditor, IsDrawnByTheCommandLine) {
    ASSERT_TRUE(doc.save());
    const std::string project = doc.project().dir.string(), image = (dir / "stubble.png").string(),
                      all = (dir / "geometry.png").string();
    const auto draw = [&](const char* technique, const std::string& out) {
        return run({"render", project, "--technique", technique, "--size", "160x120", "--msaa", "1", "--out", out});
    };
    ASSERT_EQ(draw("stubble", image), 0);
    ASSERT_EQ(draw("geometry", all), 0);
    EXPECT_NE(readText(image), readText(all));
    EXPECT_EQ(draw("felt", image), 2);
}

}  // namespace
}  // namespace sward::test
