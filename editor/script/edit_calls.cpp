// edit.undo, edit.redo and camera.use.
#include "script/state.h"
#include "script/values.h"

namespace sward::script {
namespace {

void refuseInPlay(lua_State* L, State& state) {
    openProject(L);
    if (state.document().play()) raise(L, "there is no undo while the project is played; play.stop() ends it");
}

// True if there was a step.
int undo(lua_State* L, State& state) {
    refuseInPlay(L, state);
    lua_pushboolean(L, state.document().undo());
    return 1;
}
int redo(lua_State* L, State& state) {
    refuseInPlay(L, state);
    lua_pushboolean(L, state.document().redo());
    return 1;
}

// edit.group(label, function() … end): all that the function changes is one undo step; nothing if it fails.
int group(lua_State* L, State& state) {
    openProject(L);
    const std::string label = textArg(L, 1);
    luaL_checktype(L, 2, LUA_TFUNCTION);
    lua_settop(L, 2);
    GroupOrNothing step(state.document(), label);
    lua_call(L, 0, 0);
    step.keep();
    return 0;
}

// camera.use(name): the editor shows the view of this entity.
int use(lua_State* L, State& state) {
    const std::string name = textArg(L, 1);
    const Project& p = openProject(L);
    if (!p.registry.get<Camera>(findEntity(p, name)))
        raise(L, usage(fmt::format("there is no camera \"{}\"", name), "entity.list(\"Camera\") names them"));
    state.host.camera = name;
    if (state.host.useCamera) state.host.useCamera(name);
    return 0;
}

}  // namespace

void openEditCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"undo", luaCall<undo>}, {"redo", luaCall<redo>}, {"group", luaCall<group>}};
    registerCalls(L, "edit", calls);
}
void openCameraCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"use", luaCall<use>}};
    registerCalls(L, "camera", calls);
}

}  // namespace sward::script
