// The limits that Sward keeps to: what a benchmark measured beside what it may be at most.
// A bench/*.cpp adds its rows with reportLimit from a function that SWARD_LIMITS names; main prints the table and exits
// with 1 if a row is over its limit. Does not: measure.
#pragma once
#include <functional>
#include <vector>

// Adds a row. It passes if measured <= limit; a NaN does not. Units: "ms", "s", "x" (a ratio), "files", ...
void reportLimit(const char* name, double measured, double limit, const char* unit);

// The median of `values`; NaN if there are none.
double median(std::vector<double> values);

// Seconds that `work` takes by the wall.
double seconds(const std::function<void()>& work);

namespace sward {
struct Gpu;
}
// The headless context that all benchmarks share, made current; null where there is none.
sward::Gpu* gpu();

namespace limits {
int add(const char* group, void (*measure)());
}

// SWARD_LIMITS("ecs", [] { ... reportLimit(...); }): measured once per run; skipped where --filter names another group.
#define SWARD_LIMITS(group, ...) SWARD_LIMITS_AT(group, __COUNTER__, __VA_ARGS__)
#define SWARD_LIMITS_AT(group, number, ...) SWARD_LIMITS_NAMED(group, number, __VA_ARGS__)
#define SWARD_LIMITS_NAMED(group, number, ...) \
    [[maybe_unused]] static const int limits##number = limits::add(group, __VA_ARGS__)
