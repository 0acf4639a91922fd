// How widgets change fields of the document: after the frame's widgets, refusals beside the widget, a drag one step.
// Does not: draw the widgets.
#pragma once
#include <functional>
#include <string>

#include "app/edits.h"
#include "app/messages.h"
#include "model/document.h"
#include "ui/widgets.h"

namespace sward {

struct BrushBook;
struct FileDialog;
struct ImageDialog;
struct Thumbnails;
struct Waiting;

// What widgets change fields with; all must outlive the edits that they defer.
struct FieldParts {
    Document& doc;
    Edits& edits;
    ui::Errors& errors;
    Messages& messages;
    // Of fields that hold maps or name files; null: those show no picture, and have no buttons.
    Thumbnails* thumbnails = nullptr;
    FileDialog* files = nullptr;
    ImageDialog* images = nullptr;
    BrushBook* brushes = nullptr;
    Waiting* waiting = nullptr;
};

// Sets a field once this frame's widgets are built; what is wrong with the text stands at the widget's label
// ("Inspector/lawn.GrassField.maxGeom").
void setField(const FieldParts& parts, const std::string& path, const std::string& text, const std::string& label);
// All that follows until nothing is held any more is one undo step.
void holdEdit(const FieldParts& parts, const std::string& path);
// What a number's widget gave: a drag is held and set, a typed text set.
void takeEdit(const FieldParts& parts, const ConstFieldRef& field, const ui::NumberEdit& edit, double value,
              const std::string& label);
// Runs an edit of the document once this frame's widgets are built, and shows why if it fails.
void deferEdit(const FieldParts& parts, std::function<Status()> edit);
// How a field's number is edited: the ranges and the unit of its row.
ui::NumberSpec numberSpec(const FieldRow& row);

// A row of a table of two columns: its name, told about by a tooltip, and room for a widget across the second.
void caption(const char* text, const char* help);

}  // namespace sward
