#include "app/file_tasks.h"

#include <fmt/format.h>

#include "project/project_files.h"

namespace sward {
namespace {

void openDialog(FileDialog& d, const Document& document, FileTask task) {
    d.task = task;
    d.opening = true;
    d.error.clear();
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

}  // namespace

void askFirst(UnsavedDialog& unsaved, const Document& document, std::function<void()> then) {
    if (!document.isOpen() || !document.dirty()) return then();
    unsaved.then = std::move(then);
    unsaved.opening = true;
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

Status takeTheirs(OutsideDialog& outside, Document& document) {
    const Status taken = document.takeFromDisk();
    outside.error = taken ? "" : taken.error().text();
    if (taken) outside.files.clear();
    return taken;
}

bool saveNow(Document& document, FileDialog& files, OutsideDialog& outside, Messages& messages) {
    if (document.project().dir.empty()) {
        openDialog(files, document, FileTask::SaveAs);
        return false;
    }
    if (askOutside(outside, document, true)) return false;
    const auto written = document.save();
    if (!written) {
        showError(messages, written.error());
        return false;
    }
    messages.notice.clear();
    say(messages, written->empty()
                      ? "saved: nothing had changed"
                      : fmt::format("saved: {} file{} written", written->size(), written->size() == 1 ? "" : "s"));
    return true;
}

}  // namespace sward
