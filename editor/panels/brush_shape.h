// What the brush bar has for a brush's shape, for imprint, for several species at once and for mirrored strokes.
// Does not: paint.
#pragma once
#include <functional>
#include <string>

#include "brushes/shape.h"
#include "panels/bar_rows.h"

namespace sward {

class Document;
struct BrushBook;
struct Edits;
struct ImageDialog;
struct Messages;
struct Waiting;

// What choosing a shape touches; all must outlive the edits that it defers.
struct ShapeParts {
    const Document& doc;
    Edits& edits;
    Messages& messages;
    ImageDialog& images;
    Waiting& waiting;
};

// The shape of the present tool's brush: round, one that is made here, one of a file; and how it is turned.
void shapeWidgets(bar::Rows& rows, BrushBook& brushes, const ShapeParts& parts);
// Takes the shape from a file for the present tool, and remembers it; `then` gets errors as of loadShape.
void takeShape(Waiting& waiting, BrushBook& brushes, const std::string& file, std::function<void(const Status&)> then);
// Height, blend and base of imprint.
void imprintWidgets(bar::Rows& rows, BrushSettings& brush);
// Ticks for the species of the field whose density is painted, where it has several.
void speciesWidgets(bar::Rows& rows, const Document& document, BrushBook& brushes);
// Off, across x, across z, or both.
void mirrorWidget(bar::Rows& rows, BrushBook& brushes);

}  // namespace sward
