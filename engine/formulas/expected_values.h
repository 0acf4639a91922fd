// The expected values of the formulas at their hard points: tests/data/hard-cases-expected.json, flattened to numbers.
// Does not: judge. Cost: 10 ms, once.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/error.h"

namespace sward {

// One record: field name -> its numbers, nested arrays flattened in order. true and false are 1 and 0, null is NaN; of
// strings only the ray families are kept, as u = 0, v = 1, g (ground) = 2.
using ExpectedRecord = std::map<std::string, std::vector<double>>;
using ExpectedValues = std::map<std::string, std::vector<ExpectedRecord>>;  // by group

// Reads such a file; errors name it.
Result<ExpectedValues> loadExpectedValues(const std::string& file);
// Where the file is: ../../tests/data beside the executable's folder (build/release), else in the source tree.
std::string expectedValuesFile();

}  // namespace sward
