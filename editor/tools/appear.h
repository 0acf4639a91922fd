// New things appear where one looks: where the middle of the view meets the ground.
// Does not: draw, or know panels.
#pragma once
#include <string>

#include "model/document.h"
#include "world/view_camera.h"

namespace sward {

// Adds a component with its defaults, as one undo step. A Transform stands on the ground in the middle of the view,
// water reaches as high as the ground there, unless that is sky. A StaticMesh that comes to a Transform stays where
// that is: on the ground it counts its height from there. A camera sees what is seen now. A light is a lamp where there
// is a sun, 2 m above the ground without an object. What grows grows nowhere until it is painted.
Status addInView(Document& document, const ViewCamera& view, const std::string& entity, const std::string& component);

}  // namespace sward
