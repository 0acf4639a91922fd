// Pictures side by side in a panel, each under its name, as large as all of them fit.
// Does not: make or keep them.
#pragma once
#include <vector>

namespace sward {

struct Texture;
struct StripPicture {
    const char* name;
    const Texture* picture;  // not made yet: left out
};
// Into what is left of the window. Rows of a picture count from its top.
void drawStrip(const std::vector<StripPicture>& pictures);

}  // namespace sward
