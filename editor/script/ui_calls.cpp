// ui.*: the editor's real widgets, by label path, over the host's UiDriver.
#include "core/file.h"
#include "script/files.h"
#include "script/state.h"

namespace sward::script {
namespace {

constexpr double kMostFrames = 100000;

UiDriver& driver(lua_State* L, State& state) {
    if (!state.host.ui) raise(L, "ui.* needs the editor's window; this script runs without one");
    return *state.host.ui;
}

int click(lua_State* L, State& state) {
    orRaise(L, driver(L, state).click(textArg(L, 1)));
    return 0;
}

int rightClick(lua_State* L, State& state) {
    orRaise(L, driver(L, state).rightClick(textArg(L, 1)));
    return 0;
}

int drop(lua_State* L, State& state) {
    orRaise(L, driver(L, state).drop(readablePath(L, textArg(L, 1))));
    return 0;
}

// Numbers, strings and booleans, as a person would enter them.
int setItem(lua_State* L, State& state) {
    const std::string label = textArg(L, 1);
    luaL_checkany(L, 2);
    const std::string text = luaL_tolstring(L, 2, nullptr);
    orRaise(L, driver(L, state).set(label, text));
    return 0;
}

int itemText(lua_State* L, State& state) {
    const std::string text = orRaise(L, driver(L, state).get(textArg(L, 1)));
    lua_pushlstring(L, text.data(), text.size());
    return 1;
}

int itemExists(lua_State* L, State& state) {
    lua_pushboolean(L, driver(L, state).exists(textArg(L, 1)));
    return 1;
}

int key(lua_State* L, State& state) {
    orRaise(L, driver(L, state).key(textArg(L, 1)));
    return 0;
}

int drag(lua_State* L, State& state) {
    const std::string held = lua_isnoneornil(L, 5) ? "" : textArg(L, 5);
    orRaise(L, driver(L, state).drag(numberArg(L, 1), numberArg(L, 2), numberArg(L, 3), numberArg(L, 4), held));
    return 0;
}

int rect(lua_State* L, State& state) {
    for (const double edge : orRaise(L, driver(L, state).rect(textArg(L, 1)))) lua_pushnumber(L, edge);
    return 4;
}

int wait(lua_State* L, State& state) {
    const double frames = optionalNumber(L, 1).value_or(1);
    if (frames < 0 || frames > kMostFrames) raise(L, fmt::format("ui.wait takes 0 to {} frames", kMostFrames));
    orRaise(L, driver(L, state).wait(static_cast<int>(frames)));
    return 0;
}

int screenshot(lua_State* L, State& state) {
    UiDriver& ui = driver(L, state);
    const auto file = writablePath(L, textArg(L, 1));
    orRaise(L, makeFolderOf(file));
    orRaise(L, ui.screenshot(file));
    return 0;
}

}  // namespace

void openUiCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"click", luaCall<click>},
                                   {"rightClick", luaCall<rightClick>},
                                   {"drop", luaCall<drop>},
                                   {"set", luaCall<setItem>},
                                   {"get", luaCall<itemText>},
                                   {"exists", luaCall<itemExists>},
                                   {"key", luaCall<key>},
                                   {"drag", luaCall<drag>},
                                   {"rect", luaCall<rect>},
                                   {"wait", luaCall<wait>},
                                   {"screenshot", luaCall<screenshot>}};
    registerCalls(L, "ui", calls);
}

}  // namespace sward::script
