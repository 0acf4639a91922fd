#include "grass/drawing.h"

#include "scene/field_rows.h"

namespace sward {

ComponentRow grassDrawingRow() {
    static constexpr FieldRow kFields[] = {
        choice("transparency", &GrassDrawing::transparency, offsetof(GrassDrawing, transparency), kTransparencies,
               "how part-covered pixels are drawn (figure 21)"),
        choice("culling", &GrassDrawing::culling, offsetof(GrassDrawing, culling), kCullings,
               "who chooses the cells of which blades are drawn: the CPU, or the GPU; auto: what is faster here. The "
               "picture is the same"),
        real("fade", offsetof(GrassDrawing, fade), "", kShare,
             "half the width of the opacity ramp over density; 0: a step"),
        whole("shadowMask", offsetof(GrassDrawing, shadowMask), "texels", {0, 1024, 0, 256},
              "width of the mask by which blades shade blades; 0: they do not"),
        flag("groundShadows", offsetof(GrassDrawing, groundShadows), "blades shade the ground"),
        choice("bakeLight", &GrassDrawing::bakeLight, offsetof(GrassDrawing, bakeLight), kBakeLights,
               "how blades light each other: local: by shadow mask and depth alone; traced: with light from blade to "
               "blade, traced once a species"),
    };
    ComponentRow row =
        settingsRow<GrassDrawing>("GrassDrawing", "How blades and their images are drawn.", kFields, "GrassField");
    row.readByTruth = true;
    return row;
}

}  // namespace sward
