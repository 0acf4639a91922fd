// Integer heights made floats: metres, which have no range that ends. Does not: change a height by more than a float's
// rounding, nor the heightRange, which floats do not read.
#pragma once
#include "model/document.h"

namespace sward {

// The heights of the scene's terrain, as one undo step. Usage error if there is no terrain, no map of heights, or it
// holds floats already.
Status heightsAsFloats(Document& document);

}  // namespace sward
