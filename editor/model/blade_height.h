// Heights of blades made from where grass grows: the density, blurred, so that grass is lower towards its edges
// (Jahrmann and Wimmer 2013, section 4.1.1). Does not: ask which density; `density` is the PATH of a species' map, such
// as the one that is painted.
#pragma once
#include "model/document.h"

namespace sward {

// Replaces the field's bladeHeight, which then repeats as the density does; one undo step. The blur reaches over twice
// the species' height. Usage error if `density` is no density map or is absent.
Status heightFromDensity(Document& document, const std::string& density);

}  // namespace sward
