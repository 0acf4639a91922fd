// brush.select and brush.stroke.
#include "script/state.h"
#include "stroke.h"

namespace sward::script {
namespace {

// brush.select{map =, mode =, radius =, strength = 1, value = 1, falloff = 0.5, spacing = 0.1, seed = 0}
int select(lua_State* L, State& state) {
    Options options(L, 1);
    BrushSettings brush;
    brush.map = options.text("map", "density");
    brush.mode = options.text("mode", "add");
    brush.radius = static_cast<float>(options.number("radius", 1));
    brush.strength = static_cast<float>(options.number("strength", 1));
    brush.value = static_cast<float>(options.number("value", 1));
    brush.falloff = static_cast<float>(options.number("falloff", 0.5));
    brush.spacing = static_cast<float>(options.number("spacing", 0.1));
    brush.seed = static_cast<int>(std::clamp(options.number("seed", 0), -1e9, 1e9));
    options.finish();
    orRaise(L, checkBrush(brush));
    state.host.brush = brush;
    return 0;
}

// brush.stroke{{x, z}, …}: one undo step, done when the call returns.
int stroke(lua_State* L, State& state) {
    openProject(L);
    const auto points = pointsArg(L, 1, "the stroke");
    if (points.empty()) raise(L, "the stroke must have a point");
    Document& document = state.document();
    orRaise(L, document.beginStroke(state.host.brush, points[0].first, points[0].second));
    for (const auto& [x, z] : points) document.strokeTo(x, z);
    document.endStroke();
    while (document.pumpStroke(50)) charge(L, 10'000'000);  // about what a script would do in that time
    return 0;
}

}  // namespace

void openBrushCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"select", luaCall<select>}, {"stroke", luaCall<stroke>}};
    registerCalls(L, "brush", calls);
}

}  // namespace sward::script
