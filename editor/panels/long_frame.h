// A bar at the viewport's foot where all blades would take too long: what it would take, and the ways out.
#pragma once
#include "app/edits.h"
#include "app/layout.h"
#include "app/long_frame.h"
#include "app/messages.h"
#include "model/document.h"

namespace sward {

struct LongFrameParts {
    LongFrame& frame;
    Document& doc;
    Edits& edits;
    Messages& messages;
};
// Within `view`. Nothing where no frame is long.
void drawLongFrame(const LongFrameParts& parts, const Rect& view);
// Gives the slowest field the technique that draws this view soonest, in one undo step, and says so.
void takeQuicker(const LongFrameParts& parts);

}  // namespace sward
