// Starts sward: see cli/cli.h.
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>

#include "cli/cli.h"
#include "core/log.h"
#include "core/memory_budget.h"

namespace {

uint64_t budget = 0;

[[noreturn]] void endWithoutMemory() {
    sward::boundMemory(sward::machineMemory());  // room for the message
    sward::logError(sward::outOfMemory(budget).text());
    std::_Exit(static_cast<int>(sward::ExitCode::Failed));
}

// An exception that nothing caught, of whatever thread.
[[noreturn]] void onTerminate() {
    try {
        if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        endWithoutMemory();
    } catch (...) {
    }
    std::abort();
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes becomes an error that is told
    std::set_terminate(onTerminate);
    const char* asked = std::getenv("SWARD_MEMORY");
    const sward::Result<uint64_t> bytes = sward::memoryBudget(asked ? asked : "", sward::machineMemory());
    if (!bytes) return sward::report(bytes.error());
    budget = *bytes;
    sward::boundMemory(budget);
    try {
        return sward::runCommandLine(argc, argv);
    } catch (const std::bad_alloc&) {
        endWithoutMemory();
    }
}
