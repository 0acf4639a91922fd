// edit.undo, edit.redo and camera.use.
#include "script/state.h"

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
    constexpr NamedCall calls[] = {{"undo", luaCall<undo>}, {"redo", luaCall<redo>}};
    registerCalls(L, "edit", calls);
}
void openCameraCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"use", luaCall<use>}};
    registerCalls(L, "camera", calls);
}

}  // namespace sward::script
