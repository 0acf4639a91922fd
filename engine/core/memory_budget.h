// How much memory the program may take: a share of the machine's, so that a scene that is too large ends with a message
// and not with a machine that swaps, nor by the system's choice of what to kill.
// Does not: know beforehand what a scene takes; an allocation beyond the budget fails as std::bad_alloc.
#pragma once
#include <cstdint>
#include <string>

#include "core/error.h"

namespace sward {

inline constexpr double kMemoryShare = 0.8;

// Bytes that the machine has, or its container may use if that is less; 0 if neither can be read.
uint64_t machineMemory();
// The bytes meant by "12G", "800M" or "60%" of `machine`; of nothing kMemoryShare of it. Usage error for anything else,
// and below 256 MiB, with which nothing starts.
Result<uint64_t> memoryBudget(const std::string& asked, uint64_t machine);
// From now on allocations fail beyond so many bytes of data (Linux: RLIMIT_DATA). False if the system refuses.
bool boundMemory(uint64_t bytes);
// What is said when they do: the budget, and what to make smaller. Failed.
Error outOfMemory(uint64_t budget);

}  // namespace sward
