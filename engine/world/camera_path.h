// Where a camera is on its way.
// Between keys eye, target and view angle follow cubic Hermite curves whose slope at a key is that of the parabola
// through it and both neighbours (Overhauser 1968, with the keys' own seconds): every key is met, and nothing jumps,
// whatever their spacing. Keys of the same second are a cut: from it on, the last of them counts. Does not: keep the
// eye above the ground.
#pragma once
#include "scene/components.h"
#include "scene/ground_path.h"
#include "world/ground.h"

namespace sward {

// The camera `seconds` after the path's beginning; before its first key and after its last it stands there. Needs a
// key.
Camera cameraOn(const CameraPath& path, double seconds);
// The second of the last key; 0 without keys.
double secondsOf(const CameraPath& path);

// The way along a path on the ground, `eyeHeight` metres above it and at `speed` metres a second, looking some metres
// ahead. Keys stand 1.5 m apart, on a long path farther: 400 at most; so also between them the eye follows the ground.
// No key: the path has no length.
CameraPath cameraAlong(const GroundPath& path, const Ground& ground, double eyeHeight, double speed);

}  // namespace sward
