// What the brush paints on: the chosen map, the tool that fits it, its overlay, and what a stroke will touch.
// A tool and a map always fit: choosing a map takes the tool last used on its kind, choosing a tool the map.
// Does not: paint; Document does.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/messages.h"
#include "frame/renderer.h"
#include "model/document.h"
#include "tools/brush_book.h"

namespace sward {

// Maps that brushes paint on, absent ones included. None without an open project.
std::vector<ConstFieldRef> paintableMaps(const Document& document);
// The chosen map, or nothing if the project has none.
std::optional<ConstFieldRef> chosenMap(const Document& document, const BrushBook& book);
// Chooses a map by its PATH, and the tool last used on its kind if the present one does not paint it. A path that is no
// map of the project chooses the one that keepTargetValid would.
void selectMap(const Document& document, BrushBook& book, const std::string& path);
// Chooses a tool by name or kViewTool, and a map that it paints if the present one is none; without any it says so and
// stays. Unknown names change nothing.
void selectTool(const Document& document, BrushBook& book, Messages& messages, const std::string& tool);
// From painting to looking, and back to the tool that painted last.
void toggleLook(const Document& document, BrushBook& book, Messages& messages);
// On a map of colours the brush takes the colour that it has at `ground`, the world point under the pointer; on heights
// flatten takes the height there. Where there is none, it says so.
void pickFromGround(const Document& document, BrushBook& book, Messages& messages,
                    const std::optional<glm::dvec3>& ground);
// After the project changed: the chosen map must be one that it has, the tool one that paints it.
void keepTargetValid(const Document& document, BrushBook& book);

// Densities of the species of the field whose density is chosen, by PATH; none where another kind of map is.
std::vector<std::string> speciesOfField(const Document& document, const BrushBook& book);
// The chosen map, and where that is a density those of the same field's species that are ticked (BrushBook::species).
std::vector<std::string> paintedMaps(const Document& document, const BrushBook& book);

// What a stroke begun with these modifiers paints, a brush for each map (tools/brush_book.h).
std::vector<BrushSettings> strokeBrushes(const Document& document, BrushBook& book, bool ctrl, bool shift);

// --- the overlay: on at first for what cannot be seen otherwise (directions, forces, openness), remembered for each
// map
bool overlayShown(const Document& document, const BrushBook& book);
// For the chosen map; remembered.
void toggleOverlay(const Document& document, BrushBook& book);
// What the renderer lays over the scene; nothing if it is off, or the map is absent and nothing presses.
MapOverlay overlayOf(const Document& document, const BrushBook& book);

}  // namespace sward
