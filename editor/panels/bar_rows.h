// Rows of a bar: a widget goes beside the last one, or on a new row where it does not fit; numbers with their captions.
// Does not: know what the bar is for.
#pragma once
#include "ui/widgets.h"

namespace sward::bar {

// Where the next widget goes.
struct Rows {
    float right;  // where the bar ends
    int count = 1;
};

// So many widths of the font's size.
float em(float ems);
// Beside the last widget, or on a new row if a caption and a widget of this width do not fit.
void next(Rows& rows, const char* label, float width);
// Dimmed text before a widget.
void caption(const char* text);
// A captioned slider with its tooltip; what was typed wrong is framed, and told instead.
void number(Rows& rows, const char* label, float& value, float width, const ui::NumberSpec& spec, const char* help);
ui::NumberSpec range(double softMin, double softMax, double hardMin, double hardMax, const char* unit = "");

}  // namespace sward::bar
