#include "model/field_walk.h"

#include <algorithm>

namespace sward {
namespace {

template <class T>
const T& at(const void* base, const FieldRow& field) {
    return *reinterpret_cast<const T*>(static_cast<const std::byte*>(base) + field.offset);
}
template <class T>
T& at(void* base, const FieldRow& field) {
    return *reinterpret_cast<T*>(static_cast<std::byte*>(base) + field.offset);
}

// Calls f with both values as references to the field's type; lists and enums are left to the caller.
template <class Base, class F>
auto withValues(const FieldRow& field, Base* a, const void* b, F&& f) {
    switch (field.type) {
        case FieldType::Bool:
            return f(at<bool>(a, field), at<bool>(b, field));
        case FieldType::Int:
            return f(at<int>(a, field), at<int>(b, field));
        case FieldType::Float:
            return f(at<float>(a, field), at<float>(b, field));
        case FieldType::Vec2:
            return f(at<glm::dvec2>(a, field), at<glm::dvec2>(b, field));
        case FieldType::Vec3:
            return f(at<glm::dvec3>(a, field), at<glm::dvec3>(b, field));
        case FieldType::Color:
            return f(at<glm::vec3>(a, field), at<glm::vec3>(b, field));
        case FieldType::String:
        case FieldType::Name:
            return f(at<std::string>(a, field), at<std::string>(b, field));
        case FieldType::Map:
            return f(at<MapField>(a, field), at<MapField>(b, field));
        case FieldType::Enum:
        case FieldType::List:
            break;
    }
    checkFailed(__FILE__, __LINE__, "neither a list nor an enum is a value of one type");
}

struct SameValue {
    template <class T>
    bool operator()(const T& a, const T& b) const {
        return a == b;
    }
    bool operator()(const MapField& a, const MapField& b) const { return a.file == b.file && sameTexels(a.map, b.map); }
};
struct CopyValue {
    template <class T>
    void operator()(T& to, const T& from) const {
        to = from;
    }
};

const void* listOf(const FieldRow& field, const void* base) { return &at<std::byte>(base, field); }
void* listOf(const FieldRow& field, void* base) { return &at<std::byte>(base, field); }

bool sameList(const FieldRow& field, const void* a, const void* b) {
    const ListRow& list = *field.list;
    const void *la = listOf(field, a), *lb = listOf(field, b);
    if (list.size(la) != list.size(lb)) return false;
    for (size_t i = 0; i < list.size(la); ++i)
        if (!sameFields(list.fields, list.at(la, i), list.at(lb, i))) return false;
    return true;
}

void copyList(const FieldRow& field, void* to, const void* from) {
    const ListRow& list = *field.list;
    void* into = listOf(field, to);
    const void* of = listOf(field, from);
    list.resize(into, list.size(of));
    for (size_t i = 0; i < list.size(of); ++i) copyFields(list.fields, list.editAt(into, i), list.at(of, i));
}

bool sameField(const FieldRow& field, const void* a, const void* b) {
    if (field.type == FieldType::List) return sameList(field, a, b);
    if (field.type == FieldType::Enum)
        return enumIndex(&at<std::byte>(a, field)) == enumIndex(&at<std::byte>(b, field));
    return withValues(field, a, b, SameValue{});
}

void copyField(const FieldRow& field, void* to, const void* from) {
    if (field.type == FieldType::List) return copyList(field, to, from);
    if (field.type == FieldType::Enum)
        return setEnumIndex(&at<std::byte>(to, field), enumIndex(&at<std::byte>(from, field)));
    withValues(field, to, from, CopyValue{});
}

}  // namespace

bool sameTexels(const Map& a, const Map& b) {
    if (a.info() != b.info()) return false;
    for (int ty = 0; ty < a.tilesY(); ++ty)
        for (int tx = 0; tx < a.tilesX(); ++tx)
            if (!sameTexels(*a.tile(tx, ty), *b.tile(tx, ty))) return false;
    return true;
}

bool sameFields(std::span<const FieldRow> fields, const void* a, const void* b) {
    return std::all_of(fields.begin(), fields.end(), [&](const FieldRow& field) { return sameField(field, a, b); });
}

void copyFields(std::span<const FieldRow> fields, void* to, const void* from) {
    for (const FieldRow& field : fields) copyField(field, to, from);
}

void eachMap(std::span<const FieldRow> fields, const void* component, const std::function<void(const MapField&)>& f) {
    for (const FieldRow& field : fields) {
        if (field.type == FieldType::Map) f(at<MapField>(component, field));
        if (field.type != FieldType::List) continue;
        const void* list = listOf(field, component);
        for (size_t i = 0; i < field.list->size(list); ++i) eachMap(field.list->fields, field.list->at(list, i), f);
    }
}

std::optional<Project> withoutHidden(const Project& p, std::span<const ComponentRow> rows) {
    std::vector<std::string> hidden;
    p.registry.each<Hidden>([&](Entity e, const Hidden&) {
        if (const Name* name = p.registry.get<Name>(e)) hidden.push_back(name->value);
    });
    if (hidden.empty()) return std::nullopt;
    Project shown = snapshot(p, rows);
    for (const std::string& name : hidden) removeEntity(shown, name);
    return shown;
}

const void* componentOf(const Project& p, const std::string& entity, const ComponentRow& row) {
    const auto found = p.entities.find(entity);
    return found == p.entities.end() ? nullptr : row.get(p.registry, found->second);
}

bool sameProject(const Project& a, const Project& b, std::span<const ComponentRow> rows) {
    if (a.name != b.name || a.unknown != b.unknown || a.entities.size() != b.entities.size()) return false;
    for (const auto& [name, entity] : a.entities) {
        if (!b.entities.contains(name)) return false;
        for (const ComponentRow& row : rows) {
            const void *of = componentOf(a, name, row), *other = componentOf(b, name, row);
            if (!of != !other || (of && !sameFields(row.fields, of, other))) return false;
        }
    }
    return true;
}

}  // namespace sward
