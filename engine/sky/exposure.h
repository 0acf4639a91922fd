// How bright light comes out: from the units of photometry to the renderer's.
#pragma once

namespace sward {

inline constexpr float kPi = 3.14159265358979f;
// From kcd/m2 to the renderer's unit at exposure 0: level white ground under a clear 45-degree sun comes out near 3.5,
// which puts a sunlit lawn in the middle of the screen's range, as a camera's meter would.
inline constexpr float kExposure = 0.14f;

}  // namespace sward
