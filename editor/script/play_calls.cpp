// play.*: start, stop, pause, step, input, walkAlong, hash, state of the playtest. Steps are exact: the same script
// gives the same hashes.
#include "core/hash.h"
#include "core/json.h"
#include "playtest/playtest.h"
#include "script/state.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward::script {
namespace {

constexpr double kMostSteps = 10'000'000;
constexpr uint64_t kStepCost = 400;  // instructions of the bound

Playtest& playing(lua_State* L, State& state) {
    openProject(L);
    Playtest* play = state.document().play();
    if (!play) raise(L, "nothing is played; play.start() begins");
    return *play;
}

// {a, b} or {x = a, y = b}, under the name of an option.
std::optional<glm::dvec2> pairOption(lua_State* L, Options& options, const char* name, const char* first,
                                     const char* second) {
    if (!options.push(name)) return std::nullopt;
    glm::dvec2 out{0};
    const bool table = lua_istable(L, -1);
    for (int i = 0; table && i < 2; ++i) {
        if (lua_geti(L, -1, i + 1) == LUA_TNIL) {
            lua_pop(L, 1);
            lua_getfield(L, -1, i == 0 ? first : second);
        }
        out[i] = lua_type(L, -1) == LUA_TNUMBER ? lua_tonumber(L, -1) : std::nan("");
        lua_pop(L, 1);
    }
    if (!table || !std::isfinite(out.x) || !std::isfinite(out.y))
        raise(L, fmt::format("the option {} must be {{{}, {}}} with finite numbers", name, first, second));
    lua_pop(L, 1);
    return out;
}

// The host's view, else that of the camera last used, else the project's first; without one the terrain's corner.
PlayStart startOf(State& state, const Project& p) {
    if (state.host.playStart) return state.host.playStart();
    PlayStart start;
    if (const Camera* camera = findCamera(p, state.host.camera)) start.view = viewOf(*camera);
    start.byClock = false;
    return start;
}

// The walker would be set down at the nearest edge; without ground to walk on, play itself refuses.
void refuseOffTheGround(lua_State* L, const Project& p, const glm::dvec2& at) {
    const Ground ground = findGround(p);
    if (!ground.terrain) return;
    const glm::dvec2 low(ground.origin.x, ground.origin.z), high = low + ground.terrain->size;
    if (glm::all(glm::greaterThanEqual(at, low)) && glm::all(glm::lessThanEqual(at, high))) return;
    raise(L, fmt::format("play.start: at {{{}, {}}} is no ground; x goes from {} to {}, z from {} to {}",
                         shortestText(at.x), shortestText(at.y), shortestText(low.x), shortestText(high.x),
                         shortestText(low.y), shortestText(high.y)));
}

int start(lua_State* L, State& state) {
    const Project& p = openProject(L);
    PlayStart from = startOf(state, p);
    if (!lua_isnoneornil(L, 1)) {
        Options options(L, 1);
        const glm::dvec3 along = from.view.target - from.view.eye;
        if (const auto at = pairOption(L, options, "at", "x", "z")) {
            refuseOffTheGround(L, p, *at);
            from.view.eye.x = at->x, from.view.eye.z = at->y;
        }
        from.view.target = from.view.eye + along;
        from.time = options.number("time", from.time);
        options.finish();
    }
    orRaise(L, state.document().startPlay(from));
    return 0;
}

int stop(lua_State* L, State& state) {
    openProject(L);
    state.document().stopPlay();
    return 0;
}

// play.pause() pauses or goes on; play.pause(true), play.pause(false).
int pause(lua_State* L, State& state) {
    Playtest& play = playing(L, state);
    play.pause(lua_isnoneornil(L, 1) ? !play.paused() : lua_toboolean(L, 1) != 0);
    return 0;
}

int step(lua_State* L, State& state) {
    Playtest& play = playing(L, state);
    const double steps = optionalNumber(L, 1).value_or(1);
    if (steps != std::floor(steps) || steps < 0 || steps > kMostSteps)
        raise(L, fmt::format("play.step takes a whole number of steps, 0 to {}", kMostSteps));
    for (double left = steps; left > 0; left -= 1000) {
        const double now = std::min(left, 1000.0);
        charge(L, static_cast<uint64_t>(now) * kStepCost);
        play.step(static_cast<int64_t>(now));
    }
    return 0;
}

// Holds until the next; what is not named is let go, but the look stays.
int input(lua_State* L, State& state) {
    Playtest& play = playing(L, state);
    Options options(L, 1);
    PlayInput in;
    in.move = pairOption(L, options, "move", "x", "y").value_or(glm::dvec2(0));
    const auto look = pairOption(L, options, "look", "yaw", "pitch");
    in.yaw = look ? glm::radians(look->x) : play.held().yaw;
    in.pitch = look ? glm::radians(look->y) : play.held().pitch;
    in.run = options.flag("run", false);
    in.jump = options.flag("jump", false);
    options.finish();
    play.endWalk();
    play.hold(in);
    return 0;
}

// play.walkAlong("path"): until its end, or the next input.
int walkAlong(lua_State* L, State& state) {
    Playtest& play = playing(L, state);
    orRaise(L, play.walkAlong(luaL_checkstring(L, 1)));
    return 0;
}

int hashPlayState(lua_State* L, State& state) {
    const std::string text = hashHex(hashPlay(playing(L, state).state()));
    lua_pushlstring(L, text.data(), text.size());
    return 1;
}

void field(lua_State* L, const char* name, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, name);
}
void field(lua_State* L, const char* name, bool value) {
    lua_pushboolean(L, value);
    lua_setfield(L, -2, name);
}
void pushPlace(lua_State* L, const glm::dvec3& at) {
    lua_newtable(L);
    field(L, "x", at.x), field(L, "y", at.y), field(L, "z", at.z);
}

