#include "app/edits.h"

#include "model/document.h"

namespace sward {

void runDeferred(Edits& edits) {
    std::vector<std::function<void()>> due;
    due.swap(edits.deferred);
    for (const auto& edit : due) edit();
}

void releaseGroup(Edits& edits, Document& document, bool active) {
    if (edits.holding.empty() || active) return;
    edits.holding.clear();
    document.endGroup();
}

}  // namespace sward
