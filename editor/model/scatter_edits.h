// A new Scatter, and one made into entities. Each call is one undo step, or changes nothing.
// Does not: say where objects stand (world/scatter.h).
#pragma once
#include <span>
#include <string>
#include <vector>

#include "model/document.h"

namespace sward {

inline constexpr size_t kMostObjectsMade = 200;

// A new entity with a Scatter of the meshes that these entities show, of all that the project has where they show none.
// Its name. Failed error if there is no mesh.
Result<std::string> addScatter(Document& document, std::span<const std::string> like);
// An entity with a StaticMesh for each object of the entity's Scatter, which is removed, and the entity with it where
// it has nothing else. The new names. Usage error if it has no Scatter; Failed if it has none or more than
// kMostObjectsMade.
Result<std::vector<std::string>> makeObjectsOf(Document& document, const std::string& entity);

}  // namespace sward
