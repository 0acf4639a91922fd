// Brushes: a pure function from a tile, a stamp and parameters to a tile; one row a mode. What moves ground from tile
// to tile (erode) is one from a map to a map. Does not: keep state, undo, or know the scene; strokes are turned into
// stamps by stampsAlong. Hard case T-7: zero radius paints nothing; a stroke of zero length is one stamp; zero strength
// is the identity.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "maps/map.h"
#include "scene/map_row.h"

namespace sward {

constexpr unsigned bitOf(MapKind kind) { return 1u << static_cast<unsigned>(kind); }
const char* kindName(MapKind kind);  // "amounts"

struct BrushShape;  // shape.h
// Which way a stamp turns its shape, on top of the brush's angle.
enum class ShapeTurn { Fixed, Random, Along };  // not at all; anew for each stamp; up goes the way of the stroke
// What imprint makes of the ground and the height that it brings.
enum class HeightBlend { Add, Maximum, Minimum, Replace };

struct BrushSettings {
    std::string map = "density";  // a map's PATH or an unambiguous tail of it
    std::string mode = "add";     // a row's name
    float radius = 1;             // metres
    float strength = 1;           // [0,1]: share of the full effect that a stamp has at its centre
    float value = 1;              // what set paints towards, and the most that noise does; of colours the opacity; of
                                  // heights metres: what a stamp raises, lowers or roughens at full strength, and what
                                  // flatten paints towards
    float falloff = 0.5f;         // 0: hard edge; 1: falls off from the centre
    float spacing = 0.1f;         // distance between stamps as a share of the diameter
    int seed = 0;                 // of noise
    float angleDeg = 0;           // of direction: where blades lean, clockwise from north (-z) seen from above
    glm::vec3 color{1};           // what is laid on maps of colours: sRGB in [0,1], as they hold it
    bool fromStart = true;        // flatten goes to the height where the stroke begins, not to the value
    float bumpSize = 0;           // metres of the widest bumps of noise on heights; 0: the radius
    float talusDeg = 35;          // the steepest slope that erode leaves standing
    float water = 0.5f;           // [0,1]: how much rain erode lets fall; 0: slopes only slide
    std::shared_ptr<const BrushShape> shape;  // whose light is a stamp's weight instead of the falloff; null: round
    ShapeTurn shapeTurn = ShapeTurn::Fixed;   // of each stamp
    float shapeAngleDeg = 0;                  // that the shape is turned, clockwise seen from above
    HeightBlend blend = HeightBlend::Add;     // of imprint
    float base = 0;                           // metres at which imprint puts black, if not fromStart
    bool mirrorX = false, mirrorZ = false;    // strokes show again on the other side of the terrain's middle
    // Of the map, filled in by who knows it:
    float low = 0, high = 1;  // limits of what is painted on float maps; integer maps keep [0,1]
    bool colours = false;     // its four channels are a colour and an opacity, not a force
    bool heights = false;     // it holds heights ...
    glm::dvec2 metres{0, 1};  // ... and a texel, as Map::at gives it, stands for x + y * texel metres
};

// In texels of the map; radiusX != radiusY where texels are not square.
struct Stamp {
    double x, y;
    double radiusX, radiusY;
    // Number of the stamp: it turns the rounding of integer maps, so that changes smaller than one of their steps add
    // up over stamps to what they would be without rounding. 0 rounds to nearest.
    uint32_t turn = 0;
    double headingX = 0, headingZ = 0;  // where the stroke goes, for comb and press; any length; none: nowhere yet
    // Texels beyond its edge as far as which texels of no opacity take a colour that is laid. Nothing is seen of that,
    // but filtering would mix what they held into the edge: a dark rim.
    double spread = 0;
    // From (x, y) to the other end of what it paints, and the heights in metres of both, for ramp; elsewhere nothing.
    double acrossX = 0, acrossY = 0;
    double beginHeight = 0, endHeight = 0;
    // Its shape is turned by `angle`, radians clockwise seen from above, and reaches as many radii out.
    double angle = 0, reach = 1;
    bool flipX = false, flipZ = false;  // it is the mirror image of another: what points turns round along x, along z
};
inline constexpr double kColourSpread = 8;  // as far as mip level 3 reaches

// The tiles that a stamp may change: [x0, x1[ by [y0, y1[; empty if it misses the map or paints nothing.
struct TileRange {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    // Tiles in it.
    size_t count() const { return size_t(x1 - x0) * size_t(y1 - y0); }
};
// Of a map of this shape.
TileRange stampTiles(const MapInfo& info, const Stamp& stamp);

struct BrushRow {
    const char* name;   // "add"
    const char* label;  // "Add"
    const char* help;
    // Reads `map` as it was before the stamp (smooth needs neighbours) and returns the new tile, or the old pointer if
    // nothing changed. Of maps with a number of channels that it does not paint every tile is returned as it is.
    // Settings that are not finite paint nothing. Integer maps stay in [0,1]; float maps in [low, high] where they are
    // painted.
    std::shared_ptr<const Tile> (*apply)(const Map& map, int tx, int ty, const Stamp& stamp,
                                         const BrushSettings& brush);
    unsigned kinds = 0;               // the maps that it paints: a sum of bitOf
    bool follows = false;             // paints the way the stroke goes: the first stamp waits until it goes somewhere,
                                      // or ends
    bool spans = false;               // one stamp a stroke, from its first point to its last, once it ends
    bool once = false;                // one stamp a stroke, where it begins
    bool levels = false;              // goes to a height: BrushSettings::fromStart
    const char* onHeights = nullptr;  // the brush that is meant where heights are painted by this name
    // Of brushes that move ground across tiles, whose apply is null: the stamp on the whole map. Otherwise as apply.
    void (*applyWhole)(Map& map, const Stamp& stamp, const BrushSettings& brush) = nullptr;
};
// Whether the brush paints maps of this kind.
bool paints(const BrushRow& row, MapKind kind);
// "press, smooth or subtract": the brushes that paint such maps.
std::string brushesFor(MapKind kind);
// All brushes, in the order of the tool strip.
std::span<const BrushRow> brushRows();
// By BrushRow::name; null if there is none.
const BrushRow* findBrush(const std::string& name);
// The one that this name means on maps of this kind: on heights add raises, subtract lowers and set flattens.
const BrushRow* findBrush(const std::string& name, MapKind kind);

// Stamp centres every `step` metres along a line of points (metres). `carry` is the distance from the first point to
// the first stamp: 0 at the start of a stroke, and left as it must be for a next piece that begins with the last point,
// so that a stroke cut into pieces gives the same stamps as a whole one. Without a positive finite step: one stamp.
std::vector<std::pair<double, double>> stampsAlong(std::span<const std::pair<double, double>> points, double step,
                                                   double& carry);

// Applies one stamp to every tile it touches, on all cores.
void applyStamp(Map& map, const BrushRow& row, const Stamp& stamp, const BrushSettings& brush);

}  // namespace sward
