// On what machine times were taken, and a sweep's rows by machine, for times of several make no one table.
// Does not: measure anything.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "cost/cost.h"

namespace sward {

// This one: its name, its processor's (empty where the system does not say), the threads that take part.
CostMachine thisMachine(const std::string& renderer, const std::string& timing);
// By all that is known of them; of unknown name is none the same as another.
bool isSameMachine(const CostMachine& a, const CostMachine& b);
// Lists each machine once; where one was there twice, marks the frontiers anew, each over all rows of its machine.
void joinMachines(CostRun& run);
// The rows of each machine that has some, under a name that may be part of a file's name: its host's, with a number
// where several are called alike.
std::vector<std::pair<std::string, CostRun>> runsByMachine(const CostRun& run);

}  // namespace sward
