// One row of the inspector for each type of field.
// Does not: change the value; edits are deferred to Document::setField, and refusals shown under the field.
#pragma once
#include "panels/field_edit.h"

namespace sward {

// Label (dim at its default; click: back to it), value, and what was wrong with the value last typed.
void drawField(const FieldParts& parts, const ConstFieldRef& field, const void* fallback);
// "bladesPerM2" -> "Blades per m2"; units of a name are left out: they stand beside the number.
std::string fieldTitle(const std::string& name);
// One element of a list by the list's name: "meshes" -> "Mesh", "species" -> "Species".
std::string elementTitle(const std::string& list);

}  // namespace sward
