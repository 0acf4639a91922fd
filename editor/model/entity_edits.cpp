#include "model/entity_edits.h"
#include "model/one_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <map>

#include "scene/locked.h"

namespace sward {
namespace {

// "tree-09": "tree-", 9, 2 digits; "bench": "bench-", 1, 1 digit.
struct Numbered {
    std::string stem;
    int number = 1;
    int width = 1;
};

Numbered numbered(const std::string& name) {
    const size_t last = name.find_last_not_of("0123456789");
    const size_t digits = name.size() - (last == std::string::npos ? 0 : last + 1);
    const bool hasNumber = last != std::string::npos && name[last] == '-' && digits > 0 && digits < 7;
    if (!hasNumber) return {name + "-"};
    return {name.substr(0, last + 1), std::stoi(name.substr(last + 1)), static_cast<int>(digits)};
}

std::string next(const Project& p, const Numbered& n, int& last) {
    for (last = std::max(last, n.number) + 1;; ++last)
        if (std::string name = fmt::format("{}{:0{}}", n.stem, last, n.width); !p.entities.contains(name)) return name;
}

std::string cleaned(const std::string& name) {
    std::string out;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-') out += c;
    return out.empty() ? "object" : out;
}

std::string labelOf(const char* verb, std::span<const std::string> names) {
    return names.size() == 1 ? fmt::format("{} {}", verb, names[0]) : fmt::format("{} {} entities", verb, names.size());
}

// entity.rename("bench", "seat"): names hold no quotes.
std::string callOf(const char* call, std::span<const std::string> names) {
    std::string list;
    for (const std::string& name : names) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
    return fmt::format("{}({})", call, list);
}

Status copyEntity(Document& doc, const std::string& from, const std::string& to) {
    if (Status made = doc.addEntity(to); !made) return made;
    for (const ComponentRow& row : doc.tables().components)
        if (const void* value = row.get(doc.project().registry, findEntity(doc.project(), from)))
            if (Status done = doc.assignComponent(to, row, value); !done) return done;
    return {};
}

// What a reference to `from` is set to.
void addReferences(const std::string& path, std::span<const FieldRow> fields, const void* base, const std::string& from,
                   std::vector<std::string>& out) {
    for (const FieldRow& field : fields) {
        const void* value = static_cast<const char*>(base) + field.offset;
        const std::string at = path + "." + field.name;
        if (field.isEntity && *static_cast<const std::string*>(value) == from) out.push_back(at);
        if (field.type != FieldType::List) continue;
        const std::vector<std::string> selectors = elementSelectors(*field.list, value);
        for (size_t i = 0; i < selectors.size(); ++i)
            addReferences(fmt::format("{}[{}]", at, selectors[i]), field.list->fields, field.list->at(value, i), from,
                          out);
    }
}

std::vector<std::string> referencesTo(const Document& doc, const std::string& entity) {
    std::vector<std::string> paths;
    for (const auto& [name, e] : doc.project().entities)
        for (const ComponentRow& row : doc.tables().components)
            if (const void* value = row.get(doc.project().registry, e))
                addReferences(name + "." + row.name, row.fields, value, entity, paths);
    return paths;
}

// Adds the component M, which has no fields, to all of them, or takes it from those that have it.
template <class M>
Status mark(Document& doc, std::span<const std::string> names, const char* component, bool on, const char* verb) {
    return inOneStep(doc, labelOf(verb, names), [&]() -> Status {
        for (const std::string& name : names) {
            const Entity e = findEntity(doc.project(), name);
            if (e != kNoEntity && (doc.project().registry.get<M>(e) != nullptr) == on) continue;
            if (Status s = on ? doc.addComponent(name, component) : doc.removeComponent(name, component); !s) return s;
        }
        return {};
    });
}

bool holdsUnknownParts(const Project& p, const std::string& entity) {
    const auto it = p.unknown.lower_bound(entity + ".");
    return it != p.unknown.end() && it->first.starts_with(entity + ".");
}

void keepImports(Document& doc, const std::string& from, const std::string& to) {
    const std::map<std::string, MapImport> imports = doc.project().imports;
    for (const auto& [path, import] : imports)
        if (path.starts_with(from + ".")) doc.rememberImport(to + path.substr(from.size()), import);
}

}  // namespace

std::string freeName(const Project& p, const std::string& like) {
    const std::string name = cleaned(like);
    int last = 0;
    return p.entities.contains(name) ? next(p, numbered(name), last) : name;
}

Result<std::vector<std::string>> duplicateEntities(Document& doc, std::span<const std::string> names) {
    std::vector<std::string> copies;
    std::map<std::string, int> last;  // number of each stem: none is looked for twice
    const Status done = inOneStep(doc, labelOf("duplicate", names), [&]() -> Status {
        doc.describe(callOf("entity.duplicate", names));
        for (const std::string& name : names) {
            if (!doc.project().entities.contains(name)) return usage(fmt::format("there is no entity \"{}\"", name));
            const Numbered n = numbered(name);
            copies.push_back(next(doc.project(), n, last[n.stem]));
            if (Status copied = copyEntity(doc, name, copies.back()); !copied) return copied;
        }
        return {};
    });
    if (!done) return done.error();
    return copies;
}

Status renameEntity(Document& doc, const std::string& from, const std::string& to) {
    if (from == to) return {};
    if (!doc.project().entities.contains(from)) return usage(fmt::format("there is no entity \"{}\"", from));
    if (holdsUnknownParts(doc.project(), from))
        return usage(
            fmt::format("\"{}\" holds parts that this version of Sward does not know, which go by its name", from),
            "rename it in project.json");
    const Status done = inOneStep(doc, fmt::format("rename {} to {}", from, to), [&]() -> Status {
        doc.describe(callOf("entity.rename", std::array{from, to}));
        if (Status copied = copyEntity(doc, from, to); !copied) return copied;
        if (Status removed = doc.removeEntity(from); !removed) return removed;
        for (const std::string& path : referencesTo(doc, from))
            if (Status set = doc.setField(path, to); !set) return set;
        return {};
    });
    if (done) keepImports(doc, from, to);
    return done;
}

Status removeEntities(Document& doc, std::span<const std::string> names) {
    return inOneStep(doc, labelOf("remove", names), [&]() -> Status {
        for (const std::string& name : names)
            if (Status removed = doc.removeEntity(name); !removed) return removed;
        return {};
    });
}

Status hideEntities(Document& doc, std::span<const std::string> names, bool hidden) {
    return mark<Hidden>(doc, names, "Hidden", hidden, hidden ? "hide" : "show");
}

Status lockEntities(Document& doc, std::span<const std::string> names, bool locked) {
    return mark<Locked>(doc, names, "Locked", locked, locked ? "lock" : "unlock");
}

}  // namespace sward
