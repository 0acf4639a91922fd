// How widgets change fields: after the frame, refusals at the widget's label, a drag in one step.
#include "panels/field_edit.h"

#include "editor/panels/panel_stage.h"

namespace sward {
namespace {

constexpr const char* kFov = "camera.Camera.fovDeg";

class FieldEdit : public test::PanelStage {};

TEST_F(FieldEdit, AFieldIsSetOnceTheWidgetsAreBuilt) {
    setField(fieldParts(), kFov, "40", "Panel/fov");
    EXPECT_NE(field(kFov), "40");
    runDeferred(edits);
    EXPECT_EQ(field(kFov), "40");
    EXPECT_TRUE(book.errors.empty());
}

TEST_F(FieldEdit, ARefusalStandsAtTheLabelWithoutThePathUntilTheNextValueIsTaken) {
    setField(fieldParts(), kFov, "500", "Panel/fov");
    runDeferred(edits);
    ASSERT_TRUE(book.errors.contains("Panel/fov"));
    EXPECT_EQ(book.errors["Panel/fov"].find(kFov), std::string::npos) << book.errors["Panel/fov"];
    EXPECT_FALSE(doc.canUndo());
    setField(fieldParts(), kFov, "50", "Panel/fov");
    runDeferred(edits);
    EXPECT_FALSE(book.errors.contains("Panel/fov"));
}

TEST_F(FieldEdit, ADragOfManyValuesIsOneUndoStep) {
    const std::string before = field(kFov);
    const auto f = findField(doc.project(), doc.tables().components, kFov);
    ASSERT_TRUE(f);
    for (const double value : {41.0, 42.0, 43.0}) {
        takeEdit(fieldParts(), *f, {.changed = true}, value, "Panel/fov");
        runDeferred(edits);
        releaseGroup(edits, doc, true);
    }
    EXPECT_EQ(edits.holding, kFov);
    releaseGroup(edits, doc, false);
    EXPECT_EQ(field(kFov), "43");
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(field(kFov), before);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(FieldEdit, ANumbersWidgetHasTheRowsRangesAndUnit) {
    const auto f = findField(doc.project(), doc.tables().components, kFov);
    ASSERT_TRUE(f);
    const ui::NumberSpec spec = numberSpec(*f->row);
    EXPECT_EQ(spec.hardMin, f->row->hardMin);
    EXPECT_EQ(spec.hardMax, f->row->hardMax);
    EXPECT_EQ(spec.softMax, f->row->softMax);
    EXPECT_EQ(spec.unit, f->row->unit);
    EXPECT_FALSE(spec.integer);
}

}  // namespace
}  // namespace sward
