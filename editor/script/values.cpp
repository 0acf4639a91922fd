#include "script/values.h"

namespace sward::script {
namespace {

template <class T>
const T& as(const void* value) {
    return *static_cast<const T*>(value);
}

template <class V>
void pushVector(lua_State* L, const V& v) {
    lua_createtable(L, static_cast<int>(v.length()), 0);
    for (int i = 0; i < v.length(); ++i) {
        lua_pushnumber(L, static_cast<lua_Number>(v[i]));
        lua_rawseti(L, -2, i + 1);
    }
}

// A float's shortest decimal form, so that 0.1 in a file is 0.1 in a script.
void pushFloat(lua_State* L, float v) {
    lua_pushnumber(L, std::isfinite(v) ? std::strtod(fmt::format("{}", v).c_str(), nullptr) : v);
}

void pushColor(lua_State* L, const glm::vec3& c) {
    lua_createtable(L, 3, 0);
    for (int i = 0; i < 3; ++i) {
        pushFloat(L, c[i]);
        lua_rawseti(L, -2, i + 1);
    }
}

void pushList(lua_State* L, const ListRow& list, const void* value) {
    const size_t n = list.size(value);
    lua_createtable(L, static_cast<int>(n), 0);
    for (size_t i = 0; i < n; ++i) {
        pushFields(L, list.fields, list.at(value, i));
        lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
}

std::string numberText(lua_Number n) {
    if (std::isinf(n)) return n > 0 ? "inf" : "-inf";
    return fmt::format("{}", n);
}

// The value at index as Document::setField reads it.
std::string fieldTextOf(lua_State* L, const std::string& path, int index) {
    switch (lua_type(L, index)) {
        case LUA_TNUMBER:
            return lua_isinteger(L, index) ? std::to_string(lua_tointeger(L, index))
                                           : numberText(lua_tonumber(L, index));
        case LUA_TSTRING:
            return lua_tostring(L, index);
        case LUA_TBOOLEAN:
            return lua_toboolean(L, index) ? "true" : "false";
        case LUA_TNIL:
            return "";
        case LUA_TTABLE:
            break;
        default:
            raise(L, fmt::format("{}: a field cannot be a {}", path, luaL_typename(L, index)));
    }
    std::string text = "[";
    const lua_Integer count = luaL_len(L, index);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_geti(L, index, i);
        if (lua_type(L, -1) != LUA_TNUMBER) raise(L, fmt::format("{}: element {} is no number", path, i));
        text += (i > 1 ? ", " : "") + numberText(lua_tonumber(L, -1));
        lua_pop(L, 1);
        charge(L, 10);
    }
    return text + "]";
}

size_t listSize(lua_State* L, const std::string& path) {
    const ConstFieldRef field = orRaise(L, findField(openProject(L), stateOf(L).rows(), path));
    return field.row->list->size(field.value);
}

void setListFromLua(lua_State* L, const std::string& path, const FieldRow& field, int index) {
    Document& document = stateOf(L).document();
    if (!lua_istable(L, index)) raise(L, path + ": a list of tables is wanted");
    const size_t wanted = static_cast<size_t>(luaL_len(L, index));
    size_t have = listSize(L, path);
    for (; have < wanted; ++have) {
        charge(L, 10000);
        orRaise(L, document.addListElement(path));
    }
    for (; have > wanted; --have) orRaise(L, document.removeListElement(fmt::format("{}[{}]", path, have - 1)));
    for (size_t i = 0; i < wanted; ++i) {
        lua_geti(L, index, static_cast<lua_Integer>(i) + 1);
        setFieldsFromLua(L, fmt::format("{}[{}]", path, i), field.list->fields, lua_gettop(L));
        lua_pop(L, 1);
    }
}

}  // namespace

void pushField(lua_State* L, const FieldRow& field, const void* value) {
    switch (field.type) {
        case FieldType::Bool:
            return lua_pushboolean(L, as<bool>(value));
        case FieldType::Int:
            return lua_pushinteger(L, as<int>(value));
        case FieldType::Enum:
            return static_cast<void>(lua_pushstring(L, field.options[static_cast<size_t>(enumIndex(value))]));
        case FieldType::Float:
            return pushFloat(L, as<float>(value));
        case FieldType::Vec2:
            return pushVector(L, as<glm::dvec2>(value));
        case FieldType::Vec3:
            return pushVector(L, as<glm::dvec3>(value));
        case FieldType::Color:
            return pushColor(L, as<glm::vec3>(value));
        case FieldType::String:
            return static_cast<void>(lua_pushstring(L, as<std::string>(value).c_str()));
        case FieldType::List:
            return pushList(L, *field.list, value);
        case FieldType::Map:
            break;
    }
    const auto& map = as<MapField>(value);
    if (map.present())
        lua_pushstring(L, map.file.c_str());
    else
        lua_pushnil(L);
}

void pushFields(lua_State* L, std::span<const FieldRow> fields, const void* base) {
    luaL_checkstack(L, 4, nullptr);
    lua_createtable(L, 0, static_cast<int>(fields.size()));
    for (const FieldRow& field : fields) {
        pushField(L, field, static_cast<const std::byte*>(base) + field.offset);
        lua_setfield(L, -2, field.name);
    }
}

void setFromLua(lua_State* L, const std::string& path, const FieldRow& field, int index) {
    charge(L, 1000);
    index = lua_absindex(L, index);
    if (field.type == FieldType::List) return setListFromLua(L, path, field, index);
    const bool clearsMap = field.type == FieldType::Map && lua_isnil(L, index);
    if (lua_isnil(L, index) && !clearsMap) raise(L, path + ": nil is no value");
    orRaise(L, stateOf(L).document().setField(path, fieldTextOf(L, path, index)));
}

void setFieldsFromLua(lua_State* L, const std::string& path, std::span<const FieldRow> fields, int index) {
    index = lua_absindex(L, index);
    if (!lua_istable(L, index)) raise(L, path + ": a table of fields is wanted");
    luaL_checkstack(L, 8, nullptr);
    for (const FieldRow& field : fields) {
        if (lua_getfield(L, index, field.name) != LUA_TNIL) setFromLua(L, path + "." + field.name, field, -1);
        lua_pop(L, 1);
    }
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
        const std::string name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "a number";
        const bool known = std::any_of(fields.begin(), fields.end(), [&](const FieldRow& f) { return name == f.name; });
        if (!known) orRaise(L, findField(openProject(L), stateOf(L).rows(), path + "." + name));  // says what there is
        if (!known) raise(L, fmt::format("{}: no field is called {}", path, name));
    }
}

}  // namespace sward::script
