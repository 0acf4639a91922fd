// help(), and what a console's word may become: the names that Lua knows, by tables.
#include <algorithm>

#include "script/state.h"

namespace sward::script {
namespace {

// Whether a global or a field of one is on the stack now, and a table: "map", "_G". Pushes nothing if not.
bool pushTable(lua_State* L, const std::string& name) {
    lua_pushglobaltable(L);
    if (name.empty()) return true;
    lua_pushlstring(L, name.data(), name.size());
    lua_rawget(L, -2);
    lua_remove(L, -2);
    if (lua_istable(L, -1)) return true;
    lua_pop(L, 1);
    return false;
}

struct NameList {
    std::string table, beginning;
    bool callsOnly = false;
    std::vector<std::string> names = {};
};

// Of what lies in the table, by upvalue: run protected, since Lua may be out of memory.
int listNames(lua_State* L) {
    auto& list = *static_cast<NameList*>(lua_touserdata(L, 1));
    if (!pushTable(L, list.table)) return 0;
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING) continue;
        const std::string name = lua_tostring(L, -2);
        const bool listed = !list.callsOnly || lua_isfunction(L, -1);
        if (listed && name.starts_with(list.beginning) && name.compare(0, 1, "_") != 0) list.names.push_back(name);
    }
    std::sort(list.names.begin(), list.names.end());
    return 0;
}

std::vector<std::string> namesOf(lua_State* L, NameList list) {
    lua_pushcfunction(L, listNames);
    lua_pushlightuserdata(L, &list);
    if (lua_pcall(L, 1, 0, 0) != LUA_OK) lua_pop(L, 1);
    return list.names;
}

void printLine(lua_State* L, const std::string& line) {
    lua_getglobal(L, "print");
    lua_pushlstring(L, line.data(), line.size());
    lua_call(L, 1, 0);
}

std::string joined(const std::vector<std::string>& names, const std::string& before) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : "  ") + before + name;
    return text;
}

int help(lua_State* L, State&) {
    const std::string table = lua_isnoneornil(L, 1) ? "" : textArg(L, 1);
    const std::vector<std::string> names = namesOf(L, {table, "", true});
    if (names.empty()) raise(L, fmt::format("help: there are no calls in '{}'; help() lists all tables", table));
    if (!table.empty()) {
        printLine(L, joined(names, table + "."));
        return 0;
    }
    for (const std::string& name : namesOf(L, {}))
        if (const auto calls = namesOf(L, {name, "", true}); !calls.empty())
            printLine(L, name + ":  " + joined(calls, ""));
    printLine(L, "and:  " + joined(names, ""));
    printLine(L, "What each does: docs/scripting.md. Tab completes a name, the arrows bring former lines back.");
    return 0;
}

}  // namespace

std::vector<std::string> completionsOf(lua_State* L, const std::string& word) {
    const size_t dot = word.find('.');
    if (dot == std::string::npos) return namesOf(L, {"", word});
    std::vector<std::string> names = namesOf(L, {word.substr(0, dot), word.substr(dot + 1)});
    for (std::string& name : names) name = word.substr(0, dot + 1) + name;
    return names;
}

void openHelp(lua_State* L) { lua_register(L, "help", luaCall<help>); }

}  // namespace sward::script
