#include "script/state.h"

#include <cstring>

namespace sward::script {

State::~State() {
    std::error_code ignored;
    for (const auto& dir : tempDirs) std::filesystem::remove_all(dir, ignored);
}

State& stateOf(lua_State* L) {
    State* state;
    std::memcpy(&state, lua_getextraspace(L), sizeof state);
    return *state;
}

void raise(lua_State* L, const Error& error) {
    stateOf(L).lastError = error;
    luaL_error(L, "%s", error.text().c_str());
    std::abort();  // luaL_error does not return
}
void raise(lua_State* L, const std::string& message) { raise(L, failed(message)); }

const Project& openProject(lua_State* L) {
    if (!stateOf(L).document().isOpen()) raise(L, "no project is open; project.open or project.new opens one");
    return stateOf(L).document().project();
}

void registerCalls(lua_State* L, const char* name, std::span<const NamedCall> calls) {
    if (lua_getglobal(L, name) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
    }
    for (const NamedCall& call : calls) {
        lua_pushcfunction(L, call.function);
        lua_setfield(L, -2, call.name);
    }
    lua_setglobal(L, name);
}

// --- arguments ---------------------------------------------------------------------------------------------------

std::string textArg(lua_State* L, int arg) {
    size_t size = 0;
    const char* text = luaL_checklstring(L, arg, &size);
    return {text, size};
}

double numberArg(lua_State* L, int arg) {
    const double value = luaL_checknumber(L, arg);
    luaL_argcheck(L, std::isfinite(value), arg, "a finite number is wanted");
    return value;
}

std::optional<double> optionalNumber(lua_State* L, int arg) {
    if (lua_isnoneornil(L, arg)) return std::nullopt;
    return numberArg(L, arg);
}

Options::Options(lua_State* L, int arg) : L_(L), table_(lua_absindex(L, arg)) { luaL_checktype(L, arg, LUA_TTABLE); }

bool Options::push(const char* name) {
    known_.push_back(name);
    if (lua_getfield(L_, table_, name) != LUA_TNIL) return true;
    lua_pop(L_, 1);
    return false;
}

double Options::number(const char* name) {
    if (!push(name)) raise(L_, fmt::format("the option {} is missing", name));
    const double value = lua_tonumber(L_, -1);
    if (lua_type(L_, -1) != LUA_TNUMBER || !std::isfinite(value))
        raise(L_, fmt::format("the option {} must be a finite number", name));
    lua_pop(L_, 1);
    return value;
}

double Options::number(const char* name, double otherwise) {
    if (!push(name)) return otherwise;
    lua_pop(L_, 1);
    return number(name);
}

std::string Options::text(const char* name) {
    if (!push(name)) raise(L_, fmt::format("the option {} is missing", name));
    if (lua_type(L_, -1) != LUA_TSTRING) raise(L_, fmt::format("the option {} must be a string", name));
    std::string value = lua_tostring(L_, -1);
    lua_pop(L_, 1);
    return value;
}

std::string Options::text(const char* name, const char* otherwise) {
    if (!push(name)) return otherwise;
    lua_pop(L_, 1);
    return text(name);
}

bool Options::flag(const char* name, bool otherwise) {
    if (!push(name)) return otherwise;
    const bool value = lua_toboolean(L_, -1);
    lua_pop(L_, 1);
    return value;
}

void Options::finish() {
    std::vector<std::string> strangers;
    for (lua_pushnil(L_); lua_next(L_, table_); lua_pop(L_, 1)) {
        if (lua_type(L_, -2) != LUA_TSTRING)
            strangers.push_back("a value without a name");
        else if (std::string name = lua_tostring(L_, -2); std::find(known_.begin(), known_.end(), name) == known_.end())
            strangers.push_back(name);
    }
    if (strangers.empty()) return;
    std::sort(strangers.begin(), strangers.end());
    std::string names;
    for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
    raise(L_, fmt::format("no option is called {}; there are {}", strangers[0], names));
}

glm::vec3 vectorOption(lua_State* L, Options& options, const char* name, const glm::vec3& otherwise, float most) {
    if (!options.push(name)) return otherwise;
    glm::vec3 out(0);
    const bool table = lua_istable(L, -1) && luaL_len(L, -1) == 3;
    for (int c = 0; c < 3 && table; ++c) {
        lua_geti(L, -1, c + 1);
        out[c] = lua_type(L, -1) == LUA_TNUMBER ? static_cast<float>(lua_tonumber(L, -1)) : NAN;
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    const auto sound = [most](float v) { return std::isfinite(v) && std::abs(v) <= most; };
    if (!table || !sound(out.x) || !sound(out.y) || !sound(out.z))
        raise(L, fmt::format("{} must be three numbers within {}", name, most));
    return out;
}

std::vector<std::pair<double, double>> pointsArg(lua_State* L, int index, const char* what) {
    index = lua_absindex(L, index);
    if (!lua_istable(L, index)) raise(L, fmt::format("{} must be a list of points {{{{x, z}}, …}}", what));
    std::vector<std::pair<double, double>> points;
    const auto coordinate = [&](int i) {
        lua_geti(L, -1, i);
        const double value = lua_type(L, -1) == LUA_TNUMBER ? lua_tonumber(L, -1) : std::nan("");
        lua_pop(L, 1);
        return value;
    };
    const lua_Integer count = luaL_len(L, index);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_geti(L, index, i);
        const bool table = lua_istable(L, -1);
        const double x = table ? coordinate(1) : 0, z = table ? coordinate(2) : 0;
        if (!table || !std::isfinite(x) || !std::isfinite(z))
            raise(L, fmt::format("point {} of {} is not {{x, z}} with finite numbers", i, what));
        points.emplace_back(x, z);
        lua_pop(L, 1);
        charge(L, 1);
    }
    return points;
}

}  // namespace sward::script
