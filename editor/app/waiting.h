// What a person waits for: an edit of whole maps, a project that is opened or saved. It runs on a thread of its own, on
// a copy; a window shows how far it is and cancels it (panels/waiting.cpp), and nothing else is edited meanwhile. What
// it made is taken in one go, between two frames. Who is done within kPatience shows no window.
// Does not: draw; run what goes on beside a person's work (app/background_work.h).
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/jobs.h"
#include "model/document.h"

namespace sward {

// How long whoever asked waits within the frame.
inline constexpr std::chrono::milliseconds kPatience{40};

// What is left to do between frames once the work is done: milliseconds at most, such as taking a map.
using Taking = std::function<Status()>;
// Runs on another thread, on what it captured by value; tells its progress now and then, and ends early with any error
// once it is cancelled.
using WaitedWork = std::function<Result<Taking>(JobControl&)>;
// Told how it ended, between frames. Cancelled work ends with an error of ExitCode::Interrupted.
using WaitedEnd = std::function<void(const Status&)>;
// What is done to the copy of a document.
using WaitedEdit = std::function<Status(Document&, JobControl&)>;

struct Waiting {
    bool patient = true;  // whoever asks waits for the end, however long: scripts, and editors without a person
    std::string label;    // "Importing hills.png"
    struct Slot : JobControl {
        std::optional<Result<Taking>> result;  // once finished
    };
    std::shared_ptr<Slot> slot;  // null: nothing is waited for
    WaitedEnd then;
    std::chrono::steady_clock::time_point begun;
    bool opening = false;  // the window's popup is to be opened in this frame
    bool shown = false;    // the popup is open
    size_t windows = 0;    // so often was it too long for kPatience
};

inline bool waits(const Waiting& waiting) { return waiting.slot != nullptr; }
// Begins work; `then` is told of its end, now or in a later frame. While other work is waited for: refused.
void waitFor(Waiting& waiting, const std::string& label, WaitedWork work, WaitedEnd then);
// Once a frame: takes what is done, and tells of the end. True if something ended.
bool followWaiting(Waiting& waiting);
// Asks the work to end; the window stays until it has, since it may be writing a file.
void cancelWaiting(Waiting& waiting);

// Does to a copy of the document what `edit` does to a document, and takes its undo steps for its own. Refused while
// the project is played or none is open.
void editBeside(Waiting& waiting, Document& document, const std::string& label, WaitedEdit edit, WaitedEnd then);
// Reads a project, which `take` then gives to the document: Document::open, takeOver and takeFromDisk.
void readBeside(Waiting& waiting, const Document& document, const std::filesystem::path& dir,
                std::function<Status(Project&)> take, WaitedEnd then);
void openBeside(Waiting& waiting, Document& document, const std::filesystem::path& dir, WaitedEnd then);
// Document::save, or saveAs if a folder is given; `then` gets the files written.
void saveBeside(Waiting& waiting, Document& document, const std::filesystem::path& as,
                std::function<void(const Result<std::vector<std::string>>&)> then);

}  // namespace sward
