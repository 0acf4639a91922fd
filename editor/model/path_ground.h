// The ground under a path made level across it: an edit of the terrain's heights, as a brush would make.
// Does not: follow the path afterwards; moved, it can be done again.
#pragma once
#include <string>

#include "core/error.h"
#include "model/document.h"

namespace sward {

// Heights along an entity's GroundPath become those under its curve, fully over its width and fading over its falloff;
// one undo step. The curve keeps the hills that it crosses. Usage error: no path with points, no map of heights or one
// that is mirrored.
Status flattenAlong(Document& document, const std::string& entity);

}  // namespace sward
