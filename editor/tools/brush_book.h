// The brush's settings, one set for each tool and map, so that what is set for one never leaks into another; a colour
// for each map, since tools take turns with it. Does not: paint.
#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "brushes/brush.h"

namespace sward {

inline constexpr const char* kViewTool = "select";  // no painting: the left button chooses objects

struct BrushBook {
    std::string tool = "add";         // kViewTool or the name of a brush row
    std::string map;                  // canonical PATH of the map painted on; empty: the project has none
    MapKind kind = MapKind::Amounts;  // of that map
    std::map<std::pair<std::string, std::string>, BrushSettings> settings;  // by tool and map
    std::vector<std::string> recentMaps;                                    // chosen so far, the newest first
    std::map<MapKind, std::string> lastTool;                                // by the kind that it painted
    std::map<std::string, glm::vec3> colors;                                // by map, for all tools alike: sRGB
    std::vector<std::string> shapeFiles;    // that shapes were taken from, the newest first
    std::set<std::string> species;          // PATHs of densities that are painted with the chosen one of their field
    bool mirrorX = false, mirrorZ = false;  // strokes of any tool show again beyond the terrain's middle
    std::map<std::string, bool> overlays;   // by map: what the person chose
    std::string preview;                    // PATH of the layer whose amounts the overlay shows; empty: of none
    bool shiftErases = false;               // the preset of those who know Shift as eraser
};

// The present tool's settings for the present map; made from the defaults when first asked for.
BrushSettings& currentBrush(BrushBook& book);
// What tools lay on the present map, if it is one of colours; white when first asked for.
glm::vec3& currentColor(BrushBook& book);
// What a stroke begun with these modifiers paints: Ctrl inverts (add and subtract, raise and lower change places, set
// paints 0, imprint digs), Shift smooths (or subtracts, with the preset, but never ground), Ctrl+Shift subtracts; from
// what, tools/brush_target.h says.
BrushSettings strokeBrush(BrushBook& book, bool ctrl, bool shift);
// "#e5c81a", and back; nothing of what is no such text.
std::string colorText(const glm::vec3& color);
// With or without "#", in any case; six digits.
std::optional<glm::vec3> parseColor(const std::string& text);
// One press of a size or strength key.
void growBrush(BrushSettings& brush, int steps);        // a fifth each, within 0.05 to 500 m
void strengthenBrush(BrushSettings& brush, int steps);  // 0.1 each, within 0.05 to 1

}  // namespace sward
