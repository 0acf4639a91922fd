// The four distances of a hybrid field as rings on the ground, in the viewport: drawn, and dragged with the mouse.
// Does not: hold the maths (tools/rings.h, tools/tiers.h).
#pragma once
#include <imgui.h>

#include "app/app.h"

namespace sward {

inline constexpr ImU32 kTierColors[kTierCount] = {IM_COL32(255, 92, 80, 255), IM_COL32(255, 176, 60, 255),
                                                  IM_COL32(90, 170, 255, 255), IM_COL32(90, 225, 120, 255)};
inline constexpr const char* kTierTitles[kTierCount] = {"All blades up to", "Blades end at", "All slices up to",
                                                        "Slices end at"};

// The entity whose distances panel and rings show: the one chosen in the panel, the selected, or the first; "" if none
// has a GrassField.
std::string tierEntity(EditorApp& app);
const GrassField* tierField(EditorApp& app);
std::string tierPath(EditorApp& app, size_t i);  // "lawn.GrassField.maxGeom"

// --- once a frame, around the drawing of the image
void hoverRing(EditorApp& app, bool over);  // what the pointer is on, of the rings as last drawn
void drawRings(EditorApp& app);             // lays them anew, and draws them while the panel is in sight

// --- in the hand: one undo step from grab to release
bool grabRing(EditorApp& app);  // true if the pointer is on one and no modifier says otherwise
void dragRing(EditorApp& app, double x, double y);
void releaseRing(EditorApp& app);
void cancelRing(EditorApp& app);  // the distance is what it was

}  // namespace sward
