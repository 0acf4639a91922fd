// What the brush paints on: the chosen map, the tool that fits it, its overlay, and what a stroke will touch.
// A tool and a map always fit: choosing a map takes the tool last used on its kind, choosing a tool the map.
// Does not: paint; Document does.
#pragma once
#include "app/app.h"

namespace sward {

// Maps that brushes paint on, absent ones included; no heights.
std::vector<ConstFieldRef> paintableMaps(EditorApp& app);
// The chosen map, or nothing if the project has none.
std::optional<ConstFieldRef> chosenMap(EditorApp& app);
void selectMap(EditorApp& app, const std::string& path);
void selectTool(EditorApp& app, const std::string& tool);
void toggleLook(EditorApp& app);  // from looking back to the tool that painted last
// The brush takes the colour that the chosen map has under the pointer; where there is none, it says so.
void pickColor(EditorApp& app);
// After the project changed: the chosen map must be one that it has, the tool one that paints it.
void keepTargetValid(EditorApp& app);

// What a stroke begun with these modifiers paints, a brush for each map (tools/brush_book.h).
std::vector<BrushSettings> strokeBrushes(EditorApp& app, bool ctrl, bool shift);

// --- the overlay: on at first for what cannot be seen otherwise (directions, forces, openness), remembered for each
// map
bool overlayShown(EditorApp& app);
void toggleOverlay(EditorApp& app);
MapOverlay overlayOf(EditorApp& app);

}  // namespace sward
