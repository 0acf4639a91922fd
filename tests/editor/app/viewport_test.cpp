// The view goes to cameras of the project.
#include "app/viewport.h"

#include <gtest/gtest.h>

#include "model/document.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

TEST(ViewState, GoesToACameraByNameAndStaysForWhatIsNone) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    ASSERT_TRUE(doc.setField("camera.Camera.eye", "[1, 2, 3]"));
    FlyCamera view;
    EXPECT_TRUE(goToCamera(doc, "camera", view));
    EXPECT_EQ(view.eye, glm::dvec3(1, 2, 3));
    EXPECT_FALSE(goToCamera(doc, "ground", view)) << "no camera";
    EXPECT_FALSE(goToCamera(doc, "nobody", view));
    EXPECT_EQ(view.eye, glm::dvec3(1, 2, 3));
}

}  // namespace
}  // namespace sward
