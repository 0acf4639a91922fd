#include "formulas/expected_values.h"

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/resources.h"

namespace sward {
namespace {

void flatten(const nlohmann::json& value, std::vector<double>& out) {
    if (value.is_array()) {
        for (const nlohmann::json& item : value) flatten(item, out);
    } else if (value.is_boolean()) {
        out.push_back(value.get<bool>() ? 1 : 0);
    } else if (value.is_null()) {
        out.push_back(std::numeric_limits<double>::quiet_NaN());
    } else if (value.is_number()) {
        out.push_back(value.get<double>());
    } else if (value == "u" || value == "v" || value == "g") {
        out.push_back(value == "u" ? 0 : value == "v" ? 1 : 2);
    }
}

ExpectedRecord recordOf(const nlohmann::json& object) {
    ExpectedRecord record;
    for (const auto& [field, value] : object.items()) flatten(value, record[field]);
    return record;
}

}  // namespace

Result<ExpectedValues> loadExpectedValues(const std::string& file) {
    std::ifstream stream(file);
    if (!stream) return failed("cannot read the expected values", "run from the source tree").at(file);
    const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
    if (!json.is_object()) return unsound("is not a JSON object").at(file);
    ExpectedValues values;
    for (const auto& [group, records] : json.items()) {
        if (!records.is_array()) continue;
        for (const nlohmann::json& record : records) values[group].push_back(recordOf(record));
    }
    return values;
}

std::string expectedValuesFile() { return resource("tests/data/hard-cases-expected.json").string(); }

}  // namespace sward
