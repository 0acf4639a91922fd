// The document: opening, saving, and work on a copy.
#include <set>

#include "core/log.h"
#include "core/utf8.h"
#include "model/document_impl.h"
#include "scene/unique.h"
#include "world/drawn_project.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

std::string folderName(const fs::path& dir) {
    const fs::path clean = fs::absolute(dir).lexically_normal();
    return utf8Text((clean.has_filename() ? clean : clean.parent_path()).filename().string());
}

}  // namespace

void Document::Impl::show(Project p) {
    stroke.reset();
    lastStroke = {};
    groupDepth = 0;
    group = {};
    history.clear();
    if (listener) listener->tookOther();
    project = std::move(p);
    noteSaved();
    ++revision;
}

void Document::Impl::noteSaved() {
    saved = snapshot(*project, rows());
    savedAt = history.position();
}

Status Document::Impl::notPlayed() const {
    return play ? failed("the project is being played and cannot be changed, saved or left",
                         "stop first: F5, or play.stop()")
                : Status();
}
Status Document::Impl::ready() const {
    return project ? notPlayed() : failed("no project is open", "open or create one first");
}

// --- opening -----------------------------------------------------------------------------------------------------

Status Document::open(const fs::path& dir) {
    if (Status s = impl_->notPlayed(); !s) return s;
    Result<Project> loaded = loadProject(dir, impl_->rows());
    return loaded ? show(std::move(*loaded)) : loaded.error();
}

Status Document::show(Project loaded) {
    if (Status s = impl_->notPlayed(); !s) return s;
    impl_->show(std::move(loaded));
    return {};
}

Status Document::create(const fs::path& dir) {
    if (Status s = impl_->notPlayed(); !s) return s;
    Result<Project> made = newProject(dir, impl_->rows());
    return made ? show(std::move(*made)) : made.error();
}

Status Document::takeOver(const fs::path& dir, const std::string& label) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    const Result<Project> other = loadProject(dir, impl_->rows());
    return other ? takeOver(*other, label) : other.error();
}

Status Document::takeOver(const Project& loaded, const std::string& label) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    impl_->become(loaded, label);
    return {};
}

Status Document::takeFromDisk() {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    const Result<Project> other = loadProject(impl_->project->dir, impl_->rows());
    return other ? takeFromDisk(*other) : other.error();
}

Status Document::takeFromDisk(const Project& other) {
    if (Status taken = takeOver(other, "take what is on disk"); !taken) return taken;
    Project& p = *impl_->project;
    p.name = other.name, p.unknown = other.unknown, p.imports = other.imports;
    p.stamps = other.stamps, p.repairedMaps = other.repairedMaps;
    impl_->noteSaved();
    return {};
}

void Document::Impl::become(const Project& other, const std::string& label) {
    std::set<std::string> names;
    for (const auto& [name, entity] : project->entities) names.insert(name);
    for (const auto& [name, entity] : other.entities) names.insert(name);
    std::vector<Change> changes;
    const auto presence = [](bool there) { return there ? std::make_shared<bool>(true) : nullptr; };
    for (const std::string& name : names) {
        for (const ComponentRow& row : rows()) {
            const void* after = componentOf(other, name, row);
            changes.push_back({name, &row, stateOf(name, row), after ? row.clone(after) : nullptr});
        }
        const bool before = project->entities.contains(name), after = other.entities.contains(name);
        if (before != after) changes.push_back({name, nullptr, presence(before), presence(after)});
    }
    dropEmptyChanges(changes);
    applyChanges(*project, changes, true);
    record(label, std::move(changes));
}

// --- saving ------------------------------------------------------------------------------------------------------

// A project called after its folder is called after the new one.
Result<SaveWork> Document::beginSave(const fs::path& as) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    SaveWork work{.project = snapshot(*impl_->project, impl_->rows()),
                  .saved = snapshot(impl_->saved, impl_->rows()),
                  .rows = impl_->rows(),
                  .waitSeconds = impl_->saveWaitSeconds,
                  .position = impl_->history.position()};
    if (as.empty()) return work;
    if (work.project.name == folderName(work.project.dir)) work.project.name = folderName(as);
    work.project.dir = fs::absolute(as).lexically_normal();
    return work;
}

void writeSave(SaveWork& work, JobControl* control) {
    Project& p = work.project;
    std::error_code fault;
    const bool fresh = work.saved.dir != p.dir && !fs::exists(p.dir, fault);
    if (fresh && !fs::create_directories(p.dir, fault)) {
        work.written = failed("cannot make the folder: " + fault.message(), "choose another place").at(p.dir);
        return;
    }
    SaveWay way;
    way.waitSeconds = work.waitSeconds;
    way.stamps = &p.stamps;
    work.written = saveProject(p, work.rows, &work.saved, way, control);
    if (!work.written && fresh) fs::remove(p.dir, fault);  // what another put there meanwhile stays
    if (!work.written) return;
    p.repairedMaps.clear();
    if (Status s = checkUnique(DrawnProject().of(p, work.rows)); !s)
        logWarning("saved, but it cannot be drawn: " + s.error().text());
}

Result<std::vector<std::string>> Document::endSave(SaveWork& work) {
    if (!work.written) return work.written;
    Project& p = *impl_->project;
    p.dir = work.project.dir, p.name = work.project.name;
    p.stamps = work.project.stamps, p.repairedMaps.clear();
    impl_->saved = std::move(work.project);
    impl_->savedAt = work.position;
    ++impl_->revision;
    return work.written;
}

Result<std::vector<std::string>> Document::save() { return saveAs({}); }

Result<std::vector<std::string>> Document::saveAs(const fs::path& dir) {
    Result<SaveWork> work = beginSave(dir);
    if (!work) return work.error();
    writeSave(*work, nullptr);
    return endSave(*work);
}

// --- work on a copy ----------------------------------------------------------------------------------------------

Result<std::unique_ptr<Document>> Document::copyToWorkOn() {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    auto copy = std::make_unique<Document>(impl_->tables);
    copy->impl_->project = snapshot(*impl_->project, impl_->rows());
    copy->impl_->copyOf = impl_->revision;
    return copy;
}

Status Document::takeFrom(Document& worked) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    if (worked.impl_->copyOf != impl_->revision)
        return failed("the project changed meanwhile, so that nothing was taken over", "do it again");
    for (UndoStep& step : worked.impl_->history.takeAll()) {
        applyChanges(*impl_->project, step.changes, true);
        const bool grouped = impl_->groupDepth > 0;
        if (grouped) impl_->record(step.label, std::move(step.changes));
        if (!grouped) ++impl_->revision, impl_->push(std::move(step), nullptr);
    }
    impl_->project->imports = worked.impl_->project->imports;
    return {};
}

}  // namespace sward
