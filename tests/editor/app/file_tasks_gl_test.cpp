// Saving by its key, and what is on disk then.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, SavingAndReopeningFindsTheSamePaint) {
    ok(ui->click("Tools/Subtract"));
    paint();
    const uint64_t painted = density();
    ok(ui->key("ctrl+s"));
    EXPECT_EQ(get("Status/Saved"), "true");
    Document again(tables());
    ASSERT_TRUE(again.open(dir / "meadow"));
    const Result<ConstFieldRef> map = findMap(again.project(), tables().components, "density");
    ASSERT_TRUE(map);
    EXPECT_EQ(static_cast<const MapField*>(map->value)->map.hash(), painted);
}

}  // namespace
}  // namespace sward
