// The tab Objects: what lies in models/, taken into the hand and laid down.
#include "app/thumbnails.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"
#include "tools/brush_book.h"
#include "tools/brush_target.h"
#include "tools/object_tool.h"

namespace sward {
namespace {

class AssetsPanel : public test::PanelStage {
  protected:
    AssetsPanel() {
        name = "Objects";
        draw = [this] { drawAssets(doc, brushes, objects, thumbnails, messages); };
    }
    BrushBook brushes;
    ObjectTool objects;
    Thumbnails thumbnails;
};

TEST_F(AssetsPanel, AClickTakesAnObjectIntoTheHandAndAnotherLaysItDown) {
    test::writeText(dir / "meadow/models/stones/rock.glb", "as a file alone");
    brushes.tool = "add";
    click("Objects/stones/rock.glb");
    EXPECT_EQ(objects.placing, "models/stones/rock.glb");
    EXPECT_EQ(brushes.tool, kViewTool) << "a brush would paint";
    click("Objects/stones/rock.glb");
    EXPECT_EQ(objects.placing, "");
    click("Objects/Random turn");
    EXPECT_TRUE(objects.randomTurn);
}

}  // namespace
}  // namespace sward
