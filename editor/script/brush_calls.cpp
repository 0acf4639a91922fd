// brush.select, brush.stroke and brush.erase.
#include "brushes/shape.h"
#include "script/files.h"
#include "script/state.h"
#include "tools/stroke.h"

namespace sward::script {
namespace {

bool given(lua_State* L, Options& options, const char* name) {
    const bool is = options.push(name);
    if (is) lua_pop(L, 1);
    return is;
}

// A map's name, or a list of them; none if there is no such option.
std::vector<std::string> mapsOption(lua_State* L, Options& options) {
    std::vector<std::string> maps;
    if (!options.push("map")) return maps;
    if (lua_type(L, -1) == LUA_TSTRING) maps.push_back(lua_tostring(L, -1));
    if (lua_istable(L, -1))
        for (lua_Integer i = 1; lua_geti(L, -1, i) != LUA_TNIL || (lua_pop(L, 1), false); ++i) {
            if (lua_type(L, -1) != LUA_TSTRING) raise(L, "the option map must name maps");
            maps.push_back(lua_tostring(L, -1));
            lua_pop(L, 1);
        }
    if (maps.empty()) raise(L, "the option map must be a string or a list of strings");
    lua_pop(L, 1);
    return maps;
}

// Which of these words the option is, the first if it is absent; raises if it is none.
int choiceOption(lua_State* L, Options& options, const char* name, std::initializer_list<const char*> words) {
    const std::string text = options.text(name, *words.begin());
    int i = 0;
    std::string all;
    for (const char* word : words) {
        if (text == word) return i;
        ++i;
        all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", word);
    }
    raise(L, fmt::format("the option {} is \"{}\"; there are {}", name, text, all));
}

// A shape made here by its name, or one from a file that the script may read.
void shapeOptions(lua_State* L, Options& options, BrushSettings& brush) {
    const std::string shape = options.text("shape", "");
    if (!shape.empty()) brush.shape = builtInShape(shape);
    if (!shape.empty() && !brush.shape) brush.shape = orRaise(L, loadShape(readablePath(L, shape)));
    brush.shapeTurn = static_cast<ShapeTurn>(choiceOption(L, options, "shapeTurn", {"fixed", "random", "along"}));
    brush.shapeAngleDeg = static_cast<float>(options.number("shapeAngle", 0));
    brush.blend = static_cast<HeightBlend>(choiceOption(L, options, "blend", {"add", "maximum", "minimum", "replace"}));
    const int mirror = choiceOption(L, options, "mirror", {"", "x", "z", "xz"});
    brush.mirrorX = mirror % 2 == 1, brush.mirrorZ = mirror >= 2;
}

// brush.select{map =, mode =, radius =, strength = 1, value = 1, falloff = 0.5, spacing = 0.1, seed = 0, angle = 0,
// color = {1, 1, 1}, bumpSize = 0, talus = 35, water = 0.5, shape = "", shapeTurn = "fixed", shapeAngle = 0, mirror =
// "", blend = "add", base =}; without a value flatten goes to where the stroke begins, without a base imprint stands
// there. `map` may be a list: all of them are painted.
int select(lua_State* L, State& state) {
    Options options(L, 1);
    BrushSettings brush;
    std::vector<std::string> maps = mapsOption(L, options);
    const bool named = !maps.empty();
    if (!named) maps = {brush.map};
    brush.map = maps.front();
    brush.mode = options.text("mode", "add");
    brush.radius = static_cast<float>(options.number("radius", 1));
    brush.strength = static_cast<float>(options.number("strength", 1));
    brush.value = static_cast<float>(options.number("value", 1));
    brush.falloff = static_cast<float>(options.number("falloff", 0.5));
    brush.spacing = static_cast<float>(options.number("spacing", 0.1));
    brush.seed = static_cast<int>(std::clamp(options.number("seed", 0), -1e9, 1e9));
    brush.angleDeg = static_cast<float>(options.number("angle", 0));
    brush.fromStart = !given(L, options, brush.mode == "imprint" ? "base" : "value");
    brush.base = static_cast<float>(options.number("base", 0));
    shapeOptions(L, options, brush);
    brush.bumpSize = static_cast<float>(options.number("bumpSize", 0));
    brush.talusDeg = static_cast<float>(options.number("talus", 35));
    brush.water = static_cast<float>(options.number("water", 0.5));
    brush.color = vectorOption(L, options, "color", brush.color, 1);
    options.finish();
    orRaise(L, checkBrush(brush));
    if (named && state.document().isOpen())
        for (const std::string& map : maps) orRaise(L, findMap(state.document().project(), state.rows(), map));
    state.host.brush = brush;
    state.host.alsoPaints.assign(maps.begin() + 1, maps.end());
    return 0;
}

// One undo step, done when the call returns.
int paint(lua_State* L, State& state, std::span<const BrushSettings> brushes, bool create,
          std::optional<uint32_t> turn = {}) {
    const auto points = pointsArg(L, 1, "the stroke");
    if (points.empty()) raise(L, "the stroke must have a point");
    Document& document = state.document();
    orRaise(L, document.beginStrokes(brushes, points[0].first, points[0].second, create, turn));
    for (const auto& [x, z] : points) document.strokeTo(x, z);
    document.endStroke();
    while (document.pumpStroke(50)) charge(L, 10'000'000);  // about what a script would do in that time
    return 0;
}

// The option {"meadow.GrassField.species[lawn].density", …}: the selected brush on each; absent: `selected`.
std::vector<BrushSettings> brushesOption(lua_State* L, Options& options, std::vector<BrushSettings> selected) {
    if (!options.push("maps")) return selected;
    if (!lua_istable(L, -1) || luaL_len(L, -1) < 1) raise(L, "maps must be a list of maps");
    std::vector<BrushSettings> brushes;
    for (lua_Integer i = 1; i <= luaL_len(L, -1); ++i) {
        lua_geti(L, -1, i);
        brushes.push_back(selected[0]);
        brushes.back().map = textArg(L, lua_gettop(L));
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return brushes;
}

// brush.stroke({{x, z}, …}, {maps =, create =, turn =}); makes heights that are not there yet, since level ground is
// what their absence means, and other maps if told to.
int stroke(lua_State* L, State& state) {
    const Project& p = openProject(L);
    const Result<ConstFieldRef> map = findMap(p, state.rows(), state.host.brush.map);
    const bool heights = map && map->row->map->kind == MapKind::Heights;
    std::vector<BrushSettings> brushes{state.host.brush};
    for (const std::string& path : state.host.alsoPaints) {
        brushes.push_back(state.host.brush);
        brushes.back().map = path;
    }
    if (lua_isnoneornil(L, 2)) return paint(L, state, brushes, heights);
    Options options(L, 2);
    brushes = brushesOption(L, options, std::move(brushes));
    const bool create = options.flag("create", heights);
    const double turn = options.number("turn", -1);
    options.finish();
    if (turn > 4e9) raise(L, "turn must lie between 0 and 4e9");
    return paint(L, state, brushes, create, turn < 0 ? std::nullopt : std::optional(static_cast<uint32_t>(turn)));
}

// brush.erase{{x, z}, …}: every species of the field, whatever map is selected; with the brush's size and strength.
int erase(lua_State* L, State& state) {
    const Project& p = openProject(L);
    BrushSettings like = state.host.brush;
    if (const Result<ConstFieldRef> map = findMap(p, state.rows(), like.map)) like.map = map->path;
    like.mode = "subtract";
    const std::vector<BrushSettings> brushes = speciesBrushes(p, state.rows(), like);
    if (brushes.empty()) raise(L, "there is no grass to erase");
    return paint(L, state, brushes, true);
}

}  // namespace

void openBrushCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"select", luaCall<select>}, {"stroke", luaCall<stroke>}, {"erase", luaCall<erase>}};
    registerCalls(L, "brush", calls);
}

}  // namespace sward::script
