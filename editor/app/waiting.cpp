#include "app/waiting.h"

#include <fmt/format.h>

#include <thread>

#include "project/project_files.h"

namespace sward {
namespace {

Error cancelled(const std::string& label) { return interruption(label + ": cancelled", "nothing has changed"); }

Result<Taking> guarded(JobControl& control, const WaitedWork& work) try {
    return work(control);
} catch (const std::exception& e) {
    return failed(e.what());
}

// Work that a person cancelled ends with an error of its own, at whatever it was doing.
Error errorOf(const Waiting::Slot& slot) {
    Error error = slot.result->error();
    if (slot.cancelled()) error.code = ExitCode::Interrupted;
    return error;
}

// Everything is let go of first: what follows may wait for other work.
void end(Waiting& w) {
    const std::shared_ptr<Waiting::Slot> slot = std::exchange(w.slot, nullptr);
    const WaitedEnd then = std::exchange(w.then, nullptr);
    const Status done = !slot->result    ? Status(cancelled(w.label))  // before its turn
                        : !*slot->result ? Status(errorOf(*slot))
                                         : (**slot->result)();
    if (then) then(done);
}

}  // namespace

void waitFor(Waiting& w, const std::string& label, WaitedWork work, WaitedEnd then) {
    if (waits(w)) return then(failed(label + " must wait for its turn: " + w.label + " goes on", "or cancel that"));
    w.label = label;
    w.slot = std::make_shared<Waiting::Slot>();
    w.then = std::move(then);
    w.begun = std::chrono::steady_clock::now();
    runInLane(Lane::Waited, w.slot, [slot = w.slot, work = std::move(work)] { slot->result = guarded(*slot, work); });
    while (!w.slot->finished() && (w.patient || std::chrono::steady_clock::now() - w.begun < kPatience))
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    if (w.slot->finished()) return end(w);
    w.opening = true;
    ++w.windows;
}

bool followWaiting(Waiting& w) {
    if (!w.slot || !w.slot->finished()) return false;
    end(w);
    return true;
}

void cancelWaiting(Waiting& w) {
    if (w.slot) w.slot->cancel();
}

void editBeside(Waiting& w, Document& doc, const std::string& label, WaitedEdit edit, WaitedEnd then) {
    Result<std::unique_ptr<Document>> made = doc.copyToWorkOn();
    if (!made) return then(made.error());
    waitFor(
        w, label,
        [&doc, label, copy = std::shared_ptr(std::move(*made)),
         edit = std::move(edit)](JobControl& c) -> Result<Taking> {
            if (Status done = edit(*copy, c); !done) return done.error();
            if (c.cancelled()) return cancelled(label);
            return Taking([&doc, copy] { return doc.takeFrom(*copy); });
        },
        std::move(then));
}

void readBeside(Waiting& w, const Document& doc, const std::filesystem::path& dir, std::function<Status(Project&)> take,
                WaitedEnd then) {
    const auto rows = doc.tables().components;
    waitFor(
        w, "Opening " + dir.filename().string(),
        [dir, rows, take = std::move(take)](JobControl& c) -> Result<Taking> {
            Result<Project> loaded = loadProject(dir, rows, c);
            if (!loaded) return loaded.error();
            const auto project = std::make_shared<Project>(std::move(*loaded));
            return Taking([take, project] { return take(*project); });
        },
        std::move(then));
}

void openBeside(Waiting& w, Document& doc, const std::filesystem::path& dir, WaitedEnd then) {
    readBeside(
        w, doc, dir, [&doc](Project& loaded) { return doc.show(std::move(loaded)); }, std::move(then));
}

void saveBeside(Waiting& w, Document& doc, const std::filesystem::path& as,
                std::function<void(const Result<std::vector<std::string>>&)> then) {
    Result<SaveWork> begun = doc.beginSave(as);
    if (!begun) return then(begun.error());
    const auto work = std::make_shared<SaveWork>(std::move(*begun));
    waitFor(
        w, "Saving " + work->project.name,
        [&doc, work](JobControl& c) -> Result<Taking> {
            writeSave(*work, &c);  // what was written before it was cancelled is taken note of
            return Taking([&doc, work]() -> Status {
                const auto written = doc.endSave(*work);
                return written ? Status() : Status(written.error());
            });
        },
        [work, then = std::move(then)](const Status& done) {
            if (done) return then(work->written);
            then(done.error());
        });
}

}  // namespace sward
