// camera.picture and camera.film: pictures of the project as it is, by the host.
#include <cmath>

#include "model/film_plan.h"
#include "script/files.h"
#include "script/state.h"

namespace sward::script {
namespace {

int wholeOption(lua_State* L, Options& o, const char* name, int otherwise) {
    const double v = o.number(name, otherwise);
    if (v != std::floor(v) || std::abs(v) > 1e6) raise(L, fmt::format("{} must be a whole number", name));
    return static_cast<int>(v);
}

// The options that both have; what else a film takes, `more` reads.
template <class More>
int shoot(lua_State* L, State& state, FilmPlan plan, More&& more) {
    openProject(L);
    plan.out = writablePath(L, textArg(L, 1));
    std::string camera = state.host.camera;
    if (lua_isnoneornil(L, 2)) {
        lua_settop(L, 1);
        lua_newtable(L);
    }
    Options o(L, 2);
    plan.width = wholeOption(L, o, "width", plan.width);
    plan.height = wholeOption(L, o, "height", plan.height);
    camera = o.text("camera", camera.c_str());
    more(plan, o);
    o.finish();
    if (!state.host.film) raise(L, "camera.picture and camera.film: this host draws none");
    orRaise(L, state.host.film(plan, camera));
    lua_pushinteger(L, framesOf(plan, state.document().project()));
    return 1;
}

int picture(lua_State* L, State& state) {
    return shoot(L, state, {}, [](FilmPlan& plan, Options& o) { plan.from = o.number("time", 0); });
}

int film(lua_State* L, State& state) {
    return shoot(L, state, {.film = true}, [](FilmPlan& plan, Options& o) {
        plan.path = o.text("path", "");
        plan.fps = o.number("fps", plan.fps);
        plan.from = o.number("from", 0);
        plan.seconds = o.number("seconds", 0);
        plan.format = o.text("format", plan.format.c_str());
    });
}

}  // namespace

void openFilmCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"picture", luaCall<picture>}, {"film", luaCall<film>}};
    registerCalls(L, "camera", calls);
}

}  // namespace sward::script
