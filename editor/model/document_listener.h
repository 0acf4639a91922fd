// What a document tells of its edits while they are made, for who writes them down (model/recorder.h).
// Does not: change anything; a listener only reads.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "brushes/brush.h"

namespace sward {

struct UndoStep;

// A stroke as the hand made it.
struct StrokeNews {
    std::vector<BrushSettings> brushes;  // one a map
    bool create = false;                 // maps that were not there were made
    uint32_t turn = 0;                   // that its rounding began with (brushes/brush.h, Stamp)
    std::vector<glm::dvec2> points;      // metres
};

struct DocumentListener {
    virtual ~DocumentListener() = default;
    // A step was made. `stroke`: it is that stroke and nothing else; null: other edits.
    virtual void madeStep(const UndoStep& step, const StrokeNews* stroke) = 0;
    // The last step was taken back, or brought again.
    virtual void wentBack() = 0;
    virtual void wentForward() = 0;
    // Another project is open now.
    virtual void tookOther() = 0;
};

}  // namespace sward
