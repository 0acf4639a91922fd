#include "app/messages.h"

#include "core/log.h"

namespace sward {

void showError(Messages& messages, const Error& error) {
    if (error.code == ExitCode::Interrupted) return say(messages, error.text());
    messages.notice = error.text();
    logError(messages.notice);
}

bool accept(Messages& messages, const Status& status) {
    if (!status) showError(messages, status.error());
    return static_cast<bool>(status);
}

void say(Messages& messages, const std::string& message) {
    messages.status = message;
    logInfo(message);
}

}  // namespace sward
