#include "scene/rows.h"

#include <charconv>
#include <unordered_map>

namespace sward {
namespace {

// The first String field of the elements, or null: their names.
const FieldRow* nameField(const ListRow& row) {
    const auto named = std::find_if(row.fields.begin(), row.fields.end(),
                                    [](const FieldRow& f) { return f.type == FieldType::String; });
    return named == row.fields.end() ? nullptr : &*named;
}
const std::string& nameOf(const ListRow& row, const FieldRow& field, const void* list, size_t i) {
    return *reinterpret_cast<const std::string*>(static_cast<const std::byte*>(row.at(list, i)) + field.offset);
}

bool canSelect(const std::string& name) {
    return name.find_first_not_of("0123456789") != std::string::npos && name.find_first_of("[].") == std::string::npos;
}

// The only element of a name.
std::optional<size_t> elementNamed(const ListRow& row, const FieldRow& field, const void* list,
                                   const std::string& name) {
    std::optional<size_t> found;
    for (size_t i = 0; i < row.size(list); ++i) {
        if (nameOf(row, field, list, i) != name) continue;
        if (found) return {};
        found = i;
    }
    return found;
}

}  // namespace

std::vector<std::string> elementSelectors(const ListRow& row, const void* list) {
    const FieldRow* named = nameField(row);
    std::unordered_map<std::string_view, int> count;
    for (size_t i = 0; named && i < row.size(list); ++i) ++count[nameOf(row, *named, list, i)];
    std::vector<std::string> out;
    for (size_t i = 0; i < row.size(list); ++i) {
        const bool byName =
            named && canSelect(nameOf(row, *named, list, i)) && count[nameOf(row, *named, list, i)] == 1;
        out.push_back(byName ? nameOf(row, *named, list, i) : std::to_string(i));
    }
    return out;
}

std::string elementSelector(const ListRow& row, const void* list, size_t i) {
    const FieldRow* named = nameField(row);
    if (!named || !canSelect(nameOf(row, *named, list, i))) return std::to_string(i);
    const std::string& name = nameOf(row, *named, list, i);
    return elementNamed(row, *named, list, name) == i ? name : std::to_string(i);
}

std::optional<size_t> selectedElement(const ListRow& row, const void* list, const std::string& selector) {
    const FieldRow* named = nameField(row);
    if (canSelect(selector)) return named ? elementNamed(row, *named, list, selector) : std::nullopt;
    size_t number = 0;
    const char* end = selector.data() + selector.size();
    const auto read = std::from_chars(selector.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end || number >= row.size(list)) return {};
    return number;
}

const ComponentRow* findComponent(std::span<const ComponentRow> rows, std::string_view name) {
    for (const ComponentRow& row : rows)
        if (name == row.name) return &row;
    return nullptr;
}

}  // namespace sward
