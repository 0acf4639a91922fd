// The dialog that shows an image small before it is taken (app/image_tasks.h), and small pictures as such.
// Does not: read files.
#pragma once
#include <functional>
#include <optional>

#include "app/image_tasks.h"
#include "core/error.h"

namespace sward {

struct Edits;

// A picture at ImGui's cursor, its pixels as squares so that its longer side is `side` wide; recorded as "Preview".
void drawPreview(const ImagePreview& preview, float side, bool flipX, bool flipZ);
// Does what the dialog is for, and says then how it ended.
using TakeImage = std::function<void(const ImageDialog&, const std::function<void(const Status&)>& then)>;
// While a task is set. `take` runs later, with the edits; the dialog closes once that worked.
void drawImageDialog(ImageDialog& dialog, Edits& edits, const TakeImage& take);
// The two texts as a range; nothing if both are empty. Usage if they are no rising numbers.
Result<std::optional<std::pair<double, double>>> rangeOf(const std::string& low, const std::string& high);

}  // namespace sward
