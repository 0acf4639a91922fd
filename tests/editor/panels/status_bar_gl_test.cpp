// What is made beside the editor: its progress, and its end by Cancel.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, AmbientOcclusionIsBakedBesideTheEditorAndCanBeCancelled) {
    const test::EmptyCache cache;
    const auto baked = [&] { return field("lawn.GrassField.ambientOcclusion") != ""; };
    ok(ui->click("Menu/Bake/Ambient Occlusion"));
    ASSERT_TRUE(app->background.occlusion);
    EXPECT_TRUE(ui->exists("Status/Baking"));
    ok(ui->click("Status/Cancel"));
    for (int i = 0; i < 500 && app->background.occlusion; ++i) ok(ui->wait(1));
    EXPECT_FALSE(baked());
    EXPECT_NE(app->messages.notice.find("cancelled"), std::string::npos);
    app->messages.notice.clear();
    ok(ui->click("Menu/Bake/Ambient Occlusion"));
    waitUntil([&] { return !app->background.occlusion; });
    EXPECT_TRUE(baked());
    EXPECT_FALSE(ui->exists("Status/Baking"));
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(baked());
}

}  // namespace
}  // namespace sward
