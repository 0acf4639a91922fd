// Choosing how pixels come to their samples (scene/antialias.h), as edits of the document.
#pragma once
#include "model/document.h"
#include "scene/antialias.h"

namespace sward {

// By every Antialias of the project; where it has none and frames are to add up, by a new entity's. One undo step.
Status chooseAntialias(Document& doc, Antialiasing kind);

}  // namespace sward
