// How widgets change fields: a drag is one undo step.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, DraggingASliderIsOneUndoStep) {
    // Slices need not be baked anew for each place of the slider, as for shapes.
    const std::string path = "lawn.GrassField.species[lawn].gloss", label = "Inspector/" + path;
    ASSERT_TRUE(ui->exists(label));
    ASSERT_TRUE(ui->get(label));
    const std::string before = field(path);
    const ui::Widget w = app->book.widgets.at(label);
    const double y = static_cast<double>(w.y0 + w.y1) / 2;
    ok(ui->drag(static_cast<double>(w.x0) + 10, y, static_cast<double>(w.x1) - 10, y));
    EXPECT_NE(field(path), before);
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(field(path), before);
    EXPECT_FALSE(doc.canUndo());
}

}  // namespace
}  // namespace sward
