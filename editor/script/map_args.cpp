#include "script/map_args.h"

#include "maps/map_repair.h"
#include "scene/map_fields.h"

#include "tools/stroke.h"

namespace sward::script {

MapUnits unitsOf(const ConstFieldRef& field, PixelType type) {
    const FieldRow* range = field.row->map->heightRange;
    if (!range || type == PixelType::F32) return {};
    const glm::dvec2& metres = *static_cast<const glm::dvec2*>(fieldBeside(field, *range).value);
    return {metres.x, metres.y - metres.x};
}

Map inUnits(const Map& map, const MapUnits& units) {
    return units.plain() ? map : convertMap(map, PixelType::F32, std::pair(units.low, units.low + units.scale));
}

Map fromUnits(const Map& values, const MapUnits& units, PixelType type, const Map& before) {
    if (units.plain()) return values;
    const std::pair<double, double> range(units.low, units.low + units.scale);
    const Map texels = convertMap(values, type, range);
    if (before.empty()) return texels;
    const Map was = convertMap(before, PixelType::F32, range);
    Map out = before;
    for (int y = 0; y < values.info().height; ++y)
        for (int x = 0; x < values.info().width; ++x)
            if (values.at(x, y) != was.at(x, y)) out.set(x, y, 0, texels.at(x, y));
    return out;
}

namespace {
NamedMap storedMap(lua_State* L, int arg) {
    const Project& p = openProject(L);
    const ConstFieldRef field = orRaise(L, findMap(p, stateOf(L).rows(), textArg(L, arg)));
    const auto& value = *static_cast<const MapField*>(field.value);
    if (!value.present()) raise(L, usage(field.path + ": there is no map", "create or import one first"));
    const MapScale scale = orRaise(L, mapScale(p, field));
    return {field,       value.map,   value.map,     unitsOf(field, value.map.info().type),
            scale.width, scale.depth, scale.repeats, scale.mirrored};
}
}  // namespace

NamedMap mapArg(lua_State* L, int arg) {
    NamedMap m = storedMap(L, arg);
    if (m.units.plain()) return m;
    charge(L, uint64_t(m.stored.info().width) * uint64_t(m.stored.info().height));
    m.map = inUnits(m.stored, m.units);
    return m;
}

namespace {
struct LastMap {
    std::string name;
    uint64_t revision = 0;
    NamedMap map;
};
}  // namespace

const NamedMap& readMapArg(lua_State* L, int arg) {
    State& state = stateOf(L);
    const char* name = luaL_checkstring(L, arg);
    auto* last = static_cast<LastMap*>(state.lastMap.get());
    if (!last || last->name != name || last->revision != state.document().revision()) {
        auto found = std::make_shared<LastMap>(LastMap{name, state.document().revision(), storedMap(L, arg)});
        last = found.get();
        state.lastMap = std::move(found);
    }
    return last->map;
}

void giveBack(lua_State* L, const NamedMap& of, Map map, const std::string& label) {
    if (!of.units.plain()) map = fromUnits(map, of.units, of.stored.info().type, of.stored);
    orRaise(L, stateOf(L).document().setMap(of.field.path, std::move(map), label));
}

void checkMapBytes(lua_State* L, const MapInfo& info) {
    State& state = stateOf(L);
    const auto bytes = [](const MapInfo& i) {
        return size_t(i.width) * size_t(i.height) * size_t(i.channels) * pixelBytes(i.type);
    };
    size_t total = bytes(info);
    if (total > kMaxMapBytes) raise(L, fmt::format("a map of {} MiB; the most is {}", total >> 20, kMaxMapBytes >> 20));
    for (const ConstFieldRef& f : allMaps(openProject(L), state.rows()))
        total += bytes(static_cast<const MapField*>(f.value)->map.info());
    if (total > state.host.limits.mapBytes)
        raise(L, fmt::format("the project's maps would need {} MiB; a script may make them {}", total >> 20,
                             state.host.limits.mapBytes >> 20));
}

Channels channelsOption(lua_State* L, Options& options, const MapInfo& info) {
    if (!options.push("channels")) return kAllChannels;
    const int table = lua_gettop(L);
    if (!lua_istable(L, table)) raise(L, "channels must be a list of numbers from 1");
    Channels channels{};
    const lua_Integer count = luaL_len(L, table);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_geti(L, table, i);
        const lua_Integer c = lua_tointeger(L, -1);
        if (c < 1 || c > info.channels) raise(L, fmt::format("channels must be numbers from 1 to {}", info.channels));
        channels[size_t(c - 1)] = true;
        lua_pop(L, 1);
        charge(L, 1);
    }
    lua_pop(L, 1);
    return channels;
}

std::array<float, 4> valueAt(lua_State* L, int index, int channels, const char* what) {
    index = lua_absindex(L, index);
    std::array<float, 4> value{};
    if (lua_type(L, index) == LUA_TNUMBER)
        value.fill(static_cast<float>(lua_tonumber(L, index)));
    else if (!lua_istable(L, index) || luaL_len(L, index) != channels)
        raise(L, fmt::format("{} must be a number or a table of {}", what, channels));
    else
        for (int c = 0; c < channels; ++c) {
            const bool number = lua_geti(L, index, c + 1) == LUA_TNUMBER;
            value[size_t(c)] = number ? static_cast<float>(lua_tonumber(L, -1)) : std::nanf("");
            lua_pop(L, 1);
        }
    for (int c = 0; c < channels; ++c)
        if (!std::isfinite(value[size_t(c)])) raise(L, fmt::format("{}: channel {} is no finite number", what, c + 1));
    return value;
}

}  // namespace sward::script
