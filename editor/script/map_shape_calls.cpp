// map.disc, rect, polygon, line, polyline: shapes in metres with antialiased or soft edges.
#include "script/map_args.h"

namespace sward::script {
namespace {

BlendMode blendOption(lua_State* L, Options& options) {
    const std::string mode = options.text("mode", "set");
    if (mode == "set") return BlendMode::Set;
    if (mode == "add") return BlendMode::Add;
    if (mode == "multiply") return BlendMode::Multiply;
    if (mode == "max") return BlendMode::Max;
    if (mode == "min") return BlendMode::Min;
    raise(L, fmt::format("mode is \"{}\"; there are set, add, multiply, max and min", mode));
}

// value = 1, mode = "set", opacity = 1, soft = 0 of every shape.
ShapePaint paintOptions(lua_State* L, Options& options, const MapInfo& info) {
    ShapePaint paint;
    if (options.push("value")) {
        paint.value = valueAt(L, -1, info.channels, "value");
        lua_pop(L, 1);
    }
    paint.mode = blendOption(L, options);
    paint.opacity = options.number("opacity", 1);
    paint.soft = options.number("soft", 0);
    if (!(paint.opacity >= 0 && paint.opacity <= 1)) raise(L, "opacity must lie between 0 and 1");
    if (!(paint.soft >= 0 && paint.soft <= 1e6)) raise(L, "soft must lie between 0 and 1e6 m");
    return paint;
}

double lengthOption(lua_State* L, Options& options, const char* name) {
    const double value = options.number(name);
    if (!(value >= 0 && value <= 1e6)) raise(L, fmt::format("{} must lie between 0 and 1e6 m", name));
    return value;
}

std::vector<ShapePoint> pointsOption(lua_State* L, Options& options, size_t least) {
    if (!options.push("points")) raise(L, "the option points is missing");
    std::vector<ShapePoint> points = pointsArg(L, -1, "points");
    lua_pop(L, 1);
    if (points.size() < least) raise(L, fmt::format("points must be at least {}", least));
    return points;
}

Shape discOptions(lua_State* L, Options& options) {
    Shape s{ShapeKind::Disc, {{options.number("x"), options.number("z")}}};
    s.radius = lengthOption(L, options, "radius");
    s.inner = options.number("inner", 0);
    return s;
}
Shape rectOptions(lua_State*, Options& options) {
    const double x0 = options.number("x0"), z0 = options.number("z0");
    return {ShapeKind::Rect, {{x0, z0}, {options.number("x1"), options.number("z1")}}};
}
Shape polygonOptions(lua_State* L, Options& options) { return {ShapeKind::Polygon, pointsOption(L, options, 3)}; }
Shape lineOptions(lua_State* L, Options& options) {
    const double x0 = options.number("x0"), z0 = options.number("z0");
    Shape s{ShapeKind::Polyline, {{x0, z0}, {options.number("x1"), options.number("z1")}}};
    s.width = lengthOption(L, options, "width");
    return s;
}
Shape polylineOptions(lua_State* L, Options& options) {
    Shape s{ShapeKind::Polyline, pointsOption(L, options, 1)};
    s.width = lengthOption(L, options, "width");
    s.closed = options.flag("closed", false);
    return s;
}

template <Shape (*OptionsOf)(lua_State*, Options&)>
int draw(lua_State* L, State&) {
    NamedMap m = mapArg(L, 1);
    Options options(L, 2);
    const Shape shape = OptionsOf(L, options);
    const ShapePaint paint = paintOptions(L, options, m.map.info());
    options.finish();
    charge(L, drawShape(m.map, m.width, m.depth, shape, paint));
    giveBack(L, m, m.map, "draw on " + m.field.path);
    return 0;
}

}  // namespace

void openMapShapeCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"disc", luaCall<draw<discOptions>>},
                                   {"rect", luaCall<draw<rectOptions>>},
                                   {"polygon", luaCall<draw<polygonOptions>>},
                                   {"line", luaCall<draw<lineOptions>>},
                                   {"polyline", luaCall<draw<polylineOptions>>}};
    registerCalls(L, "map", calls);
}

}  // namespace sward::script
