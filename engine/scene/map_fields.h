// The fields that stand beside a map in its struct (scene/map_row.h), found from the map itself: whether it is a
// component's own or lies in an element of a list. Does not: search by name, nor read files.
#pragma once
#include "maps/map_io.h"
#include "scene/project.h"

namespace sward {

// A field of the struct that the map lies in. `row`: of that struct's table, as MapRow names it.
FieldRef fieldBeside(const FieldRef& map, const FieldRow& row);
ConstFieldRef fieldBeside(const ConstFieldRef& map, const FieldRow& row);
// How often it repeats over Terrain.mapSize (scene/tiling.h); 1 if that is no setting of it.
float mapTiling(const ConstFieldRef& map);
// By what the map's file is read: as many channels, and not of 8 bits where it holds heights; in the file's own type.
MapWish mapWish(const FieldRow& map);

// What a new map is like that covers `metres` along its longer side: power-of-two sides, 256 to 4096.
MapInfo newMapInfo(const MapRow& row, double metres);

inline const MapField& mapOf(const ConstFieldRef& map) { return *static_cast<const MapField*>(map.value); }

}  // namespace sward
