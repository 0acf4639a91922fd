#include "app/console.h"

#include <algorithm>
#include <cctype>
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

std::string recall(Console& c, const std::string& text, int step) {
    if (c.recalled == 0) c.typed = text;
    if (step < 0 && c.recalled < c.history.size()) ++c.recalled;
    if (step > 0 && c.recalled > 0) --c.recalled;
    return c.recalled == 0 ? c.typed : c.history[c.history.size() - c.recalled];
}

std::string completed(const Console& c, const std::string& text) {
    const auto inWord = [](char l) { return std::isalnum(static_cast<unsigned char>(l)) || l == '_' || l == '.'; };
    size_t begin = text.size();
    while (begin > 0 && inWord(text[begin - 1])) --begin;
    if (!c.completions || begin == text.size()) return text;
    const std::vector<std::string> all = c.completions(text.substr(begin));
    if (all.empty()) return text;
    std::string common = all.front(), told;
    for (const std::string& one : all) {
        common.resize(static_cast<size_t>(std::mismatch(common.begin(), common.end(), one.begin(), one.end()).first -
                                          common.begin()));
        told += (told.empty() ? "" : "  ") + one;
    }
    if (all.size() > 1) logInfo(told);
    return text.substr(0, begin) + common;
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
