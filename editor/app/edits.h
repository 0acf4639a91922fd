// Edits that widgets ask for while a frame is built: they run once all widgets are there, since they may remove what is
// being drawn; and the undo group that a slider holds while it is dragged.
// Does not: change anything itself; the edits go through Document.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace sward {

class Document;

struct Edits {
    std::vector<std::function<void()>> deferred;  // in the order in which they were asked for
    std::string holding;                          // path whose slider or ring holds an undo group; empty: none
};

// Runs what was asked for. What the edits themselves defer waits for the next call.
void runDeferred(Edits& edits);
// Ends a held undo group once nothing is held any more (`active`: a widget still is), whatever became of the slider.
void releaseGroup(Edits& edits, Document& document, bool active);

}  // namespace sward
