// Fields that stood in another component in the first form of project files: such files are brought up to date when
// they are read (project/project_upgrades.cpp), and PATHs of that form go on naming the fields
// (scene/project_fields.cpp). Does not: convert values; a field keeps its name, its type and its entity.
#pragma once
#include <span>
#include <string_view>

namespace sward {

struct MovedField {
    const char* component;  // that had it
    const char* field;
    const char* to;  // component that has it now
};
std::span<const MovedField> movedFields();
// The component that has `field` now; null if it never stood in `component`.
const char* movedTo(std::string_view component, std::string_view field);

}  // namespace sward
