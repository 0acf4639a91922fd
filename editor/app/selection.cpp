#include "app/selection.h"

#include <algorithm>
#include <set>

#include "scene/project.h"

namespace sward {

Choose howChosen(bool ctrl, bool shift) { return ctrl ? Choose::Toggle : shift ? Choose::Add : Choose::Only; }

const std::string& shownEntity(const Selection& selection) {
    static const std::string none;
    return selection.entities.empty() ? none : selection.entities.back();
}

bool isChosen(const Selection& selection, const std::string& entity) {
    return std::find(selection.entities.begin(), selection.entities.end(), entity) != selection.entities.end();
}

void choose(Selection& selection, std::span<const std::string> names, Choose how) {
    std::vector<std::string>& chosen = selection.entities;
    if (how == Choose::Only) chosen.clear();
    const std::set<std::string> before(chosen.begin(), chosen.end()), named(names.begin(), names.end());
    std::erase_if(chosen, [&](const std::string& name) { return named.contains(name); });
    for (const std::string& name : names)
        if (how != Choose::Toggle || !before.contains(name)) chosen.push_back(name);
}

void choose(Selection& selection, const std::string& name, Choose how) { choose(selection, {&name, 1}, how); }

void dropMissing(Selection& selection, const Project& project) {
    std::erase_if(selection.entities, [&](const std::string& name) { return !project.entities.contains(name); });
}

}  // namespace sward
