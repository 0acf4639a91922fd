// expect.* and sortedPairs.
#include "script/state.h"

namespace sward::script {
namespace {

std::string shown(lua_State* L, int index) {
    size_t size = 0;
    const char* text = luaL_tolstring(L, index, &size);
    std::string out(text, size);
    lua_pop(L, 1);
    return lua_type(L, index) == LUA_TSTRING ? '"' + out + '"' : out;
}

// The optional last argument says what was expected, in the script's words.
[[noreturn]] void fail(lua_State* L, const std::string& what, int messageArg) {
    const bool said = lua_isstring(L, messageArg);
    raise(L, said ? fmt::format("{}: {}", lua_tostring(L, messageArg), what) : what);
}

bool equalValues(lua_State* L, int a, int b, int depth) {
    a = lua_absindex(L, a);
    b = lua_absindex(L, b);
    if (!lua_istable(L, a) || !lua_istable(L, b) || lua_rawequal(L, a, b)) return lua_compare(L, a, b, LUA_OPEQ);
    if (depth > 50) raise(L, "tables too deep to compare");
    luaL_checkstack(L, 8, nullptr);
    int entries = 0;
    for (lua_pushnil(L); lua_next(L, a); lua_pop(L, 1), ++entries) {
        charge(L, 10);
        lua_pushvalue(L, -2);
        lua_rawget(L, b);
        const bool same = equalValues(L, -2, -1, depth + 1);
        lua_pop(L, 1);
        if (!same) return lua_pop(L, 2), false;
    }
    for (lua_pushnil(L); lua_next(L, b); lua_pop(L, 1)) --entries;
    return entries == 0;
}

// expect.equal(a, b, message): tables by their contents.
int equal(lua_State* L, State&) {
    luaL_checkany(L, 2);
    if (!equalValues(L, 1, 2, 0)) fail(L, fmt::format("expected {} to equal {}", shown(L, 1), shown(L, 2)), 3);
    return 0;
}

// expect.near(a, b, tolerance, message)
int near(lua_State* L, State&) {
    const double a = luaL_checknumber(L, 1), b = luaL_checknumber(L, 2), tolerance = luaL_checknumber(L, 3);
    if (!(std::abs(a - b) <= tolerance))
        fail(L, fmt::format("expected {} to be within {} of {}", shown(L, 1), shown(L, 3), shown(L, 2)), 4);
    return 0;
}

// expect.less(a, b, message)
int less(lua_State* L, State&) {
    const double a = luaL_checknumber(L, 1), b = luaL_checknumber(L, 2);
    if (!(a < b)) fail(L, fmt::format("expected {} to be less than {}", shown(L, 1), shown(L, 2)), 3);
    return 0;
}

// expect.truthy(v, message)
int truthy(lua_State* L, State&) {
    luaL_checkany(L, 1);
    if (!lua_toboolean(L, 1)) fail(L, fmt::format("expected {} to be true", shown(L, 1)), 2);
    return 0;
}

// --- sortedPairs: numbers first, then strings; upvalues: the table, its sorted keys, the last index ------------------

int nextSorted(lua_State* L) {
    const lua_Integer i = lua_tointeger(L, lua_upvalueindex(3)) + 1;
    lua_pushinteger(L, i);
    lua_replace(L, lua_upvalueindex(3));
    if (lua_rawgeti(L, lua_upvalueindex(2), i) == LUA_TNIL) return 1;
    lua_pushvalue(L, -1);
    lua_rawget(L, lua_upvalueindex(1));
    return 2;
}

struct Key {
    bool text;
    double number;
    std::string string;
    bool operator<(const Key& o) const {
        if (text != o.text) return !text;
        return text ? string < o.string : number < o.number;
    }
};

std::vector<Key> sortedKeys(lua_State* L) {
    std::vector<Key> keys;
    for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1)) {
        charge(L, 20);
        const int type = lua_type(L, -2);
        if (type == LUA_TNUMBER)
            keys.push_back({false, lua_tonumber(L, -2), ""});
        else if (type == LUA_TSTRING)
            keys.push_back({true, 0, textArg(L, -2)});
        else
            raise(L, fmt::format("sortedPairs has no order for a key that is a {}", luaL_typename(L, -2)));
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

int sortedPairs(lua_State* L, State&) {
    luaL_checktype(L, 1, LUA_TTABLE);
    lua_settop(L, 1);
    const std::vector<Key> keys = sortedKeys(L);
    lua_createtable(L, static_cast<int>(keys.size()), 0);
    for (size_t i = 0; i < keys.size(); ++i) {
        if (keys[i].text)
            lua_pushlstring(L, keys[i].string.data(), keys[i].string.size());
        else if (lua_Integer whole = 0; lua_numbertointeger(keys[i].number, &whole) && double(whole) == keys[i].number)
            lua_pushinteger(L, whole);
        else
            lua_pushnumber(L, keys[i].number);
        lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, nextSorted, 3);
    return 1;
}

}  // namespace

void openExpectCalls(lua_State* L) {
    constexpr NamedCall calls[] = {
        {"equal", luaCall<equal>}, {"near", luaCall<near>}, {"less", luaCall<less>}, {"truthy", luaCall<truthy>}};
    registerCalls(L, "expect", calls);
    lua_register(L, "sortedPairs", luaCall<sortedPairs>);
}

}  // namespace sward::script
