// Whole entities: copied, named anew, removed, hidden, locked. Each call is one undo step, or changes nothing.
// Does not: know which are chosen (app/selection.h).
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "model/document.h"

namespace sward {

// A name that no entity has: `like` itself, or with the next free number at its end, as wide as the one it has:
// "bench", "bench-2"; "tree-09", "tree-10". What a name may not hold is left out of `like`; nothing left: "object".
std::string freeName(const Project& p, const std::string& like);

// Copies with all components, beside the originals in the order of the arguments; maps share their texels until one is
// painted. The copies' names.
Result<std::vector<std::string>> duplicateEntities(Document& document, std::span<const std::string> names);
// Every field that names it (FieldRow::isEntity) follows, and so do remembered imports of its maps. Usage error if the
// name is taken or none, or if the entity holds parts of the file that this version does not know: they go by its name.
Status renameEntity(Document& document, const std::string& from, const std::string& to);
// Usage error naming an entity that is not there.
Status removeEntities(Document& document, std::span<const std::string> names);
// Adds Hidden to all of them, or takes it from those that have it.
Status hideEntities(Document& document, std::span<const std::string> names, bool hidden);
// The same with Locked.
Status lockEntities(Document& document, std::span<const std::string> names, bool locked);

}  // namespace sward
