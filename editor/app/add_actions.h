// The menu Add: whole things in one undo step, where one looks. Each is chosen then.
// Does not: add single components (tools/appear.h), nor objects and paths, which clicks place.
#pragma once
#include <string>

#include "app/messages.h"
#include "app/selection.h"
#include "app/waiting.h"
#include "model/document.h"
#include "tools/brush_book.h"
#include "world/view_camera.h"

namespace sward {

// A point light two metres over the ground in the middle of the view.
void addLamp(Document& document, const ViewCamera& view, Selection& selection, Messages& messages);
// A camera that sees what is seen now.
void addCamera(Document& document, const ViewCamera& view, Selection& selection, Messages& messages);
// Flowers that grow nowhere yet; the brush is on their density.
void addFlowers(Document& document, Selection& selection, BrushBook& brushes, Messages& messages);
// A forest without a tree yet; the brush is on its density.
void addForest(Document& document, Selection& selection, BrushBook& brushes, Messages& messages);
// A hollow in the ground in the middle of the view, bare below the waterline, with water in it; where the scene has
// water, the hollow reaches below its level. Without ground there, it says so.
void addPond(Document& document, Waiting& waiting, const ViewCamera& view, Selection& selection, Messages& messages);

// What has been added with a density is what the brush paints next. `owner`: PATH of a component or of an element.
void paintNew(const Document& document, BrushBook& brushes, const std::string& owner);

}  // namespace sward
