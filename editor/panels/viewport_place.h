// An object of the project's folder in the hand: each click on the ground places a new entity that shows it.
// Does not: know which objects there are (model/assets.h), or list them (panels/assets.cpp).
#pragma once
#include "panels/viewport_objects.h"

namespace sward {

// On the ground under a place in the window, as one undo step; the new entity is chosen. False: there is no ground.
bool placeObject(const ObjectParts& parts, double x, double y);
// Its box where a click would place it.
void drawPlacing(const ObjectParts& parts, const std::optional<glm::dvec3>& ground);

}  // namespace sward
