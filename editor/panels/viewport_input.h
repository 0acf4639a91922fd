// What the pointer and the keys do in the viewport: fly, look, orbit, pan, paint, choose and move objects, draw
// paths.
// Does not: draw.
#pragma once
#include <imgui.h>

#include <optional>

#include "accuracy/accuracy.h"
#include "app/edits.h"
#include "app/layout.h"
#include "app/messages.h"
#include "app/viewport.h"
#include "model/document.h"
#include "panels/viewport_objects.h"
#include "panels/viewport_rings.h"
#include "tools/brush_book.h"
#include "ui/input_queue.h"

namespace sward {

inline constexpr double kFirstMotion = 2;  // pixels until a click is a drag

// What painting and dragging touch; all must outlive the call.
struct PaintParts {
    Document& doc;
    BrushBook& brushes;
    Edits& edits;
    Messages& messages;
};
// What the hand may work on; all must outlive the call.
struct HandParts {
    PaintParts paint;
    const RingParts& rings;
    const ObjectParts& objects;
    Comparison& comparison;
};
// What came in. `over`: the pointer is over the image and nothing lies on top; `seconds` since the last frame.
struct HandInput {
    const FrameInput& in;
    double seconds;
    bool over;
};

// Once a frame, while nothing is played: begins, continues and ends what the hand does.
void viewportInput(const HandInput& input, FlyCamera& camera, ViewportHand& hand, const HandParts& parts);
// Once a frame, while it is played: nothing is flown or painted. True if a click in the picture asks for the mouse.
bool playInput(const HandInput& input, ViewportHand& hand);

// `view`: the image's rectangle, window coordinates. The ground under a place in the window; nothing beyond the terrain
// and in the sky.
std::optional<glm::dvec3> groundAt(const Document& document, const FlyCamera& camera, const Rect& view, double x,
                                   double y);
// The direction in which the eye sees a place in the window; a unit vector.
glm::dvec3 rayThrough(const FlyCamera& camera, const Rect& view, double x, double y);
// Where a world point is on the screen (window coordinates), or nothing if it lies behind the eye.
std::optional<glm::dvec2> projectPoint(const FlyCamera& camera, const Rect& view, const glm::dvec3& p);
inline ImVec2 vec(const glm::dvec2& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

}  // namespace sward
