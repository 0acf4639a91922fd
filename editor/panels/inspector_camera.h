// What the inspector has for cameras beside their fields: to and from the view.
#pragma once
#include <string>

#include "app/viewport.h"
#include "panels/field_edit.h"

namespace sward {

// Below the fields of a Camera or CameraPath of an entity; nothing for other components. Moves the view, or defers
// edits that take it over; greyed while the project is played.
void drawCameraTools(const FieldParts& parts, ViewState& view, const std::string& entity, const ComponentRow& row,
                     const void* component);

}  // namespace sward
