// What the map calls share: finding a map, its extent in metres, its channels and values from Lua, and giving it back.
#pragma once
#include "script/map_ops.h"
#include "script/map_shapes.h"
#include "script/state.h"

namespace sward::script {

// A present map by its PATH or an unambiguous tail of it, as a copy to work on (it shares its tiles).
struct NamedMap {
    ConstFieldRef field;
    Map map;
    double width = 0, depth = 0;             // metres that it covers once
    bool repeats = false, mirrored = false;  // MapScale
};
NamedMap mapArg(lua_State* L, int arg);
// The same, only to be read, until the next call: as long as nothing was edited the same name costs no search.
const NamedMap& readMapArg(lua_State* L, int arg);
// One undo step.
void giveBack(lua_State* L, const NamedMap& of, Map map, const std::string& label);
// Raises if a map of this size would exceed what the project's maps may take.
void checkMapBytes(lua_State* L, const MapInfo& info);
// Option "channels": numbers from 1; absent: all.
Channels channelsOption(lua_State* L, Options& options, const MapInfo& info);
// A number for every channel, or a table of one a channel. Finite.
std::array<float, 4> valueAt(lua_State* L, int index, int channels, const char* what);

}  // namespace sward::script
