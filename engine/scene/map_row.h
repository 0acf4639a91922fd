// What is known of a painted map beside its place in a struct: what its channels mean, how it lies on the terrain, and
// what a new one is like. Brushes, overlays, imports, packing and counting go by it, never by a field's name.
// Does not: hold texels (maps/map.h), nor any row; each stands beside its component's table.
#pragma once
#include "maps/map.h"

namespace sward {

struct FieldRow;

// What a map's channels mean to a brush and to the overlay.
enum class MapKind {
    Amounts,     // one channel: density, openness
    Directions,  // two: direction x, z about 0.5, its length the strength
    Forces,      // four: push x, z about 0.5, press; all times the fourth
    Colours,     // four: colour (sRGB) and opacity
    Heights,     // one: metres, never of 8 bits; mirrored where they repeat
};

// What the program does with amounts beyond reading them.
enum class MapRole {
    Plain,
    Density,  // where something grows: seen without an overlay, and what tools go to first
};

struct MapRow {
    MapKind kind = MapKind::Amounts;
    MapRole role = MapRole::Plain;
    int channels = 1;                 // wanted
    PixelType type = PixelType::U16;  // of a new one
    double texelsPerMetre = 4;        // of a new one, at least
    // Fields of the same struct; null where there is none.
    const FieldRow* tiling = nullptr;       // Float: repeats over Terrain.mapSize; null: it covers its extent once
    const FieldRow* heightRange = nullptr;  // Vec2: metres at 0 and at full scale of integers
    const FieldRow* bladesPerM2 = nullptr;  // Float: blades that a density of 1 stands for
    // Map of the component that holds the list in which this map is: it makes one image with it (project/packed_map.h).
    const FieldRow* packedWith = nullptr;
    const char* least = "0 bare";  // what the overlay's legend calls its ends; of colours, where they are clear
    const char* most = "1 full";
    bool onMesh = false;  // it lies on a mesh's texture coordinates, not on the terrain: brushes do not reach it
};

}  // namespace sward
