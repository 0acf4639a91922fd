// An image for blades of one colour, for tests of rays.
#pragma once
#include <filesystem>
#include <string>

#include "core/error.h"
#include "maps/map_io.h"
#include "tests/support.h"

namespace sward::test {

inline const TempDir& folder() {
    static const TempDir dir;
    return dir;
}
// An image of one opaque grey of reflectance 1/2, which shaders double: what it covers is all there, in its own colour.
inline std::string plainImage() {
    const std::string name = "plain.png";
    if (!std::filesystem::exists(folder() / name)) CHECK(writeImagePng(folder() / name, 1, 1, 4, {188, 188, 188, 255}));
    return name;
}

}  // namespace sward::test
