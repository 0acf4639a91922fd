// Fields by PATH: finding, listing. Their values as text: project_values.cpp.
#include <cstring>
#include <functional>

#include "maps/tile_file.h"
#include "scene/moved_fields.h"
#include "scene/project.h"

namespace sward {
namespace {

// What is found is as changeable as the project that it is found in: Void is void or const void.
template <class AnyProject>
using RefIn = std::conditional_t<std::is_const_v<AnyProject>, ConstFieldRef, FieldRef>;

void* at(void* base, const FieldRow& row) { return static_cast<std::byte*>(base) + row.offset; }
const void* at(const void* base, const FieldRow& row) { return static_cast<const std::byte*>(base) + row.offset; }
void* elementOf(const ListRow& list, void* of, size_t i) { return list.editAt(of, i); }
const void* elementOf(const ListRow& list, const void* of, size_t i) { return list.at(of, i); }
void* componentOf(const ComponentRow& row, Registry& r, Entity e) { return row.edit(r, e); }
const void* componentOf(const ComponentRow& row, const Registry& r, Entity e) { return row.get(r, e); }

template <class Range, class NameOf>
std::string listNames(const Range& range, NameOf&& nameOf) {
    std::string out;
    for (const auto& item : range) out += (out.empty() ? "" : ", ") + std::string(nameOf(item));
    return out.empty() ? "nothing" : out;
}

// "a.b[c].d" -> "a", "b", "[c]", "d". Empty if the brackets do not match or a part is empty.
std::vector<std::string> splitPath(const std::string& path) {
    std::vector<std::string> parts;
    size_t i = 0;
    while (i < path.size()) {
        const bool bracket = path[i] == '[';
        const size_t end = bracket ? path.find(']', i) : path.find_first_of(".[", i);
        if (bracket && end == std::string::npos) return {};
        const size_t stop = end == std::string::npos ? path.size() : end + (bracket ? 1 : 0);
        if (stop == i) return {};
        parts.push_back(path.substr(i, stop - i));
        i = stop;
        if (i < path.size() && path[i] == '.' && ++i == path.size()) return {};
    }
    return parts;
}

const FieldRow* findRow(std::span<const FieldRow> rows, const std::string& name) {
    for (const FieldRow& row : rows)
        if (name == row.name) return &row;
    return nullptr;
}

Error noField(const std::string& path, const std::string& name, std::span<const FieldRow> rows) {
    return usage(fmt::format("{}: no field \"{}\"", path, name),
                 "there are: " + listNames(rows, [](const FieldRow& r) { return r.name; }));
}

// Walks from a component down the parts that remain.
template <class Void>
Result<BasicFieldRef<Void>> descend(BasicFieldRef<Void> ref, Void* base, std::span<const FieldRow> rows,
                                    std::span<const std::string> parts, const std::string& path) {
    if (parts.empty())
        return usage(fmt::format("{}: names no field", path),
                     "add one of: " + listNames(rows, [](const FieldRow& r) { return r.name; }));
    const FieldRow* row = findRow(rows, parts[0]);
    if (!row) return noField(path, parts[0], rows);
    ref.row = row;
    ref.value = at(base, *row);
    ref.path += fmt::format(".{}", row->name);
    if (parts.size() == 1) return ref;
    if (row->type != FieldType::List) return usage(fmt::format("{}: {} has no parts", path, ref.path));
    std::string selector = parts[1];
    if (selector.size() < 2 || selector[0] != '[')
        return usage(fmt::format("{}: {} is a list", path, ref.path), "select an element by [name] or [number]");
    selector = selector.substr(1, selector.size() - 2);
    const Result<size_t> element = findElement(ref, selector);
    if (!element) return element.error();
    const ListRow& list = *row->list;
    ref.path += "[" + elementSelector(list, ref.value, *element) + "]";
    return descend<Void>(ref, elementOf(list, ref.value, *element), list.fields, parts.subspan(2), path);
}

// Fields that are looked for: of a kind, and with a value that is wanted.
struct Wanted {
    bool (*kind)(const FieldRow&);
    std::function<bool(const void*)> value;
};

// Whether there is one of the kind among the rows, or in lists below them.
bool holdKind(std::span<const FieldRow> rows, const Wanted& wanted) {
    return std::any_of(rows.begin(), rows.end(), [&](const FieldRow& row) {
        return wanted.kind(row) || (row.type == FieldType::List && holdKind(row.list->fields, wanted));
    });
}

// Adds the fields below `base` that are wanted, those of list elements too, in the order of the rows.
template <class Void>
void collect(const BasicFieldRef<Void>& parent, Void* base, std::span<const FieldRow> rows, const Wanted& wanted,
             std::vector<BasicFieldRef<Void>>& out) {
    for (const FieldRow& row : rows) {
        const bool below = row.type == FieldType::List && holdKind(row.list->fields, wanted);
        if (!below && !wanted.kind(row)) continue;
        BasicFieldRef<Void> ref = parent;
        ref.value = at(base, row);
        ref.row = &row;
        ref.path += fmt::format(".{}", row.name);
        if (wanted.kind(row) && wanted.value(ref.value)) out.push_back(ref);
        if (!below) continue;
        const std::vector<std::string> selectors = elementSelectors(*row.list, ref.value);
        for (size_t i = 0; i < selectors.size(); ++i) {
            BasicFieldRef<Void> element = ref;
            element.path += "[" + selectors[i] + "]";
            collect(element, elementOf(*row.list, ref.value, i), row.list->fields, wanted, out);
        }
    }
}

// Of all components, in the order of entities' names.
template <class AnyProject>
auto collectAll(AnyProject& p, std::span<const ComponentRow> rows, const Wanted& wanted) {
    std::vector<RefIn<AnyProject>> out;
    for (const auto& [name, entity] : p.entities)
        for (const ComponentRow& row : rows)
            if (auto* component = componentOf(row, p.registry, entity))
                collect({nullptr, nullptr, &row, name, name + "." + row.name}, component, row.fields, wanted, out);
    return out;
}

// Whether an entity that lacks a component has its defaults all the same: settings beside their owner.
bool hasDefaults(const Project& p, std::span<const ComponentRow> rows, const ComponentRow& row, Entity e) {
    const ComponentRow* owner = row.settingsOf ? findComponent(rows, row.settingsOf) : nullptr;
    return owner && owner->get(p.registry, e);
}
// The component; where settings are absent, their defaults, which are the entity's own as soon as they may be changed.
const void* componentOrDefaults(const Project& p, std::span<const ComponentRow> rows, const ComponentRow& row,
                                Entity e) {
    const void* own = row.get(p.registry, e);
    return own || !hasDefaults(p, rows, row, e) ? own : row.defaults();
}
void* componentOrDefaults(Project& p, std::span<const ComponentRow> rows, const ComponentRow& row, Entity e) {
    if (!row.get(p.registry, e) && hasDefaults(p, rows, row, e)) row.assign(p.registry, e, nullptr);
    return row.edit(p.registry, e);
}

template <class AnyProject>
Result<RefIn<AnyProject>> fieldIn(AnyProject& p, std::span<const ComponentRow> rows, const std::string& path) {
    const std::vector<std::string> parts = splitPath(path);
    if (parts.size() < 2)
        return usage(fmt::format("\"{}\" is no path of a field", path), "write entity.Component.field");
    const Entity e = findEntity(p, parts[0]);
    if (!p.registry.valid(e))
        return usage(fmt::format("{}: no entity \"{}\"", path, parts[0]),
                     "there are: " + listNames(p.entities, [](const auto& item) { return item.first; }));
    std::vector<std::string> present;
    for (const ComponentRow& row : rows)
        if (row.get(p.registry, e)) present.push_back(row.name);
    const char* moved = parts.size() > 2 ? movedTo(parts[1], parts[2]) : nullptr;
    const ComponentRow* component = findComponent(rows, moved ? moved : parts[1]);
    auto* base = component ? componentOrDefaults(p, rows, *component, e) : nullptr;
    if (!base)
        return usage(fmt::format("{}: \"{}\" has no component \"{}\"", path, parts[0], parts[1]),
                     "it has: " + listNames(present, [](const std::string& s) { return s; }));
    RefIn<AnyProject> ref;
    ref.component = component;
    ref.entity = parts[0];
    ref.path = parts[0] + "." + component->name;
    return descend(ref, base, component->fields, std::span(parts).subspan(2), path);
}

template <class AnyProject>
std::vector<RefIn<AnyProject>> mapsIn(AnyProject& p, std::span<const ComponentRow> rows, bool absentToo) {
    auto out = collectAll(p, rows,
                          {[](const FieldRow& row) { return row.type == FieldType::Map; },
                           [&](const void* map) { return absentToo || static_cast<const MapField*>(map)->present(); }});
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return out;
}

bool endsWithPart(const std::string& path, const std::string& tail) {
    if (tail.empty() || !path.ends_with(tail)) return false;
    return path.size() == tail.size() || path[path.size() - tail.size() - 1] == '.' || tail[0] == '[';
}

template <class AnyProject>
Result<RefIn<AnyProject>> mapIn(AnyProject& p, std::span<const ComponentRow> rows, const std::string& name) {
    using Ref = RefIn<AnyProject>;
    const auto pathOf = [](const Ref& f) { return f.path; };
    if (Result<Ref> whole = fieldIn(p, rows, name); whole && whole->row->type == FieldType::Map) return whole;
    const std::vector<Ref> all = mapsIn(p, rows, true);
    for (const bool wantPresent : {true, false}) {
        std::vector<Ref> found;
        for (const Ref& f : all)
            if (static_cast<const MapField*>(f.value)->present() == wantPresent && endsWithPart(f.path, name))
                found.push_back(f);
        if (found.size() == 1) return found[0];
        if (!found.empty())
            return usage(fmt::format("more than one map is called \"{}\"", name),
                         "say which: " + listNames(found, pathOf));
    }
    return usage(fmt::format("no map is called \"{}\"", name), "there are: " + listNames(all, pathOf));
}

}  // namespace

Result<size_t> findElement(const ConstFieldRef& list, const std::string& selector) {
    CHECK(list.row->type == FieldType::List);
    const ListRow& row = *list.row->list;
    if (const std::optional<size_t> element = selectedElement(row, list.value, selector)) return *element;
    return usage(fmt::format("{}: no element \"{}\"", list.path, selector),
                 "there are: " + listNames(elementSelectors(row, list.value), [](const std::string& s) { return s; }));
}

Result<FieldRef> findField(Project& p, std::span<const ComponentRow> rows, const std::string& path) {
    return fieldIn(p, rows, path);
}
Result<ConstFieldRef> findField(const Project& p, std::span<const ComponentRow> rows, const std::string& path) {
    return fieldIn(p, rows, path);
}

std::vector<FieldRef> allMaps(Project& p, std::span<const ComponentRow> rows, bool absentToo) {
    return mapsIn(p, rows, absentToo);
}
std::vector<ConstFieldRef> allMaps(const Project& p, std::span<const ComponentRow> rows, bool absentToo) {
    return mapsIn(p, rows, absentToo);
}

std::vector<ConstFieldRef> allFiles(const Project& p, std::span<const ComponentRow> rows) {
    return collectAll(p, rows,
                      {[](const FieldRow& row) { return row.isFile; },
                       [](const void* file) { return !static_cast<const std::string*>(file)->empty(); }});
}

Result<FieldRef> findMap(Project& p, std::span<const ComponentRow> rows, const std::string& name) {
    return mapIn(p, rows, name);
}
Result<ConstFieldRef> findMap(const Project& p, std::span<const ComponentRow> rows, const std::string& name) {
    return mapIn(p, rows, name);
}

std::string mapFileFor(const ConstFieldRef& map, const MapInfo& texels) {
    CHECK(map.row->type == FieldType::Map);
    const auto& field = *static_cast<const MapField*>(map.value);
    const std::string ext = keptInTiles(texels) ? ".tif" : texels.type == PixelType::F32 ? ".exr" : ".png";
    if (!field.file.empty()) {
        const std::string old = std::filesystem::path(field.file).extension().string();
        const bool asBefore = field.map.info() == texels && old == ".png" && texels.type != PixelType::F32;
        const bool fits = old == ".tif" || old == ".tiff" || old == ext || asBefore;
        return fits ? field.file : std::filesystem::path(field.file).replace_extension(ext).generic_string();
    }
    // entity.Component.list[element].field -> entity.element.field
    std::string stem = map.entity;
    const size_t open = map.path.find('[');
    if (open != std::string::npos) stem += "." + map.path.substr(open + 1, map.path.find(']') - open - 1);
    for (char& c : stem)
        if (!std::isalnum(static_cast<unsigned char>(c)) && !std::strchr("._-", c)) c = '_';
    return fmt::format("maps/{}.{}{}", stem, map.row->name, ext);
}

}  // namespace sward
