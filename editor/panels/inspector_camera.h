// What the inspector has for cameras beside their fields: to and from the view.
#pragma once
#include "app/app.h"

namespace sward {

// Below the fields of a Camera or CameraPath of the chosen entity; nothing for other components.
void drawCameraTools(EditorApp& app, const ComponentRow& row, const void* component);

}  // namespace sward
