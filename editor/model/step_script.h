// An undo step as calls of a script that make the same changes (docs/scripting.md), found by comparing what its
// components were and are, field by field. Does not: know strokes (model/recorder.h), nor run anything.
#pragma once
#include <string>
#include <vector>

#include "model/document.h"

namespace sward {

struct StepScript {
    std::vector<std::string> calls;  // in order; none: nothing can be said
    std::vector<std::string> left;   // what no call does, in words: texels that were made by other means
    std::vector<std::string> files;  // in the project's folder, that the calls name and do not bring along
};
StepScript scriptOf(const UndoStep& step);

// As Lua writes it: numbers by their shortest digits, infinity as math.huge, text in quotes.
std::string luaText(const std::string& text);
// The value of a field; of a list a table of tables. Maps are left out of tables.
std::string luaValue(const FieldRow& field, const void* value);

}  // namespace sward
