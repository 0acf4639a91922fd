// The inspector's fields that hold a painted map or name a file: a picture of it, and how another comes in.
// Does not: read files (model/map_import.h).
#pragma once
#include "panels/field_edit.h"

namespace sward {

// Picture and size of a map, with the buttons "PATH/Import", "PATH/Fill" (with what the brush lays) and "PATH/Export".
void drawMapField(const FieldParts& parts, const ConstFieldRef& field);
// Picture and name of a file, which can be typed, with the button "PATH/Browse". The parts have files and thumbnails.
void drawFileField(const FieldParts& parts, const ConstFieldRef& field);

}  // namespace sward
