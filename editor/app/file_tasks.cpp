#include "app/file_tasks.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/resources.h"
#include "project/project_files.h"

namespace sward {
namespace {

void openDialog(FileDialog& d, const Document& document, FileTask task) {
    d.task = task;
    d.opening = true;
    d.error.clear();
    if (task == FileTask::New) d.templates = projectTemplates(resource("projects/templates"));
    if (task == FileTask::New && d.wish.name.empty() && !d.templates.empty()) {
        const ProjectTemplate& first = d.templates.front();
        d.wish = {first.name, first.size, first.relief};
    }
    if (document.isOpen() && !document.project().dir.empty()) d.folder = document.project().dir.parent_path();
    const std::filesystem::path dir = document.isOpen() ? document.project().dir : std::filesystem::path();
    const auto beside = [&](const char* ending) {
        return (dir.parent_path() / (document.project().name + ending)).string();
    };
    d.path = task == FileTask::SaveAs      ? dir.string()
             : task == FileTask::Export    ? beside(".glb")
             : task == FileTask::Recording ? beside("-session.lua")
                                           : "";
}

std::string endingOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}
bool among(const std::string& ending, std::initializer_list<const char*> endings) {
    return std::any_of(endings.begin(), endings.end(), [&](const char* e) { return ending == e; });
}

// "park-lawn.density.png" beside the project; floats as EXR.
std::filesystem::path exportPlace(const Document& document, const std::string& field) {
    const Project& p = document.project();
    const auto map = findField(p, document.tables().components, field);
    const bool floats = map && static_cast<const MapField*>(map->value)->map.info().type == PixelType::F32;
    std::string name = p.name + "-";
    for (const char c : field) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '.';
    return p.dir.parent_path() / (name + (floats ? ".exr" : ".png"));
}

}  // namespace

bool namesFile(FileTask task) {
    return task == FileTask::Export || task == FileTask::Recording || task == FileTask::ExportMap ||
           task == FileTask::ChooseFile;
}

bool fitsTask(const FileDialog& files, const Document& document, const std::filesystem::path& name) {
    const std::string ending = endingOf(name);
    if (files.task == FileTask::Export) return ending == ".glb";
    if (files.task == FileTask::Recording) return ending == ".lua";
    if (files.task == FileTask::ExportMap) return among(ending, {".png", ".exr", ".tif", ".tiff", ".r16"});
    if (files.task != FileTask::ChooseFile) return false;
    const auto field = findField(document.project(), document.tables().components, files.field);
    return field && field->row->isMesh ? among(ending, {".glb", ".gltf"}) : ending == ".png";
}

void requestFieldTask(FileDialog& files, const Document& document, FileTask task, const std::string& field) {
    openDialog(files, document, task);
    files.field = field;
    files.folder = document.project().dir;
    if (task == FileTask::ExportMap) {
        files.path = exportPlace(document, field).string();
        files.folder = files.folder.parent_path();
    }
    const auto named = findField(document.project(), document.tables().components, field);
    if (task != FileTask::ChooseFile || !named) return;
    const auto inside = std::filesystem::path(*static_cast<const std::string*>(named->value)).parent_path();
    if (!inside.empty()) files.folder /= inside;  // an empty one would leave a slash, which Up takes for a folder
}

void askFirst(UnsavedDialog& unsaved, const Document& document, std::function<void()> then) {
    if (!document.isOpen() || !document.dirty()) return then();
    unsaved.then = std::move(then);
    unsaved.opening = true;
    unsaved.error.clear();
}

void requestTask(FileDialog& files, UnsavedDialog& unsaved, const Document& document, FileTask task) {
    if (task == FileTask::SaveAs || task == FileTask::Export || task == FileTask::Recording)
        return openDialog(files, document, task);
    askFirst(unsaved, document, [&files, &document, task] { openDialog(files, document, task); });
}

bool askAgain(FileDialog& files, const std::filesystem::path& file, const Error& why) {
    if (files.task != FileTask::None) return false;
    files.task = FileTask::Export;
    files.opening = true;
    files.folder = file.parent_path();
    files.path = file.string();
    files.error = why.text();
    return true;
}

bool othersOnDisk(const OutsideDialog& outside, const Document& document) {
    if (!document.isOpen()) return false;
    const auto changed = changedOutside(document.project());
    return !changed.empty() && changed != outside.kept;
}

bool askOutside(OutsideDialog& outside, const Document& document, bool saving) {
    if (!outside.files.empty()) return true;
    if (!othersOnDisk(outside, document)) return false;
    std::map<std::string, FileStamp> changed = changedOutside(document.project());
    if (!saving && changed == outside.told) return false;
    outside.told = outside.files = std::move(changed);
    outside.opening = true;
    outside.saving = saving;
    outside.error.clear();
    return true;
}

void keepOwn(OutsideDialog& outside) { outside.kept = std::exchange(outside.files, {}); }

void takeTheirs(OutsideDialog& outside, Document& document, Waiting& waiting, std::function<void()> taken) {
    readBeside(
        waiting, document, document.project().dir, [&document](const Project& p) { return document.takeFromDisk(p); },
        [&outside, taken = std::move(taken)](const Status& done) {
            outside.error = done ? "" : done.error().text();
            outside.opening = !done;
            if (!done) return;
            outside.files.clear();
            taken();
        });
}

bool saveNow(const SaveParts& p) {
    if (p.doc.project().dir.empty()) {
        openDialog(p.files, p.doc, FileTask::SaveAs);
        return false;
    }
    if (askOutside(p.outside, p.doc, true)) return false;
    const auto saved = std::make_shared<bool>(false);
    saveBeside(p.waiting, p.doc, {}, [&messages = p.messages, saved](const Result<std::vector<std::string>>& written) {
        if (!written) return showError(messages, written.error());
        messages.notice.clear();
        say(messages, written->empty()
                          ? "saved: nothing had changed"
                          : fmt::format("saved: {} file{} written", written->size(), written->size() == 1 ? "" : "s"));
        *saved = true;
    });
    return *saved;
}

}  // namespace sward
