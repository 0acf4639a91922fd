// entity.*: list, add, remove, get, set by PATH.
#include "model/entity_edits.h"
#include "script/state.h"
#include "script/values.h"

namespace sward::script {
namespace {

// entity.list() or entity.list("Camera"): names, sorted.
int list(lua_State* L, State& state) {
    const Project& p = openProject(L);
    const ComponentRow* only = nullptr;
    if (!lua_isnoneornil(L, 1) && !(only = findComponent(state.rows(), textArg(L, 1))))
        raise(L, usage(fmt::format("there is no component \"{}\"", textArg(L, 1))));
    lua_newtable(L);
    lua_Integer n = 0;
    for (const auto& [name, entity] : p.entities) {
        if (only && !only->get(p.registry, entity)) continue;
        lua_pushstring(L, name.c_str());
        lua_rawseti(L, -2, ++n);
    }
    return 1;
}

void addComponentFromLua(lua_State* L, State& state, const std::string& entity, const std::string& component,
                         int index) {
    orRaise(L, state.document().addComponent(entity, component));
    setFieldsFromLua(L, entity + "." + component, findComponent(state.rows(), component)->fields, index);
}

// entity.add(name, {Component = {field = value, …}, …})
int add(lua_State* L, State& state) {
    const std::string name = textArg(L, 1);
    openProject(L);
    charge(L, 10000);
    GroupOrNothing group(state.document(), "add " + name);
    orRaise(L, state.document().addEntity(name));
    if (!lua_isnoneornil(L, 2)) {
        luaL_checktype(L, 2, LUA_TTABLE);
        for (lua_pushnil(L); lua_next(L, 2); lua_pop(L, 1)) {
            if (lua_type(L, -2) != LUA_TSTRING) raise(L, "components go by their names: {Camera = {…}}");
            addComponentFromLua(L, state, name, lua_tostring(L, -2), lua_gettop(L));
        }
    }
    group.keep();
    return 0;
}

int remove(lua_State* L, State& state) {
    openProject(L);
    orRaise(L, state.document().removeEntity(textArg(L, 1)));
    return 0;
}

// entity.rename(from, to): fields that name it follow.
int rename(lua_State* L, State& state) {
    openProject(L);
    orRaise(L, renameEntity(state.document(), textArg(L, 1), textArg(L, 2)));
    return 0;
}
// entity.duplicate(name, …): the copies' names.
int duplicate(lua_State* L, State& state) {
    openProject(L);
    std::vector<std::string> names;
    for (int i = 1; i <= std::max(lua_gettop(L), 1); ++i) names.push_back(textArg(L, i));
    const std::vector<std::string> copies = orRaise(L, duplicateEntities(state.document(), names));
    for (const std::string& copy : copies) lua_pushstring(L, copy.c_str());
    return static_cast<int>(copies.size());
}
int removeComponent(lua_State* L, State& state) {
    openProject(L);
    orRaise(L, state.document().removeComponent(textArg(L, 1), textArg(L, 2)));
    return 0;
}
// Elements of lists by PATH; a place counts from 0, as in a PATH.
int addElement(lua_State* L, State& state) {
    openProject(L);
    orRaise(L, state.document().addListElement(textArg(L, 1)));
    return 0;
}
int removeElement(lua_State* L, State& state) {
    openProject(L);
    orRaise(L, state.document().removeListElement(textArg(L, 1)));
    return 0;
}
int moveElement(lua_State* L, State& state) {
    openProject(L);
    const double to = numberArg(L, 2);
    if (!(to >= 0 && to < 1e6)) raise(L, "the place must lie between 0 and a million");
    orRaise(L, state.document().moveListElement(textArg(L, 1), static_cast<size_t>(to)));
    return 0;
}

// What a path without a field names: an entity or one of its components.
struct Whole {
    std::string entity;
    const ComponentRow* component = nullptr;
    const void* value = nullptr;  // of the component, if named
};
std::optional<Whole> wholeOf(const Project& p, State& state, const std::string& path) {
    const size_t dot = path.find('.');
    Whole w{path.substr(0, dot)};
    if (!p.entities.contains(w.entity)) return std::nullopt;
    if (dot == std::string::npos) return w;
    w.component = findComponent(state.rows(), path.substr(dot + 1));
    w.value = w.component ? w.component->get(p.registry, findEntity(p, w.entity)) : nullptr;
    return w.value ? std::optional(w) : std::nullopt;
}

int get(lua_State* L, State& state) {
    const Project& p = openProject(L);
    const std::string path = textArg(L, 1);
    const std::optional<Whole> whole = wholeOf(p, state, path);
    if (!whole) {
        const ConstFieldRef field = orRaise(L, findField(p, state.rows(), path));
        pushField(L, *field.row, field.value);
        return 1;
    }
    if (whole->component) {
        pushFields(L, whole->component->fields, whole->value);
        return 1;
    }
    lua_newtable(L);
    for (const ComponentRow& row : state.rows())
        if (const void* value = row.get(p.registry, findEntity(p, whole->entity))) {
            pushFields(L, row.fields, value);
            lua_setfield(L, -2, row.name);
        }
    return 1;
}

// entity.set(path, value); a component's path takes a table, and gives the component to an entity that lacks it.
int set(lua_State* L, State& state) {
    const Project& p = openProject(L);
    const std::string path = textArg(L, 1);
    luaL_checkany(L, 2);
    GroupOrNothing group(state.document(), "set " + path);
    const size_t dot = path.find('.');
    const std::string entity = path.substr(0, dot), rest = dot == std::string::npos ? "" : path.substr(dot + 1);
    if (const ComponentRow* row = findComponent(state.rows(), rest); row && p.entities.contains(entity)) {
        if (!row->get(p.registry, findEntity(p, entity))) orRaise(L, state.document().addComponent(entity, rest));
        setFieldsFromLua(L, path, row->fields, 2);
    } else {
        const ConstFieldRef field = orRaise(L, findField(p, state.rows(), path));
        setFromLua(L, field.path, *field.row, 2);
    }
    group.keep();
    return 0;
}

}  // namespace

void openEntityCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"list", luaCall<list>},
                                   {"add", luaCall<add>},
                                   {"remove", luaCall<remove>},
                                   {"rename", luaCall<rename>},
                                   {"duplicate", luaCall<duplicate>},
                                   {"removeComponent", luaCall<removeComponent>},
                                   {"addElement", luaCall<addElement>},
                                   {"removeElement", luaCall<removeElement>},
                                   {"moveElement", luaCall<moveElement>},
                                   {"get", luaCall<get>},
                                   {"set", luaCall<set>}};
    registerCalls(L, "entity", calls);
}

}  // namespace sward::script
