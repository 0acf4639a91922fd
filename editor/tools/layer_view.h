// What the Layers panel keeps between frames. Does not: change the project (model/layer_edits.h).
#pragma once
#include <string>

namespace sward {

struct LayerView {
    std::string file;   // typed to be imported into an image layer
    bool flip = false;  // its first row is z = max
};

}  // namespace sward
