// The viewport's picture: when it is drawn anew, how fine, and in how many parts.
// Does not: take input, nor put it on the screen.
#pragma once
#include "app/app.h"

namespace sward {

// Draws what is due. Afterwards viewport.picture holds the image to show, if viewport.hasImage.
void drawScene(EditorApp& app);
// True if the renderer is quick enough to draw the brush's decal anew with every motion of the pointer.
bool drawsDecal(const EditorApp& app);
void freePicture(Viewport& v);

}  // namespace sward
