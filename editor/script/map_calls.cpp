// map.*: create, fill, noise, blur, curve, copy, import, export, mean, at, hash, size, exists.
#include "core/file.h"
#include "core/hash.h"
#include "core/log.h"
#include "core/utf8.h"
#include "maps/map_repair.h"
#include "model/map_import.h"
#include "model/whole_map.h"
#include "project/packed_map.h"
#include "scene/map_fields.h"
#include "scene/tiling.h"
#include "script/files.h"
#include "script/map_args.h"
#include "script/values.h"
#include "tools/stroke.h"

namespace sward::script {
namespace {

uint64_t texelCount(const Map& map) { return uint64_t(map.info().width) * uint64_t(map.info().height); }

PixelType typeOption(lua_State* L, Options& options, PixelType otherwise) {
    const std::string name = options.text("type", "");
    if (name.empty()) return otherwise;
    if (name == "u8") return PixelType::U8;
    if (name == "u16") return PixelType::U16;
    if (name == "f32") return PixelType::F32;
    raise(L, fmt::format("type is \"{}\"; there are u8, u16 and f32", name));
}

int sizeOption(lua_State* L, Options& options, const char* name) {
    const double value = options.number(name);
    if (value != std::floor(value) || value < 1 || value > kMaxMapSide)
        raise(L, fmt::format("{} must be a whole number from 1 to {}", name, kMaxMapSide));
    return static_cast<int>(value);
}

// map.create{path =, width =, height =, channels =, type =, value = 0}: replaces a map that is there.
int createMap(lua_State* L, State& state) {
    Options options(L, 1);
    const ConstFieldRef field = orRaise(L, findMap(openProject(L), state.rows(), options.text("path")));
    MapInfo info{sizeOption(L, options, "width"), sizeOption(L, options, "height"), field.row->map->channels,
                 PixelType::U16};
    info.channels = static_cast<int>(std::clamp(options.number("channels", info.channels), 0.0, 99.0));
    info.type = typeOption(L, options, field.row->map->type);
    if (info.channels != field.row->map->channels)
        raise(L, fmt::format("{} has {} channels, not {}", field.path, field.row->map->channels, info.channels));
    checkMapBytes(L, info);
    const MapUnits units = unitsOf(field, info.type);
    Map map = inUnits(Map(info), units);
    std::array<float, 4> value{};
    if (options.push("value")) {
        charge(L, texelCount(map) / 8);
        value = valueAt(L, -1, info.channels, "value");
        lua_pop(L, 1);
    }
    if (value != std::array<float, 4>{} || !units.plain()) fillMap(map, value);
    map = fromUnits(map, units, info.type);
    options.finish();
    orRaise(L, state.document().setMap(field.path, std::move(map), "create " + field.path));
    return 0;
}

// Calls the function on top of the stack for a texel's centre.
void fillTexel(lua_State* L, const NamedMap& of, int x, int y, float* texel) {
    const MapInfo& info = of.map.info();
    const double px = (x + 0.5) * of.width / info.width, pz = (y + 0.5) * of.depth / info.height;
    lua_pushvalue(L, 2);
    lua_pushnumber(L, px);
    lua_pushnumber(L, pz);
    lua_call(L, 2, info.channels);
    for (int c = 0; c < info.channels; ++c) {
        const int at = c - info.channels;
        const double value = lua_type(L, at) == LUA_TNUMBER ? lua_tonumber(L, at) : std::nan("");
        if (!std::isfinite(value))
            raise(L, fmt::format("the function must return {} finite number{}; at ({}, {}) it did not", info.channels,
                                 info.channels > 1 ? "s" : "", px, pz));
        texel[c] = static_cast<float>(value);
    }
    lua_pop(L, info.channels);
}

// map.fill(name, value) or map.fill(name, function(x, z) return … end), in metres.
int fill(lua_State* L, State&) {
    NamedMap m = mapArg(L, 1);
    const MapInfo& info = m.map.info();
    luaL_checkany(L, 2);
    if (!lua_isfunction(L, 2)) {
        charge(L, texelCount(m.map) / 8);
        fillMap(m.map, valueAt(L, 2, info.channels, "the value"));
    } else {
        lua_settop(L, 2);
        float texel[4];
        for (int y = 0; y < info.height; ++y)
            for (int x = 0; x < info.width; ++x) {
                fillTexel(L, m, x, y, texel);
                for (int c = 0; c < info.channels; ++c) m.map.set(x, y, c, texel[c]);
            }
    }
    giveBack(L, m, m.map, "fill " + m.field.path);
    return 0;
}

NoiseMode noiseModeOption(lua_State* L, Options& options) {
    const std::string mode = options.text("mode", "add");
    if (mode == "add") return NoiseMode::Add;
    if (mode == "multiply") return NoiseMode::Multiply;
    if (mode == "set") return NoiseMode::Set;
    raise(L, fmt::format("mode is \"{}\"; there are add, multiply and set", mode));
}

// map.noise(name, {scale =, octaves = 4, amount = 1, seed = 0, mode = "add", seamless = false, channels =})
int noise(lua_State* L, State&) {
    NamedMap m = mapArg(L, 1);
    Options options(L, 2);
    NoiseSettings s;
    s.scale = options.number("scale");
    const double octaves = options.number("octaves", 4), seed = options.number("seed", 0);
    s.amount = options.number("amount", 1);
    s.mode = noiseModeOption(L, options);
    s.seamless = options.flag("seamless", false);
    const Channels channels = channelsOption(L, options, m.map.info());
    options.finish();
    if (!(s.scale >= 1e-3 && s.scale <= 1e6)) raise(L, "scale must lie between 0.001 and 1e6 m");
    if (!(octaves >= 1 && octaves <= 16)) raise(L, "octaves must lie between 1 and 16");
    if (!(std::abs(seed) <= 1e6)) raise(L, "seed must lie between -1e6 and 1e6");
    s.octaves = static_cast<int>(octaves);
    s.seed = static_cast<int>(seed);
    charge(L, texelCount(m.map) * static_cast<uint64_t>(s.octaves));
    noiseMap(m.map, m.width, m.depth, s, channels);
    giveBack(L, m, m.map, "noise " + m.field.path);
    return 0;
}

// map.blur(name, radius, {channels =}), the radius in metres.
int blur(lua_State* L, State&) {
    NamedMap m = mapArg(L, 1);
    const double radius = numberArg(L, 2);
    Channels channels = kAllChannels;
    if (!lua_isnoneornil(L, 3)) {
        Options options(L, 3);
        channels = channelsOption(L, options, m.map.info());
        options.finish();
    }
    if (!(radius >= 0 && radius <= 1e6)) raise(L, "the radius must lie between 0 and 1e6 m");
    const MapInfo& info = m.map.info();
    const auto texels = [&](double perMetre, int most) { return std::min(radius * perMetre, double(most)); };
    charge(L, texelCount(m.map) * static_cast<uint64_t>(2 * info.channels));
    blurMap(m.map, texels(info.width / m.width, info.width), texels(info.height / m.depth, info.height), channels,
            m.repeats && !m.mirrored);
    giveBack(L, m, m.map, "blur " + m.field.path);
    return 0;
}

// map.curve(name, {{0, 0}, {1, 1}}, {channels =})
int curve(lua_State* L, State&) {
    NamedMap m = mapArg(L, 1);
    auto points = pointsArg(L, 2, "the curve");
    if (points.empty()) raise(L, "the curve must have a point");
    std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Channels channels = kAllChannels;
    if (!lua_isnoneornil(L, 3)) {
        Options options(L, 3);
        channels = channelsOption(L, options, m.map.info());
        options.finish();
    }
    charge(L, texelCount(m.map));
    curveMap(m.map, points, channels);
    giveBack(L, m, m.map, "curve " + m.field.path);
    return 0;
}

// map.copy(to, from): the values of another map of as many channels, in the field's own type; a map that is there is
// replaced.
int copy(lua_State* L, State& state) {
    const ConstFieldRef to = orRaise(L, findMap(openProject(L), state.rows(), textArg(L, 1)));
    const NamedMap from = mapArg(L, 2);
    if (from.map.info().channels != to.row->map->channels)
        raise(L, fmt::format("{} has {} channels, not {} as {}", from.field.path, from.map.info().channels,
                             to.row->map->channels, to.path));
    MapInfo info = from.map.info();
    info.type = to.row->map->type;
    checkMapBytes(L, info);
    charge(L, texelCount(from.map) / 8);
    const MapUnits units = unitsOf(to, info.type);
    Map map = units.plain() ? convertMap(from.map, info.type)
                            : fromUnits(convertMap(from.map, PixelType::F32), units, info.type);
    orRaise(L, state.document().setMap(to.path, std::move(map), "copy " + from.field.path));
    return 0;
}

// {flip = false, range = {low, high}, packed = false} as the third argument.
struct TransferOptions : ImportOptions {
    bool packed = false;
};
TransferOptions transferOptions(lua_State* L) {
    TransferOptions out;
    if (lua_isnoneornil(L, 3)) return out;
    Options options(L, 3);
    out.packed = options.flag("packed", false);
    if (options.push("flip")) {
        out.flip = lua_toboolean(L, -1);
        lua_pop(L, 1);
    }
    if (options.push("range")) {
        const bool table = lua_istable(L, -1) && luaL_len(L, -1) == 2;
        if (!table) raise(L, "range must be {low, high}");
        const std::array<float, 4> range = valueAt(L, -1, 2, "range");
        out.range = {range[0], range[1]};
        lua_pop(L, 1);
    }
    options.finish();
    if (out.packed && out.range) raise(L, "a packed map has no range");
    return out;
}

// Density and blade heights from one image, and how often both repeat: one step.
int importBoth(lua_State* L, State& state, const ConstFieldRef& density, const std::filesystem::path& file,
               const ImportOptions& options) {
    const Project& p = openProject(L);
    const ConstFieldRef height = orRaise(L, bladeHeightBeside(p, state.rows(), density));
    const auto remembered = p.imports.find(density.path);
    const bool flip = options.flip.value_or(remembered != p.imports.end() && remembered->second.flip);
    PackedMaps maps = orRaise(L, readPacked(file, flip));
    if (maps.ownCoarse) logWarning(file.string() + ": " + kGreenNotKept);
    const float tiling = orRaise(L, mapScale(p, density)).factor;
    GroupOrNothing group(state.document(), "import " + density.path);
    orRaise(L, state.document().setMap(density.path, std::move(maps.density), "import"));
    orRaise(L, state.document().setMap(height.path, std::move(maps.bladeHeight), "import"));
    orRaise(L,
            state.document().setField(fieldBeside(height, *height.row->map->tiling).path, fmt::format("{}", tiling)));
    group.keep();
    for (const ConstFieldRef* f : {&density, &height})
        state.document().rememberImport(f->path, {utf8Text(file.filename().string()), flip, {}});
    return 0;
}

// map.import(name, file, {flip =, range =, packed =}): texels, remembered settings and the height's range are one step.
int import(lua_State* L, State& state) {
    const Project& p = openProject(L);
    const ConstFieldRef field = orRaise(L, findMap(p, state.rows(), textArg(L, 1)));
    const auto file = readablePath(L, textArg(L, 2));
    const TransferOptions options = transferOptions(L);
    if (options.packed) return importBoth(L, state, field, file, options);
    orRaise(L, importIntoMap(state.document(), field.path, file, options));
    return 0;
}

// map.export(name, file, {flip =, range =, packed =})
int exportTo(lua_State* L, State& state) {
    const auto file = writablePath(L, textArg(L, 2));
    orRaise(L, makeFolderOf(file));
    const TransferOptions options = transferOptions(L);
    orRaise(L, (options.packed ? exportPacked : exportMap)(openProject(L), state.rows(), textArg(L, 1), file, options));
    return 0;
}

int channelArg(lua_State* L, int arg, const Map& map) {
    const double channel = optionalNumber(L, arg).value_or(1);
    if (channel != std::floor(channel) || channel < 1 || channel > map.info().channels)
        raise(L, fmt::format("the map has channels 1 to {}", map.info().channels));
    return static_cast<int>(channel) - 1;
}

// map.mean(name, channel = 1)
int mean(lua_State* L, State&) {
    const NamedMap& m = readMapArg(L, 1);
    charge(L, texelCount(m.map) / 8);
    lua_pushnumber(L, m.units.valueOf(m.map.mean(channelArg(L, 2, m.map))));
    return 1;
}

// map.at(name, x, z): every channel, bilinear, in metres.
int at(lua_State* L, State&) {
    const NamedMap& m = readMapArg(L, 1);
    const Tiling tiling{{m.width, m.depth}, m.repeats};
    const double x = numberArg(L, 2), z = numberArg(L, 3);
    for (int c = 0; c < m.map.info().channels; ++c)
        lua_pushnumber(
            L, m.units.valueOf(m.mirrored ? mirroredSample(m.map, tiling, x, z) : tiledSample(m.map, tiling, x, z, c)));
    return m.map.info().channels;
}

int hashMap(lua_State* L, State&) {
    const NamedMap& m = readMapArg(L, 1);
    charge(L, texelCount(m.map) / 8);
    lua_pushstring(L, hashHex(m.map.hash()).c_str());
    return 1;
}

// map.size(name): width, height, channels, type.
int size(lua_State* L, State&) {
    const NamedMap& m = readMapArg(L, 1);
    const MapInfo& info = m.map.info();
    lua_pushinteger(L, info.width);
    lua_pushinteger(L, info.height);
    lua_pushinteger(L, info.channels);
    lua_pushstring(L, info.type == PixelType::U8 ? "u8" : info.type == PixelType::U16 ? "u16" : "f32");
    return 4;
}

// map.clear(name), map.invert(name): the menu Brush's Clear Map and Invert Map.
template <Status (*Change)(Document&, const std::string&)>
int changeWhole(lua_State* L, State& state) {
    const ConstFieldRef field = orRaise(L, findMap(openProject(L), state.rows(), textArg(L, 1)));
    charge(L, texelCount(static_cast<const MapField*>(field.value)->map));
    orRaise(L, Change(state.document(), field.path));
    return 0;
}

// map.exists(name): whether the field has a map.
int exists(lua_State* L, State& state) {
    const Result<ConstFieldRef> field = findMap(openProject(L), state.rows(), textArg(L, 1));
    lua_pushboolean(L, field && static_cast<const MapField*>(field->value)->present());
    return 1;
}

}  // namespace

void openMapCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"create", luaCall<createMap>},
                                   {"fill", luaCall<fill>},
                                   {"noise", luaCall<noise>},
                                   {"blur", luaCall<blur>},
                                   {"curve", luaCall<curve>},
                                   {"copy", luaCall<copy>},
                                   {"import", luaCall<import>},
                                   {"export", luaCall<exportTo>},
                                   {"mean", luaCall<mean>},
                                   {"at", luaCall<at>},
                                   {"hash", luaCall<hashMap>},
                                   {"size", luaCall<size>},
                                   {"exists", luaCall<exists>},
                                   {"clear", luaCall<changeWhole<clearMap>>},
                                   {"invert", luaCall<changeWhole<invertMap>>}};
    registerCalls(L, "map", calls);
}

}  // namespace sward::script
