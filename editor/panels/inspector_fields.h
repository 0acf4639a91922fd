// One row of the inspector for each type of field.
// Does not: change the value; edits are deferred to Document::setField, and refusals shown under the field.
#pragma once
#include "app/app.h"

namespace sward {

// Label (dim at its default; click: back to it), value, and what was wrong with the value last typed.
void drawField(EditorApp& app, const ConstFieldRef& field, const void* fallback);
// "bladesPerM2" -> "Blades per m2"; units of a name are left out: they stand beside the number.
std::string fieldTitle(const std::string& name);

}  // namespace sward
