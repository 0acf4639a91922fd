// What the editor's viewport does not let one take: it is seen, but neither chosen there nor moved by handles.
// Does not: keep its fields from being edited; the outliner chooses it as any other.
#pragma once
#include <string>

#include "scene/project.h"
#include "scene/rows.h"

namespace sward {

struct Locked {};

const ComponentRow& lockedRow();
// Whether the entity of that name is there and has it.
bool isLocked(const Project& p, const std::string& entity);

}  // namespace sward
