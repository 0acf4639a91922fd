#include "scene/rows.h"

#include <map>

namespace sward {
namespace {

// The names of the elements, empty where they have no String field.
std::vector<std::string> elementNames(const ListRow& row, const void* list) {
    const auto named = std::find_if(row.fields.begin(), row.fields.end(),
                                    [](const FieldRow& f) { return f.type == FieldType::String; });
    std::vector<std::string> names(row.size(list));
    if (named == row.fields.end()) return names;
    for (size_t i = 0; i < names.size(); ++i) {
        const auto* element = static_cast<const std::byte*>(row.at(list, i));
        names[i] = *reinterpret_cast<const std::string*>(element + named->offset);
    }
    return names;
}

bool canSelect(const std::string& name) {
    return name.find_first_not_of("0123456789") != std::string::npos && name.find_first_of("[].") == std::string::npos;
}

}  // namespace

std::vector<std::string> elementSelectors(const ListRow& row, const void* list) {
    const std::vector<std::string> names = elementNames(row, list);
    std::map<std::string_view, int> count;
    for (const std::string& name : names) ++count[name];
    std::vector<std::string> out;
    for (size_t i = 0; i < names.size(); ++i)
        out.push_back(canSelect(names[i]) && count[names[i]] == 1 ? names[i] : std::to_string(i));
    return out;
}

const ComponentRow* findComponent(std::span<const ComponentRow> rows, std::string_view name) {
    for (const ComponentRow& row : rows)
        if (name == row.name) return &row;
    return nullptr;
}

}  // namespace sward
