// bake.NAME{samples =, size =}: what the host can bake; the result is one undo step.
#include "script/state.h"

namespace sward::script {
namespace {

int run(lua_State* L, State& state) {
    const std::string name = lua_tostring(L, lua_upvalueindex(1));
    openProject(L);
    if (lua_isnoneornil(L, 1)) {
        lua_settop(L, 0);
        lua_newtable(L);
    }
    Options options(L, 1);
    const auto whole = [&](const char* option, double otherwise) {
        const double v = options.number(option, otherwise);
        if (v != std::floor(v) || std::abs(v) > 1e6) raise(L, fmt::format("{} must be a whole number", option));
        return static_cast<int>(v);
    };
    const int samples = whole("samples", 64), size = whole("size", 0);
    options.finish();
    orRaise(L, state.host.bakes.at(name)(samples, size));
    return 0;
}

}  // namespace

void openBakeCalls(lua_State* L) {
    lua_newtable(L);
    for (const auto& [name, call] : stateOf(L).host.bakes) {
        lua_pushstring(L, name.c_str());
        lua_pushcclosure(L, luaCall<run>, 1);
        lua_setfield(L, -2, name.c_str());
    }
    lua_setglobal(L, "bake");
}

}  // namespace sward::script
