// The red bar over the viewport.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, AnErrorStandsOverTheViewportUntilDismissed) {
    showError(app->messages, failed("the disk is full", "free some space").at("maps/a.png"));
    EXPECT_NE(get("Viewport/Error").find("disk is full"), std::string::npos);
    ok(ui->click("Viewport/Dismiss"));
    EXPECT_FALSE(ui->exists("Viewport/Error"));
}

}  // namespace
}  // namespace sward