// play.state(): {tick, time, paused, walking, walker = {x, y, z, yaw, pitch, onGround, speed}, rolling = {NAME = {x, y,
// z}}, contacts = {{x, y, z, radius, pressed}}}; nil while nothing is played.
int stateTable(lua_State* L, State& state) {
    const Playtest* play = state.document().play();
    if (!play) return lua_pushnil(L), 1;
    const PlayState& s = play->state();
    const Walker& w = s.walker;
    lua_newtable(L);
    lua_pushinteger(L, s.tick);
    lua_setfield(L, -2, "tick");
    field(L, "time", static_cast<double>(s.tick) / kTicksPerSecond);
    field(L, "paused", play->paused()), field(L, "walking", play->walking());
    pushPlace(L, w.position);
    field(L, "yaw", glm::degrees(w.yaw)), field(L, "pitch", glm::degrees(w.pitch));
    field(L, "onGround", w.onGround), field(L, "speed", glm::length(w.velocity));
    lua_setfield(L, -2, "walker");
    lua_newtable(L);
    for (const Roller& r : s.rollers) {
        pushPlace(L, r.position);
        lua_setfield(L, -2, r.name.c_str());
    }
    lua_setfield(L, -2, "rolling");
    lua_newtable(L);
    for (size_t i = 0; i < s.contacts.size(); ++i) {
        pushPlace(L, s.contacts[i].position);
        field(L, "radius", s.contacts[i].radius), field(L, "pressed", s.contacts[i].pressed);
        lua_seti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
    lua_setfield(L, -2, "contacts");
    return 1;
}

}  // namespace

void openPlayCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"start", luaCall<start>},      {"stop", luaCall<stop>},
                                   {"pause", luaCall<pause>},      {"step", luaCall<step>},
                                   {"input", luaCall<input>},      {"hash", luaCall<hashPlayState>},
                                   {"state", luaCall<stateTable>}, {"walkAlong", luaCall<walkAlong>}};
    registerCalls(L, "play", calls);
}

}  // namespace sward::script
