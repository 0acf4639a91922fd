#include "cost/cost_machine.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>

#include "core/file_lock.h"
#include "core/jobs.h"

namespace sward {
namespace {

// "model name      : ..." of the first processor.
std::string cpuName() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        const size_t at = line.find_first_not_of(": \t", line.find(':'));
        return at == std::string::npos ? "" : line.substr(at);
    }
    return "";
}

std::string fileNameOf(const CostMachine& m) {
    std::string name = m.host.empty() ? "machine" : m.host;
    for (char& c : name)
        if (!(std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')) c = '-';
    return name;
}

}  // namespace

CostMachine thisMachine(const std::string& renderer, const std::string& timing) {
    return {renderer, timing, workerCount(), hostName(), cpuName()};
}

bool isSameMachine(const CostMachine& a, const CostMachine& b) {
    return !a.host.empty() && a.host == b.host && a.cpu == b.cpu && a.renderer == b.renderer && a.timing == b.timing &&
           a.cores == b.cores;
}

void joinMachines(CostRun& run) {
    std::vector<CostMachine> kept;
    std::vector<int> now;
    for (const CostMachine& m : run.machines) {
        const auto same = std::find_if(kept.begin(), kept.end(), [&](const auto& k) { return isSameMachine(k, m); });
        now.push_back(static_cast<int>(same - kept.begin()));
        if (same == kept.end()) kept.push_back(m);
    }
    for (CostRow& row : run.rows) row.machine = now[static_cast<size_t>(row.machine)];
    const bool joined = kept.size() < run.machines.size();
    run.machines = std::move(kept);
    if (joined) markFrontier(run.rows);
}

std::vector<std::pair<std::string, CostRun>> runsByMachine(const CostRun& run) {
    std::vector<std::pair<std::string, CostRun>> all;
    std::set<std::string> names;
    for (size_t m = 0; m < run.machines.size(); ++m) {
        CostRun own = run;
        own.machines = {run.machines[m]};
        std::erase_if(own.rows, [&](const CostRow& r) { return r.machine != static_cast<int>(m); });
        if (own.rows.empty()) continue;
        for (CostRow& row : own.rows) row.machine = 0;
        std::string name = fileNameOf(run.machines[m]);
        for (int i = 2; !names.insert(name).second; ++i) name = fileNameOf(run.machines[m]) + "-" + std::to_string(i);
        all.emplace_back(std::move(name), std::move(own));
    }
    return all;
}

}  // namespace sward
