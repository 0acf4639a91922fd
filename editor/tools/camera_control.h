// The viewport's own camera: flown, orbited, moved to a point. Pure: no window, no project.
// Does not: collide with the ground.
#pragma once
#include <glm/glm.hpp>

#include "frame/renderer.h"
#include "world/view_camera.h"

namespace sward {

struct FlyCamera {
    glm::dvec3 eye{0, 2, 0};
    double yaw = 0;        // radians, clockwise from -z (north) seen from above
    double pitch = 0;      // radians, up positive, within +-89 degrees
    double speed = 5;      // metres per second
    double distance = 10;  // to the point that orbits turn about, along the view
    float fovDeg = 55;
    float exposure = 0;
};

// Stands and looks as the view does; the pivot is the view's target.
FlyCamera flyFrom(const ViewCamera& view);
// Its target is the pivot.
ViewCamera viewOf(const FlyCamera& c);
// Where it looks; a unit vector.
glm::dvec3 forwardOf(const FlyCamera& c);
// What orbits turn about: `distance` ahead of the eye.
glm::dvec3 pivotOf(const FlyCamera& c);

// Turns by a motion of the pointer in pixels: right is right, down is down.
void look(FlyCamera& c, double dx, double dy);
// Turns about the pivot, which stays where it is on the screen.
void orbit(FlyCamera& c, double dx, double dy);
// Moves by `direction` (right, up, forward; each -1..1) for some seconds at the camera's speed.
void fly(FlyCamera& c, glm::dvec3 direction, double seconds);
// Wheel while flying: each notch is a fifth more or less, within 0.1 to 500 m/s.
void changeSpeed(FlyCamera& c, double notches);
// Wheel otherwise: a tenth of the distance to `target` a notch, never past it.
void dolly(FlyCamera& c, glm::dvec3 target, double notches);
// Drags the scene with the pointer: `height` is the viewport's, in pixels.
void pan(FlyCamera& c, double dx, double dy, double height);
// Looks at a point along the present direction, from `distance` metres.
void focus(FlyCamera& c, glm::dvec3 point, double distance);

}  // namespace sward
