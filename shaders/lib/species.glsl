// What blades of the species that is drawn have in common.
#include "shared/bindings.h"
#include "shared/grass.h"

layout(std140, binding = UBO_SPECIES) uniform SpeciesBlock { SpeciesGlobals species; };
