#include "app/object_actions.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/entity_edits.h"
#include "model/folder_edits.h"
#include "model/one_step.h"
#include "model/scatter_edits.h"
#include "scene/locked.h"
#include "tools/motion.h"

namespace sward {
namespace {

bool isHidden(const Project& p, const std::string& name) {
    const Entity e = findEntity(p, name);
    return e != kNoEntity && p.registry.get<Hidden>(e);
}

std::string told(const std::vector<std::string>& names) {
    return names.size() == 1 ? names.front() : fmt::format("{} entities", names.size());
}

// The ground itself, and water that stands everywhere, stay where they are.
Status moveAside(Document& doc, const std::vector<std::string>& names, const glm::dvec3& aside) {
    const Ground ground = doc.ground();
    for (const std::string& name : names) {
        const Entity e = findEntity(doc.project(), name);
        const Handle handle = handleOf(doc.project(), ground, name, 0);
        const bool still = handle.kind == HandleKind::Water || doc.project().registry.get<Terrain>(e);
        if (still || (movesTransform(handle.kind) && !doc.project().registry.get<Transform>(e))) continue;
        Motion motion;
        motion.pivot = handle.at;
        motion.move = aside;
        motion.alongGround = true;
        for (const auto& [path, text] : movedFields(startOf(doc.project(), handle), motion, ground))
            if (Status s = doc.setField(path, text); !s) return s;
    }
    return {};
}

}  // namespace

void duplicateChosen(Document& doc, Selection& selection, Messages& messages, const glm::dvec3& aside) {
    std::vector<std::string> copies;
    const auto edit = [&]() -> Status {
        Result<std::vector<std::string>> made = duplicateEntities(doc, selection.entities);
        if (!made) return made.error();
        copies = std::move(*made);
        return moveAside(doc, copies, aside);
    };
    if (!accept(messages, inOneStep(doc, "duplicate " + told(selection.entities), edit))) return;
    choose(selection, copies, Choose::Only);
    say(messages, "new: " + told(copies));
}

void folderChosen(Document& doc, Selection& selection, Messages& messages) {
    const std::string folder = freeFolder(doc.project());
    if (!accept(messages, moveToFolder(doc, selection.entities, folder))) return;
    selection.renaming = folder;
    selection.nameAge = 0;
    say(messages, fmt::format("{} in {}", told(selection.entities), folder));
}

void unfolderChosen(Document& doc, const Selection& selection, Messages& messages) {
    if (accept(messages, moveToFolder(doc, selection.entities, "")))
        say(messages, told(selection.entities) + ": in no folder");
}

void removeChosen(Document& doc, Selection& selection, Messages& messages) {
    const std::string what = told(selection.entities);
    if (!accept(messages, removeEntities(doc, selection.entities))) return;
    selection.entities.clear();
    say(messages, "removed: " + what);
}

void scatterChosen(Document& doc, Selection& selection, Messages& messages) {
    const Result<std::string> made = addScatter(doc, selection.entities);
    if (!made) return showError(messages, made.error());
    choose(selection, *made);
    say(messages, "new: " + *made + "; its rule is in the inspector");
}

void makeObjectsOfChosen(Document& doc, Selection& selection, Messages& messages) {
    const Result<std::vector<std::string>> made = makeObjectsOf(doc, shownEntity(selection));
    if (!made) return showError(messages, made.error());
    choose(selection, *made, Choose::Only);
    say(messages, "new: " + told(*made));
}

void hideChosen(Document& doc, const Selection& selection, Messages& messages) {
    const std::vector<std::string>& names = selection.entities;
    const auto hidden = [&](const std::string& name) { return isHidden(doc.project(), name); };
    const bool hide = !std::all_of(names.begin(), names.end(), hidden);
    if (!accept(messages, hideEntities(doc, names, hide))) return;
    say(messages, (hide ? "hidden here, not in pictures: " : "shown: ") + told(names));
}

void lockChosen(Document& doc, const Selection& selection, Messages& messages) {
    const std::vector<std::string>& names = selection.entities;
    const auto locked = [&](const std::string& name) { return isLocked(doc.project(), name); };
    const bool lock = !std::all_of(names.begin(), names.end(), locked);
    if (!accept(messages, lockEntities(doc, names, lock))) return;
    say(messages, (lock ? "neither chosen nor moved in the viewport: " : "unlocked: ") + told(names));
}

void unlockAll(Document& doc, Messages& messages) {
    std::vector<std::string> names;
    for (const auto& [name, e] : doc.project().entities)
        if (isLocked(doc.project(), name)) names.push_back(name);
    if (names.empty()) return say(messages, "nothing is locked");
    if (accept(messages, lockEntities(doc, names, false))) say(messages, "unlocked: " + told(names));
}

void showAll(Document& doc, Messages& messages) {
    std::vector<std::string> names;
    for (const auto& [name, e] : doc.project().entities)
        if (isHidden(doc.project(), name)) names.push_back(name);
    if (names.empty()) return say(messages, "nothing is hidden");
    if (accept(messages, hideEntities(doc, names, false))) say(messages, "shown: " + told(names));
}

void askName(RenameDialog& dialog, const Selection& selection) {
    dialog = {shownEntity(selection), shownEntity(selection), "", true};
}

void followName(const std::string& from, const std::string& to, Selection& selection, BrushBook& brushes,
                TierView& tiers) {
    std::replace(selection.entities.begin(), selection.entities.end(), from, to);
    if (brushes.map.starts_with(from + ".")) brushes.map = to + brushes.map.substr(from.size());
    if (tiers.field == from) tiers.field = to;
}

}  // namespace sward
