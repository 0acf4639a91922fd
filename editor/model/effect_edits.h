// Turning an effect off in a document: what the effect map offers for those that cost more than they show.
// Does not: measure (cost/effect_probe.h).
#pragma once
#include "model/document.h"
#include "scene/features.h"

namespace sward {

// Sets all that the table of switches names for this feature (cost/feature_switch.h), as one undo step. Fails, with
// nothing changed, if the project does not ask for it, or if it cannot be left out.
Status turnOff(Document& document, Feature feature);

}  // namespace sward
