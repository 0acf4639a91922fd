// What the pointer and the keys do in the viewport: fly, look, orbit, pan, paint.
// Does not: draw.
#pragma once
#include "app/app.h"

namespace sward {

// `over`: the pointer is over the image and nothing lies on top. Once a frame.
void viewportInput(EditorApp& app, bool over);
// The ground under a place in the window; nothing beyond the terrain and in the sky.
std::optional<glm::dvec3> groundAt(const EditorApp& app, double x, double y);
// The direction in which the eye sees a place in the window; a unit vector.
glm::dvec3 rayThrough(const Viewport& v, double x, double y);
// Where a world point is on the screen (window coordinates), or nothing if it lies behind the eye.
std::optional<glm::dvec2> projectPoint(const Viewport& v, const glm::dvec3& p);

}  // namespace sward
