// Builders of FieldRows: one a type of field, so that a line of a component's table says only what differs.
// Does not: hold any table; each stands beside its component.
#pragma once
#include <cstddef>
#include <limits>

#include "core/enum_names.h"
#include "scene/rows.h"

namespace sward {

inline constexpr double kFarM = 1e8;         // no position lies farther from the origin
inline constexpr double kBrightest = 65504;  // the largest half: brighter light would turn infinite in a render target

// What a number may be: outside hard it is refused, soft is the slider's range.
struct Range {
    double hardMin, hardMax, softMin, softMax;
};
inline constexpr Range kShare{0, 1, 0, 1};
inline constexpr Range kTiling{0.001, 10000, 1, 50};
inline constexpr Range kReflectance{0, 1, 0, 0.5};
inline constexpr Range kPosition{-kFarM, kFarM, -1000, 1000};

// A field of any type. offset: of the member in its struct, bytes; unit: "m", "deg", or "" for none.
constexpr FieldRow number(FieldType type, const char* name, size_t offset, const char* unit, Range r,
                          const char* help) {
    return {name, type, offset, unit, r.hardMin, r.hardMax, r.softMin, r.softMax, help};
}
// The row as an inspector calls it, where its name says little.
constexpr FieldRow titled(const char* title, FieldRow row) {
    row.title = title;
    return row;
}
// The row of a field that does something only where `acts` says so of its struct.
constexpr FieldRow where(bool (*acts)(const void* owner), FieldRow row) {
    row.acts = acts;
    return row;
}
// The row, and those that follow it, under a heading of the inspector. kAdvanced is closed at first.
constexpr FieldRow under(const char* group, FieldRow row) {
    row.group = group;
    return row;
}
inline constexpr const char* kAdvanced = "Advanced";
// A float.
constexpr FieldRow real(const char* name, size_t offset, const char* unit, Range r, const char* help) {
    return number(FieldType::Float, name, offset, unit, r, help);
}
// Two floats, most often from and to.
constexpr FieldRow twoReals(const char* name, size_t offset, const char* unit, Range r, const char* help) {
    return number(FieldType::Vec2, name, offset, unit, r, help);
}
// A float in metres that may be infinite.
constexpr FieldRow distance(const char* name, size_t offset, Range r, const char* help) {
    FieldRow row = real(name, offset, "m", r, help);
    row.allowInf = true;
    return row;
}
// A float in seconds that may be infinite.
constexpr FieldRow seconds(const char* name, size_t offset, Range r, const char* help) {
    FieldRow row = distance(name, offset, r, help);
    row.unit = "s";
    return row;
}
// A linear colour, glm::vec3.
constexpr FieldRow color(const char* name, size_t offset, Range r, const char* help) {
    return number(FieldType::Color, name, offset, "", r, help);
}
// A std::string.
constexpr FieldRow text(const char* name, size_t offset, const char* help) {
    return number(FieldType::String, name, offset, "", {}, help);
}
// The name of an image file in the project's folder, or empty.
constexpr FieldRow imageFile(const char* name, size_t offset, const char* help) {
    FieldRow row = text(name, offset, help);
    row.isFile = true;
    return row;
}
// The name of a glTF file in the project's folder, or empty.
constexpr FieldRow meshFile(const char* name, size_t offset, const char* help) {
    FieldRow row = imageFile(name, offset, help);
    row.isMesh = true;
    return row;
}
// The name of an entity, or empty.
constexpr FieldRow entityName(const char* name, size_t offset, const char* help) {
    FieldRow row = text(name, offset, help);
    row.isEntity = true;
    return row;
}
// A bool.
constexpr FieldRow flag(const char* name, size_t offset, const char* help) {
    return number(FieldType::Bool, name, offset, "", {}, help);
}
// A whole number, int.
constexpr FieldRow whole(const char* name, size_t offset, const char* unit, Range r, const char* help) {
    return number(FieldType::Int, name, offset, unit, r, help);
}
// A member of an enum; its names must be of the same enum.
template <class C, class E>
constexpr FieldRow choice(const char* name, E C::*, size_t offset, const EnumNames<E>& options, const char* help) {
    FieldRow row = number(FieldType::Enum, name, offset, "", {}, help);
    row.options = options;
    return row;
}
// A std::string that names a row of a table; whoever knows the table sets the options.
constexpr FieldRow name(const char* fieldName, size_t offset, const char* help) {
    return number(FieldType::Name, fieldName, offset, "", {}, help);
}
// A painted map. `known` must outlive the row; fields beside the map that it names must stand in the same table.
constexpr FieldRow map(const char* fieldName, size_t offset, const MapRow* known, const char* help) {
    FieldRow row = number(FieldType::Map, fieldName, offset, "", {}, help);
    row.map = known;
    if (known->kind == MapKind::Heights) row.unit = "m";
    return row;
}
// How often a map repeats over Terrain.mapSize, a float.
constexpr FieldRow tiling(const char* fieldName, size_t offset, const char* help) {
    return real(fieldName, offset, "", kTiling, help);
}
// A list of structs, each described by `list`.
constexpr FieldRow listOf(const char* name, size_t offset, const ListRow* list, const char* help) {
    FieldRow row = number(FieldType::List, name, offset, "", {}, help);
    row.list = list;
    return row;
}

}  // namespace sward
