// build/release/bench: every benchmark, then the table of limits. Exit 1 if a limit is missed.
//   --filter=TEXT   only groups of limits and benchmarks whose name contains TEXT (a regular expression for the latter)
//   --limits        only the table; --benchmark_... as Google Benchmark has them
#include <benchmark/benchmark.h>

#include <chrono>

#include "bench/limits.h"
#include "gpu/gpu.h"
#include "tests/child.h"

namespace {
struct Group {
    const char* name;
    void (*measure)();
};
struct Row {
    std::string name, unit;
    double measured, limit;
    bool pass;
};
std::vector<Group>& groups() {
    static std::vector<Group> all;
    return all;
}
std::vector<Row>& rows() {
    static std::vector<Row> all;
    return all;
}

// Prints the table; the number of rows that are over their limit.
int printTable() {
    int missed = 0;
    std::printf("\n%-64s %10s %10s %-6s\n", "limit", "measured", "at most", "unit");
    for (const Row& r : rows()) {
        std::printf("%-64s %10.4g %10.4g %-6s %s\n", r.name.c_str(), r.measured, r.limit, r.unit.c_str(),
                    r.pass ? "pass" : "MISSED");
        missed += r.pass ? 0 : 1;
    }
    std::printf("%zu limits, %d missed\n", rows().size(), missed);
    return missed;
}
}  // namespace

int limits::add(const char* group, void (*measure)()) {
    groups().push_back({group, measure});
    return 0;
}

void reportLimit(const char* name, double measured, double limit, const char* unit) {
    rows().push_back({name, unit, measured, limit, measured <= limit});
    std::fprintf(stderr, "%s: %.4g %s (at most %.4g)\n", name, measured, unit, limit);
}

double median(std::vector<double> values) {
    if (values.empty()) return std::nan("");
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

sward::Gpu* gpu() {
    static std::unique_ptr<sward::Gpu> instance = [] {
        auto made = sward::makeHeadlessGpu();
        return made ? std::move(*made) : nullptr;
    }();
    if (instance) sward::makeCurrent(*instance);
    return instance.get();
}

int main(int argc, char** argv) {
    if (const std::optional<int> code = sward::test::childMain(argc, argv)) return *code;
    std::string filter;
    bool limitsOnly = false;
    std::vector<std::string> texts;
    for (int i = 0; i < argc; ++i) {
        std::string a = argv[i];
        if (a.starts_with("--filter=")) filter = a.substr(9), a = "--benchmark_filter=" + filter;
        if (a == "--filter" && i + 1 < argc) filter = argv[++i], a = "--benchmark_filter=" + filter;
        if (a == "--limits")
            limitsOnly = true;
        else
            texts.push_back(a);
    }
    std::vector<char*> args;
    for (std::string& t : texts) args.push_back(t.data());
    int count = static_cast<int>(args.size());
    benchmark::Initialize(&count, args.data());
    if (benchmark::ReportUnrecognizedArguments(count, args.data())) return 2;
    size_t found = limitsOnly ? 0 : benchmark::RunSpecifiedBenchmarks();
    for (const Group& g : groups()) {
        if (std::string_view(g.name).find(filter) == std::string_view::npos) continue;
        ++found;
        g.measure();
    }
    if (found == 0) {
        std::fprintf(stderr, "bench: nothing is named like \"%s\"\n", filter.c_str());
        return 2;
    }
    return printTable() > 0 ? 1 : 0;
}
