// Components as their field tables see them: compared, copied and searched for maps without knowing their types.
// Does not: parse paths or text (scene/project.h does).
#pragma once
#include <functional>
#include <optional>
#include <span>

#include "scene/project.h"
#include "scene/rows.h"

namespace sward {

// True if both maps have the same shape and texels; reads texels only where tile pointers differ.
bool sameTexels(const Map& a, const Map& b);
// True if two structs of the table's type agree in every field; maps by file and texels.
bool sameFields(std::span<const FieldRow> fields, const void* a, const void* b);
// Copies every field of the table; maps share their tiles.
void copyFields(std::span<const FieldRow> fields, void* to, const void* from);
// Calls f for each map field, those of list elements included.
void eachMap(std::span<const FieldRow> fields, const void* component, const std::function<void(const MapField&)>& f);
// The same entities, components, fields and unknown parts; folder and remembered imports do not count.
bool sameProject(const Project& a, const Project& b, std::span<const ComponentRow> rows);
// A copy without what Hidden entities have; nothing if none is hidden.
std::optional<Project> withoutHidden(const Project& p, std::span<const ComponentRow> rows);
// The component's value, or null: like row.get, for a project that is only read.
const void* componentOf(const Project& p, const std::string& entity, const ComponentRow& row);

}  // namespace sward
