#include "project/project_json.h"

namespace sward {
namespace {

const void* at(const void* base, const FieldRow& row) { return static_cast<const std::byte*>(base) + row.offset; }

struct Writer {
    const Project& project;
    const std::map<const void*, std::string>& files;
};

template <class V>
Json vectorJson(const void* value) {
    const V& v = *static_cast<const V*>(value);
    Json j = Json::makeArray();
    for (int i = 0; i < v.length(); ++i) j.push(Json(v[i]));
    return j;
}

std::string unescaped(std::string_view key) {
    std::string out;
    for (size_t i = 0; i < key.size(); ++i) {
        if (key[i] != '%' || i + 2 >= key.size()) {
            out += key[i];
            continue;
        }
        const std::string_view code = key.substr(i + 1, 2);
        out += code == "25" ? '%' : code == "2e" ? '.' : code == "5b" ? '[' : ']';
        i += 2;
    }
    return out;
}

// Puts back what load did not know directly under `path`.
void addUnknown(const Writer& w, const std::string& path, Json& j) {
    const std::string prefix = path + ".";
    for (auto it = w.project.unknown.lower_bound(prefix);
         it != w.project.unknown.end() && it->first.starts_with(prefix); ++it) {
        const std::string key = it->first.substr(prefix.size());
        if (key.find('.') != std::string::npos) continue;  // it lies deeper
        if (Result<Json> value = parseJson(it->second, ""); value) j.object.emplace(unescaped(key), std::move(*value));
    }
}

Json fieldsJson(const Writer& w, std::span<const FieldRow> rows, const void* base, const std::string& path);

Json listJson(const Writer& w, const FieldRow& row, const void* list, const std::string& path) {
    const std::vector<std::string> selectors = elementSelectors(*row.list, list);
    Json j = Json::makeArray();
    for (size_t i = 0; i < selectors.size(); ++i)
        j.push(fieldsJson(w, row.list->fields, row.list->at(list, i), fmt::format("{}[{}]", path, selectors[i])));
    return j;
}

Json mapJson(const Writer& w, const void* value) {
    const auto it = w.files.find(value);
    return Json(it != w.files.end() ? it->second : static_cast<const MapField*>(value)->file);
}

// Null: nothing to write (no map, no file).
Json fieldJson(const Writer& w, const FieldRow& row, const void* value, const std::string& path) {
    switch (row.type) {
        case FieldType::Bool:
            return Json(*static_cast<const bool*>(value));
        case FieldType::Int:
            return Json(*static_cast<const int*>(value));
        case FieldType::Float:
            return Json(*static_cast<const float*>(value));
        case FieldType::Vec2:
            return vectorJson<glm::dvec2>(value);
        case FieldType::Vec3:
            return vectorJson<glm::dvec3>(value);
        case FieldType::Color:
            return vectorJson<glm::vec3>(value);
        case FieldType::Enum:
            return Json(row.options[static_cast<size_t>(enumIndex(value))]);
        case FieldType::List:
            return listJson(w, row, value, path);
        case FieldType::Map: {
            Json j = mapJson(w, value);
            return j.text.empty() ? Json() : j;
        }
        case FieldType::Name:
            return Json(*static_cast<const std::string*>(value));
        case FieldType::String: {
            const auto& text = *static_cast<const std::string*>(value);
            return row.isFile && text.empty() ? Json() : Json(text);
        }
    }
    return {};
}

Json fieldsJson(const Writer& w, std::span<const FieldRow> rows, const void* base, const std::string& path) {
    Json j = Json::makeObject();
    for (const FieldRow& row : rows) {
        Json value = fieldJson(w, row, at(base, row), path + "." + row.name);
        if (!value.isNull()) j.object[row.name] = std::move(value);
    }
    addUnknown(w, path, j);
    return j;
}

// Whether settings are written as their defaults would be: those that are absent hold the same.
bool isUsual(const Writer& w, const ComponentRow& row, const Json& fields) {
    return writeJson(fields) == writeJson(fieldsJson(w, row.fields, row.defaults(), "."));
}

Json importsJson(const Project& p) {
    Json j = Json::makeObject();
    for (const auto& [path, import] : p.imports) {
        Json& one = j[path];
        one["file"] = Json(import.file);
        one["flip"] = Json(import.flip);
        if (import.range) one["range"] = Json(Json::Array{Json(import.range->first), Json(import.range->second)});
    }
    return j;
}

Status checkField(const FieldRow& row, const std::string& path, double value) {
    const bool never = row.allowInf && value > 0 && std::isinf(value);
    // A float that was rounded from a limit may lie a hair outside it.
    const double low = std::min<double>(row.hardMin, float(row.hardMin)),
                 high = std::max<double>(row.hardMax, float(row.hardMax));
    if (never || (value >= low && value <= high)) return {};
    return failed(fmt::format("{}: {} cannot be saved: out of range", path, shortestText(value)),
                  fmt::format("set it between {} and {}", shortestText(row.hardMin), shortestText(row.hardMax)));
}

template <class V>
Status checkVector(const FieldRow& row, const std::string& path, const void* value) {
    const V& v = *static_cast<const V*>(value);
    for (int i = 0; i < v.length(); ++i)
        if (Status s = checkField(row, path, double(v[i])); !s) return s;
    return {};
}

Status checkWritable(std::span<const FieldRow> rows, const void* base, const std::string& path);

Status checkOne(const FieldRow& row, const void* value, const std::string& path) {
    switch (row.type) {
        case FieldType::Int:
            return checkField(row, path, *static_cast<const int*>(value));
        case FieldType::Float:
            return checkField(row, path, *static_cast<const float*>(value));
        case FieldType::Vec2:
            return checkVector<glm::dvec2>(row, path, value);
        case FieldType::Vec3:
            return checkVector<glm::dvec3>(row, path, value);
        case FieldType::Color:
            return checkVector<glm::vec3>(row, path, value);
        case FieldType::List:
            for (size_t i = 0; i < row.list->size(value); ++i)
                if (Status s = checkWritable(row.list->fields, row.list->at(value, i), fmt::format("{}[{}]", path, i));
                    !s)
                    return s;
            return {};
        default:
            return {};
    }
}

Status checkWritable(std::span<const FieldRow> rows, const void* base, const std::string& path) {
    for (const FieldRow& row : rows)
        if (Status s = checkOne(row, at(base, row), path + "." + row.name); !s) return s;
    return {};
}

}  // namespace

Json projectJson(const Project& p, std::span<const ComponentRow> rows,
                 const std::map<const void*, std::string>& files) {
    const Writer w{p, files};
    Json j = Json::makeObject();
    j["format"] = Json(kProjectFormat);
    j["name"] = Json(p.name);
    if (!p.imports.empty()) j["imports"] = importsJson(p);
    Json& entities = j["entities"] = Json::makeObject();
    for (const auto& [name, entity] : p.entities) {
        Json& one = entities[name] = Json::makeObject();
        for (const ComponentRow& row : rows)
            if (const void* component = row.get(p.registry, entity)) {
                Json fields = fieldsJson(w, row.fields, component, name + "." + row.name);
                if (!row.settingsOf || !isUsual(w, row, fields)) one[row.name] = std::move(fields);
            }
        addUnknown(w, name, one);
    }
    addUnknown(w, "", j);
    return j;
}

Status checkValues(const Project& p, std::span<const ComponentRow> rows) {
    for (const auto& [name, entity] : p.entities)
        for (const ComponentRow& row : rows)
            if (const void* component = row.get(p.registry, entity))
                if (Status s = checkWritable(row.fields, component, name + "." + row.name); !s) return s;
    return {};
}

}  // namespace sward
