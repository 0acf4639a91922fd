// Two windows that leave the view free: what is wrong with the maps, and heights that are being placed.
// Does not: keep state (app/map_health_view.h, app/height_placing.h).
#pragma once
#include "app/height_placing.h"
#include "app/map_health_view.h"
#include "core/error.h"

namespace sward {

class Document;
struct Edits;
struct FlyCamera;
struct Messages;

// Looks through all maps now; then the window is open.
void checkMaps(MapHealthView& view, const Document& document);
// While it is open: a line for each finding; a click moves the view to where it is worst.
void drawMapHealth(MapHealthView& view, const Document& document, FlyCamera& camera, Edits& edits);

// Begins to place a file over the middle half of the terrain. Errors as readHeights; usage without a terrain.
Status beginPlacing(HeightPlacing& placing, const Document& document, const std::string& file, bool flipX, bool flipZ);
// While a file is being placed: its rectangle and heights, Accept and Cancel.
void drawHeightPlacing(HeightPlacing& placing, Document& document, Edits& edits, Messages& messages);

}  // namespace sward
