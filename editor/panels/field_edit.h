// How widgets change fields of the document: after the frame's widgets, refusals beside the widget, a drag one step.
// Does not: draw the widgets.
#pragma once
#include "app/app.h"

namespace sward {

// Sets a field once this frame's widgets are built; what is wrong with the text stands at the widget's label
// ("Inspector/lawn.GrassField.maxGeom").
void setField(EditorApp& app, const std::string& path, const std::string& text, const std::string& label);
// All that follows until nothing is held any more is one undo step.
void holdEdit(EditorApp& app, const std::string& path);
ui::NumberSpec numberSpec(const FieldRow& row);
// What a number's widget gave: a drag is held and set, a typed text set.
void takeEdit(EditorApp& app, const ConstFieldRef& field, const ui::NumberEdit& edit, double value,
              const std::string& label);

// A row of a table of two columns: its name, told about by a tooltip, and room for a widget across the second.
void caption(const char* text, const char* help);

}  // namespace sward
