#include "model/folder_edits.h"

#include <fmt/format.h>

#include "model/one_step.h"
#include "scene/in_folder.h"

namespace sward {
namespace {

Status putInto(Document& doc, const std::string& entity, const std::string& folder) {
    const Entity e = findEntity(doc.project(), entity);
    if (e == kNoEntity) return usage(fmt::format("there is no entity \"{}\"", entity));
    const bool has = doc.project().registry.get<InFolder>(e);
    if (folder.empty()) return has ? doc.removeComponent(entity, "InFolder") : Status{};
    if (folderOf(doc.project(), entity) == folder) return {};
    if (!has)
        if (Status s = doc.addComponent(entity, "InFolder"); !s) return s;
    return doc.setField(entity + ".InFolder.folder", folder);
}

std::string told(std::span<const std::string> names) {
    return names.size() == 1 ? names[0] : fmt::format("{} entities", names.size());
}

}  // namespace

std::map<std::string, std::vector<std::string>> entitiesByFolder(const Project& p) {
    std::map<std::string, std::vector<std::string>> folders;
    for (const auto& [name, e] : p.entities) folders[folderOf(p, name)].push_back(name);
    return folders;
}

std::string freeFolder(const Project& p) {
    const auto folders = entitiesByFolder(p);
    std::string name = "folder";
    for (int n = 2; folders.contains(name); ++n) name = fmt::format("folder {}", n);
    return name;
}

Status moveToFolder(Document& doc, std::span<const std::string> entities, const std::string& folder) {
    if (!folder.empty() && folder.find_first_not_of(" \t") == std::string::npos)
        return usage("a folder's name must not be blank", "type a name");
    const std::string to = folder.empty() ? "out of its folder" : "to " + folder;
    return inOneStep(doc, fmt::format("move {} {}", told(entities), to), [&]() -> Status {
        for (const std::string& name : entities)
            if (Status s = putInto(doc, name, folder); !s) return s;
        return {};
    });
}

Status renameFolder(Document& doc, const std::string& from, const std::string& to) {
    const auto folders = entitiesByFolder(doc.project());
    const auto at = folders.find(from);
    if (from.empty() || at == folders.end()) return usage(fmt::format("there is no folder \"{}\"", from));
    return from == to ? Status{} : moveToFolder(doc, at->second, to);
}

}  // namespace sward
