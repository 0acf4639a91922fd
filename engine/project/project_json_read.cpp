// Reading. Index: messages · format · values by type · fields · components and entities · imports.
#include "core/file.h"
#include "project/project_json.h"

namespace sward {
namespace {

void* at(void* base, const FieldRow& row) { return static_cast<std::byte*>(base) + row.offset; }

// --- messages ----------------------------------------------------------------------------------------------------
void refuse(ProjectReader& r, const Json& where, std::string message, std::string remedy = {}) {
    r.refused.push_back(unsound(std::move(message), std::move(remedy)).at(r.file, where.line, where.column));
}
void report(ProjectReader& r, int line, std::string message) {
    r.repaired.push_back({fmt::format("{}:{}", r.file, line), std::move(message)});
}

// A key within a path of Project::unknown.
std::string escaped(const std::string& key) {
    std::string out;
    for (const char c : key)
        out += c == '%' ? "%25" : c == '.' ? "%2e" : c == '[' ? "%5b" : c == ']' ? "%5d" : std::string(1, c);
    return out;
}
void keepUnknown(ProjectReader& r, const std::string& parent, const std::string& key, const Json& value,
                 const char* what) {
    r.project.unknown[parent + "." + escaped(key)] = writeJson(value);
    report(r, value.keyLine,
           fmt::format("unknown {} \"{}{}{}\" (kept as it is)", what, parent, parent.empty() ? "" : ".", key));
}

// --- values by type ----------------------------------------------------------------------------------------------
std::string rangeText(const FieldRow& row) {
    return fmt::format("it takes {} to {}{}{}{}", shortestText(row.hardMin), shortestText(row.hardMax),
                       row.unit[0] ? " " : "", row.unit, row.allowInf ? " or \"inf\"" : "");
}

bool readNumber(ProjectReader& r, const FieldRow& row, const std::string& path, const Json& j, double& value) {
    if (j.isString() && j.text == "inf" && row.allowInf) {
        value = std::numeric_limits<double>::infinity();
        return true;
    }
    if (j.isString() && (j.text == "inf" || j.text == "-inf" || j.text == "nan")) {
        refuse(r, j, fmt::format("{}: \"{}\" is not allowed here", path, j.text), rangeText(row));
        return false;
    }
    if (!j.isNumber()) {
        refuse(r, j, fmt::format("{}: must be a number, not {}", path, jsonTypeName(j.type)), rangeText(row));
        return false;
    }
    if (!(j.number >= row.hardMin && j.number <= row.hardMax)) {
        const char* why = j.number < 0 && row.hardMin >= 0 ? "must not be negative" : "is out of range";
        refuse(r, j, fmt::format("{}: {} {}", path, j.text, why), rangeText(row));
        return false;
    }
    value = j.number;
    return true;
}

template <class V, class T>
void readVector(ProjectReader& r, const FieldRow& row, const std::string& path, const Json& j, void* out) {
    V value{};
    const auto length = size_t(value.length());
    if (!j.isArray() || j.array.size() != length)
        return refuse(r, j, fmt::format("{}: must be a list of {} numbers", path, length));
    for (size_t i = 0; i < length; ++i) {
        double number = 0;
        if (!readNumber(r, row, path, j.array[i], number)) return;
        value[int(i)] = static_cast<T>(number);
    }
    *static_cast<V*>(out) = value;
}

void readInt(ProjectReader& r, const FieldRow& row, const std::string& path, const Json& j, void* out) {
    double number = 0;
    if (!readNumber(r, row, path, j, number)) return;
    if (number != std::floor(number))
        return refuse(r, j, fmt::format("{}: {} is not a whole number", path, j.text), rangeText(row));
    *static_cast<int*>(out) = static_cast<int>(number);
}

void readFloat(ProjectReader& r, const FieldRow& row, const std::string& path, const Json& j, void* out) {
    double number = 0;
    if (readNumber(r, row, path, j, number)) *static_cast<float*>(out) = static_cast<float>(number);
}

void readBool(ProjectReader& r, const std::string& path, const Json& j, void* out) {
    if (!j.isBool()) return refuse(r, j, fmt::format("{}: must be true or false, not {}", path, jsonTypeName(j.type)));
    *static_cast<bool*>(out) = j.boolean;
}

// Calls set(number) for the option that is named.
template <class Set>
void readOption(ProjectReader& r, const FieldRow& row, const std::string& path, const Json& j, Set&& set) {
    std::string names;
    for (size_t i = 0; i < row.options.size(); ++i) {
        if (j.isString() && j.text == row.options[i]) {
            set(i);
            return;
        }
        names += fmt::format("{}\"{}\"", i ? ", " : "", row.options[i]);
    }
    refuse(
        r, j,
        fmt::format("{}: {} is none of its values", path, j.isString() ? "\"" + j.text + "\"" : jsonTypeName(j.type)),
        "it takes " + names);
}

// Where a file may lie is checked by its spelling here; symbolic links are followed when it is opened.
bool readPath(ProjectReader& r, const std::string& path, const Json& j) {
    if (!j.isString()) {
        refuse(r, j, fmt::format("{}: must be a string, not {}", path, jsonTypeName(j.type)));
        return false;
    }
    if (j.text.empty()) return true;
    const Status inside = checkInside(j.text);
    if (inside && !j.text.starts_with(".sward-")) return true;
    refuse(r, j, fmt::format("{}: {}", path, inside ? "names a file of Sward's own" : inside.error().message),
           "name a file inside the project's folder");
    return false;
}

void readString(ProjectReader& r, const FieldRow& row, const std::string& path, const Json& j, void* out) {
    if (row.isFile && !readPath(r, path, j)) return;
    if (!j.isString()) return refuse(r, j, fmt::format("{}: must be a string, not {}", path, jsonTypeName(j.type)));
    *static_cast<std::string*>(out) = j.text;
}

void readMapFile(ProjectReader& r, const std::string& path, const Json& j, void* out) {
    if (readPath(r, path, j)) static_cast<MapField*>(out)->file = j.text;
}

// --- fields ------------------------------------------------------------------------------------------------------
void readFields(ProjectReader& r, std::span<const FieldRow> rows, const std::string& path, const Json& j, void* base);

// Names come first, for the paths of elements are made of them.
void readNames(const ListRow& list, const Json& j, void* out) {
    const auto named = std::find_if(list.fields.begin(), list.fields.end(),
                                    [](const FieldRow& f) { return f.type == FieldType::String; });
    if (named == list.fields.end()) return;
    for (size_t i = 0; i < j.array.size(); ++i)
        if (const Json* name = j.array[i].find(named->name); name && name->isString())
            *static_cast<std::string*>(at(list.editAt(out, i), *named)) = name->text;
}

void readList(ProjectReader& r, const FieldRow& row, const std::string& path, const Json& j, void* out) {
    if (!j.isArray()) return refuse(r, j, fmt::format("{}: must be a list, not {}", path, jsonTypeName(j.type)));
    if (j.array.size() > kMaxListElements)
        return refuse(r, j, fmt::format("{}: {} elements; the limit is {}", path, j.array.size(), kMaxListElements));
    row.list->resize(out, 0);
    row.list->resize(out, j.array.size());
    readNames(*row.list, j, out);
    const std::vector<std::string> selectors = elementSelectors(*row.list, out);
    for (size_t i = 0; i < j.array.size(); ++i) {
        const Json& element = j.array[i];
        const std::string inside = fmt::format("{}[{}]", path, selectors[i]);
        if (!element.isObject())
            refuse(r, element, fmt::format("{}: must be an object, not {}", inside, jsonTypeName(element.type)));
        else
            readFields(r, row.list->fields, inside, element, row.list->editAt(out, i));
    }
}

void readField(ProjectReader& r, const FieldRow& row, const std::string& path, const Json& j, void* out) {
    switch (row.type) {
        case FieldType::Bool:
            return readBool(r, path, j, out);
        case FieldType::Int:
            return readInt(r, row, path, j, out);
        case FieldType::Float:
            return readFloat(r, row, path, j, out);
        case FieldType::Vec2:
            return readVector<glm::dvec2, double>(r, row, path, j, out);
        case FieldType::Vec3:
            return readVector<glm::dvec3, double>(r, row, path, j, out);
        case FieldType::Color:
            return readVector<glm::vec3, float>(r, row, path, j, out);
        case FieldType::String:
            return readString(r, row, path, j, out);
        case FieldType::Enum:
            return readOption(r, row, path, j, [&](size_t i) { setEnumIndex(out, static_cast<int>(i)); });
        case FieldType::Name:
            return readOption(r, row, path, j, [&](size_t i) { *static_cast<std::string*>(out) = row.options[i]; });
        case FieldType::Map:
            return readMapFile(r, path, j, out);
        case FieldType::List:
            return readList(r, row, path, j, out);
    }
}

void readFields(ProjectReader& r, std::span<const FieldRow> rows, const std::string& path, const Json& j, void* base) {
    for (const auto& [key, value] : j.object) {
        const auto row =
            std::find_if(rows.begin(), rows.end(), [&wanted = key](const FieldRow& f) { return wanted == f.name; });
        if (row != rows.end())
            readField(r, *row, path + "." + key, value, at(base, *row));
        else
            keepUnknown(r, path, key, value, "field");
    }
}

// --- components and entities -------------------------------------------------------------------------------------
void readComponent(ProjectReader& r, const ComponentRow& row, const std::string& path, Entity e, const Json& j) {
    if (!j.isObject()) return refuse(r, j, fmt::format("{}: must be an object, not {}", path, jsonTypeName(j.type)));
    row.assign(r.project.registry, e, nullptr);
    void* component = row.edit(r.project.registry, e);
    readFields(r, row.fields, path, j, component);
    if (!r.repair) return;
    for (const std::string& said : repairComponent(row, component)) report(r, j.keyLine, path + ": " + said);
}

void readEntity(ProjectReader& r, const std::string& name, const Json& j) {
    Result<Entity> e = addEntity(r.project, name);
    if (!e) return r.refused.push_back(unsound(e.error().message, e.error().remedy).at(r.file, j.keyLine, j.keyColumn));
    if (!j.isObject())
        return refuse(r, j, fmt::format("{}: must be an object of components, not {}", name, jsonTypeName(j.type)));
    for (const auto& [key, value] : j.object) {
        const ComponentRow* row = findComponent(r.rows, key);
        if (row)
            readComponent(r, *row, name + "." + key, *e, value);
        else
            keepUnknown(r, name, key, value, "component");
    }
}

// --- imports -----------------------------------------------------------------------------------------------------
bool readImport(const Json& j, MapImport& out) {
    const Json* file = j.find("file");
    const Json* flip = j.find("flip");
    const Json* range = j.find("range");
    if (!j.isObject() || (file && !file->isString()) || (flip && !flip->isBool())) return false;
    if (file) out.file = file->text;
    if (flip) out.flip = flip->boolean;
    if (!range) return true;
    if (!range->isArray() || range->array.size() != 2 || !range->array[0].isNumber() || !range->array[1].isNumber())
        return false;
    out.range = {range->array[0].number, range->array[1].number};
    return true;
}

void readImports(ProjectReader& r, const Json& j) {
    if (!j.isObject()) return refuse(r, j, fmt::format("imports: must be an object, not {}", jsonTypeName(j.type)));
    for (const auto& [path, value] : j.object) {
        MapImport import;
        if (readImport(value, import))
            r.project.imports[path] = import;
        else
            refuse(r, value, fmt::format("imports: \"{}\" must have a file, a flip and a range of two numbers", path),
                   "remove it, and import the map again");
    }
}

void readName(ProjectReader& r, const Json& j) {
    if (!j.isString()) return refuse(r, j, fmt::format("name: must be a string, not {}", jsonTypeName(j.type)));
    r.project.name = j.text;
}

}  // namespace

void ProjectReader::read(const Json& root) {
    for (const auto& [key, value] : root.object) {
        if (key == "format") continue;
        if (key == "name")
            readName(*this, value);
        else if (key == "imports")
            readImports(*this, value);
        else if (key != "entities")
            keepUnknown(*this, "", key, value, "entry");
        else if (!value.isObject())
            refuse(*this, value, fmt::format("entities: must be an object, not {}", jsonTypeName(value.type)));
        else
            for (const auto& [name, entity] : value.object) readEntity(*this, name, entity);
    }
}

}  // namespace sward
