// The tab Transitions: what pops along a camera's path, as a bar a step; a click takes the view there.
// Does not: measure (app/transition_run.h).
#pragma once
#include "app/edits.h"
#include "app/transition_run.h"
#include "app/viewport.h"

namespace sward {

struct TransitionParts {
    TransitionMeter& meter;
    const Document& doc;
    ViewState& view;
    Edits& edits;
};
// In what is left of the present window.
void drawTransitions(const TransitionParts& parts);

}  // namespace sward
