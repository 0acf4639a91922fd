// What the editor tells the person: the red bar over the viewport and the last message in the status bar.
// Does not: keep the log (app/console.h), nor draw.
#pragma once
#include <string>

#include "core/error.h"

namespace sward {

struct Messages {
    std::string notice;      // the red bar over the viewport; empty: none
    std::string drawNotice;  // what the last drawing raised there, while it fails; empty: it did not fail
    std::string status;      // last message
};

// Logs the error and raises the red bar over the viewport; an older bar gives way. What the person stopped
// (ExitCode::Interrupted) is no fault: it is said in the status bar.
void showError(Messages& messages, const Error& error);
// For results of edits: shows the error if there is one. True if there was none.
bool accept(Messages& messages, const Status& status);
// Into the status bar and the log.
void say(Messages& messages, const std::string& message);

}  // namespace sward
