// The log: lines for standard error and for whoever listens (the editor's console).
// Thread-safe. Does not: format errors; callers pass Error::text().
#pragma once
#include <functional>
#include <string>

namespace sward {

enum class LogLevel { Info, Warning, Error };
using LogSink = std::function<void(LogLevel, const std::string&)>;

// One line each, without a line feed: to the sinks, and to standard error.
void logInfo(const std::string& text);     // progress and facts; standard error only with setLogVerbose
void logWarning(const std::string& text);  // something was repaired or ignored
void logError(const std::string& text);    // something failed; the old state stays

// Whether logInfo's lines go to standard error too; at first they do not. Sinks get them always.
void setLogVerbose(bool verbose);
// Calls sink for each line until the returned id is removed. The sink runs in the logging thread.
int addLogSink(LogSink sink);
// Ends the calls of a sink; an id that is unknown is ignored.
void removeLogSink(int id);

}  // namespace sward
