// The file of expected values: how its records become numbers, and what is refused.
#include "formulas/expected_values.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support.h"

namespace sward::test {
namespace {

TEST(ExpectedValues, RecordsBecomeFlatListsOfNumbers) {
    const TempDir dir;
    writeText(dir / "e.json", R"({"about": "text is no group", "hash": [
        {"in": [[1, 2], [3]], "yes": true, "no": false, "none": null, "family": ["u", "v", "g"], "why": "prose"}]})");
    const auto values = loadExpectedValues((dir / "e.json").string());
    ASSERT_TRUE(values) << values.error().text();
    ASSERT_EQ(values->size(), 1u);
    const ExpectedRecord& r = values->at("hash").at(0);
    EXPECT_EQ(r.at("in"), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(r.at("yes"), std::vector<double>{1});
    EXPECT_EQ(r.at("no"), std::vector<double>{0});
    EXPECT_TRUE(std::isnan(r.at("none").at(0)));
    EXPECT_EQ(r.at("family"), (std::vector<double>{0, 1, 2}));
    EXPECT_TRUE(r.at("why").empty());
}

TEST(ExpectedValues, WhatIsNotThereOrNoObjectIsNamed) {
    const TempDir dir;
    EXPECT_EQ(loadExpectedValues((dir / "none.json").string()).error().file, (dir / "none.json").string());
    for (const char* bad : {"", "[]", "{", "7"}) {
        writeText(dir / "bad.json", bad);
        const auto values = loadExpectedValues((dir / "bad.json").string());
        ASSERT_FALSE(values) << bad;
        EXPECT_EQ(values.error().code, ExitCode::Unsound) << bad;
    }
}

TEST(ExpectedValues, TheOwnFileIsFound) {
    const auto values = loadExpectedValues(expectedValuesFile());
    ASSERT_TRUE(values) << values.error().text();
    EXPECT_GT(values->size(), 10u);
}

}  // namespace
}  // namespace sward::test
