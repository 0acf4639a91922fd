// Several edits of a document as one step that undo takes back whole.
#pragma once
#include <string>

#include "model/document.h"

namespace sward {

// All of `edit` (a call without arguments that gives a Status) as one step of this label; nothing if it fails.
template <class F>
Status inOneStep(Document& document, const std::string& label, const F& edit) {
    document.beginGroup(label);
    const Status done = edit();
    if (done)
        document.endGroup();
    else
        document.cancelGroup();
    return done;
}

}  // namespace sward
