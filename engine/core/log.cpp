#include "core/log.h"

#include <cstdio>
#include <map>
#include <mutex>

namespace sward {
namespace {
struct Log {
    std::mutex mutex;
    std::map<int, LogSink> sinks;
    int nextId = 1;
    bool verbose = false;
};
Log& log() {
    static Log instance;
    return instance;
}
void write(LogLevel level, const char* prefix, const std::string& text) {
    std::lock_guard lock(log().mutex);
    if (level != LogLevel::Info || log().verbose) std::fprintf(stderr, "%s%s\n", prefix, text.c_str());
    for (auto& [id, sink] : log().sinks) sink(level, text);
}
}  // namespace

void logInfo(const std::string& text) { write(LogLevel::Info, "sward: ", text); }
void logWarning(const std::string& text) { write(LogLevel::Warning, "sward: warning: ", text); }
void logError(const std::string& text) { write(LogLevel::Error, "sward: error: ", text); }

void setLogVerbose(bool verbose) {
    std::lock_guard lock(log().mutex);
    log().verbose = verbose;
}
int addLogSink(LogSink sink) {
    std::lock_guard lock(log().mutex);
    log().sinks[log().nextId] = std::move(sink);
    return log().nextId++;
}
void removeLogSink(int id) {
    std::lock_guard lock(log().mutex);
    log().sinks.erase(id);
}

}  // namespace sward
