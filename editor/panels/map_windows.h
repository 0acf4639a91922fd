// Two windows that leave the view free: what is wrong with the maps, and heights that are being placed.
// Does not: keep state (app/map_health_view.h, app/height_placing.h).
#pragma once
#include <functional>
#include <string>

#include "app/height_placing.h"
#include "app/map_health_view.h"
#include "core/error.h"

namespace sward {

class Document;
struct Edits;
struct FlyCamera;
struct Messages;
struct Waiting;

// Has all maps looked through; then the window is open.
void checkMaps(MapHealthView& view, const Document& document, Waiting& waiting);
// While it is open: a line for each finding; a click moves the view to where it is worst.
void drawMapHealth(MapHealthView& view, const Document& document, FlyCamera& camera, Edits& edits, Waiting& waiting);

// Begins to place a file over the middle half of the terrain. `then` gets errors as of readHeights; usage without a
// terrain.
void beginPlacing(HeightPlacing& placing, const Document& document, Waiting& waiting, const std::string& file,
                  bool flipX, bool flipZ, std::function<void(const Status&)> then);
// While a file is being placed: its rectangle and heights, Accept and Cancel.
void drawHeightPlacing(HeightPlacing& placing, Document& document, Edits& edits, Messages& messages, Waiting& waiting);

}  // namespace sward
