// The log as the console shows it, and the line in which a person types Lua.
// Does not: run Lua itself; who owns the editor gives runLua.
#pragma once
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/log.h"

namespace sward {

struct LogLine {
    LogLevel level;
    std::string text;
};
// Lines come from any thread.
struct LogBook {
    mutable std::mutex mutex;
    std::deque<LogLine> fresh;  // not yet seen by a frame
    std::deque<LogLine> lines;  // the last thousand; frames only
    int sink = 0;
};

// From now on the book gets what is logged by any thread, until closeLog. The book must stay where it is.
void openLog(LogBook& log);
// The log goes on without the book; nothing happens if it was not opened.
void closeLog(LogBook& log);
// Takes what was logged since the last call into `lines`, of which the oldest go. True if there was anything.
bool takeLog(LogBook& log);
// True if a line waits for takeLog.
bool hasFreshLog(const LogBook& log);

struct Console {
    LogBook log;
    std::string line;  // being typed
    std::vector<std::string> history;
    size_t recalled = 0;                               // lines back from its end that the line is of; 0: newly typed
    std::string typed;                                 // what stood there before a former line was recalled
    std::function<Status(const std::string&)> runLua;  // the console's line; empty: the console only shows
    std::function<std::vector<std::string>(const std::string& word)> completions;  // of a word in it; may be empty
    std::deque<std::string> luaLines;  // entered, run before the next frame: they may run frames themselves
};
// The line `step` further in the history (-1: an older one), which begins anew with each line entered; beyond its end
// what was being typed.
std::string recall(Console& console, const std::string& text, int step);
// The text with its last word completed as far as all that it may become agree; several are told in the log.
std::string completed(const Console& console, const std::string& text);
// Runs the lines that were entered, in order; what fails is logged. Returns how many ran.
int runEntered(Console& console);

}  // namespace sward
