#include "core/memory_budget.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>

namespace sward {
namespace {

constexpr double kLeastBudget = 256.0 * (1 << 20);

// Of a control group: a number, or "max".
uint64_t groupLimit(const char* file) {
    uint64_t bytes = 0;
    return std::ifstream(file) >> bytes ? bytes : 0;
}

std::optional<double> unitOf(const std::string& suffix, uint64_t machine) {
    if (suffix == "%") return static_cast<double>(machine) / 100;
    if (suffix == "G") return 1 << 30;
    if (suffix == "M") return 1 << 20;
    return {};
}

}  // namespace

uint64_t machineMemory() {
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    uint64_t bytes = pages > 0 && size > 0 ? static_cast<uint64_t>(pages) * static_cast<uint64_t>(size) : 0;
    for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
        if (const uint64_t limit = groupLimit(file); limit > 0) bytes = bytes > 0 ? std::min(bytes, limit) : limit;
    return bytes;
}

Result<uint64_t> memoryBudget(const std::string& asked, uint64_t machine) {
    if (asked.empty()) return static_cast<uint64_t>(kMemoryShare * static_cast<double>(machine));
    char* end = nullptr;
    const double number = std::strtod(asked.c_str(), &end);
    const std::optional<double> unit = unitOf(end, machine);
    const double bytes = unit ? number * *unit : 0;
    if (!(bytes >= kLeastBudget) || bytes > 1e18)
        return usage(fmt::format("\"{}\" is no amount of memory", asked),
                     "write such as 12G, 800M or 60% (of this machine's), 256M at least");
    return static_cast<uint64_t>(bytes);
}

bool boundMemory(uint64_t bytes) {
    rlimit limit{};
    if (bytes == 0 || getrlimit(RLIMIT_DATA, &limit) != 0) return false;
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    return setrlimit(RLIMIT_DATA, &limit) == 0;
}

Error outOfMemory(uint64_t budget) {
    return failed(fmt::format("this needs more memory than the {:.3g} GB that it may take",
                              static_cast<double>(budget) / (1 << 30)),
                  "make the terrain, distances, maps or the picture smaller, or let it take more: SWARD_MEMORY=90%");
}

}  // namespace sward
