#include "app/console.h"

#include <utility>

namespace sward {
namespace {

constexpr size_t kLinesKept = 1000;

}  // namespace

void openLog(LogBook& log) {
    log.sink = addLogSink([&log](LogLevel level, const std::string& text) {
        const std::lock_guard lock(log.mutex);
        log.fresh.push_back({level, text});
    });
}

void closeLog(LogBook& log) { removeLogSink(std::exchange(log.sink, 0)); }

bool takeLog(LogBook& log) {
    std::deque<LogLine> fresh;
    {
        const std::lock_guard lock(log.mutex);
        fresh.swap(log.fresh);
    }
    for (LogLine& line : fresh) {
        log.lines.push_back(std::move(line));
        if (log.lines.size() > kLinesKept) log.lines.pop_front();
    }
    return !fresh.empty();
}

bool hasFreshLog(const LogBook& log) {
    const std::lock_guard lock(log.mutex);
    return !log.fresh.empty();
}

int runEntered(Console& console) {
    int ran = 0;
    for (; !console.luaLines.empty() && console.runLua; ++ran) {
        const std::string line = console.luaLines.front();
        console.luaLines.pop_front();
        if (const Status status = console.runLua(line); !status) logError(status.error().text());
    }
    return ran;
}

}  // namespace sward
