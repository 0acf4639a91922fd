// What the map calls share: finding a map, its extent in metres, its channels and values from Lua, and giving it back.
#pragma once
#include "script/map_ops.h"
#include "script/map_shapes.h"
#include "script/state.h"

namespace sward::script {

// What a map's numbers are to a script: those that it holds, but heights of integers, which are shares of heightRange,
// in metres, too.
struct MapUnits {
    double low = 0, scale = 1;  // value = low + scale * texel
    bool plain() const { return low == 0 && scale == 1; }
    double valueOf(double texel) const { return low + scale * texel; }
};
// Of texels of this type in a map field, with the range that it has now.
MapUnits unitsOf(const ConstFieldRef& field, PixelType type);
// The map in a script's numbers: itself where they are its own, else floats; and back. `before`: the map as it was
// where there was one; texels whose value is as it was keep theirs to the last bit, and tiles stay shared.
Map inUnits(const Map& map, const MapUnits& units);
Map fromUnits(const Map& values, const MapUnits& units, PixelType type, const Map& before = {});

// A present map by its PATH or an unambiguous tail of it, as a copy to work on (it shares its tiles).
struct NamedMap {
    ConstFieldRef field;
    Map map;     // in the script's numbers
    Map stored;  // as it is
    MapUnits units;
    double width = 0, depth = 0;             // metres that it covers once
    bool repeats = false, mirrored = false;  // MapScale
};
// The map that argument `arg` names, as a copy that shares its tiles. Raises if there is none, or nothing lies on a
// terrain.
NamedMap mapArg(lua_State* L, int arg);
// The same, only to be read, until the next call, and `map` as it is stored: as long as nothing was edited the same
// name costs no search.
const NamedMap& readMapArg(lua_State* L, int arg);
// Takes a map in the script's numbers. One undo step.
void giveBack(lua_State* L, const NamedMap& of, Map map, const std::string& label);
// Raises if a map of this size would exceed what the project's maps may take.
void checkMapBytes(lua_State* L, const MapInfo& info);
// Option "channels": numbers from 1; absent: all.
Channels channelsOption(lua_State* L, Options& options, const MapInfo& info);
// A number for every channel, or a table of one a channel. Finite.
std::array<float, 4> valueAt(lua_State* L, int index, int channels, const char* what);

}  // namespace sward::script
