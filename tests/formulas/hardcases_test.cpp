// The report of hard cases without a GPU: its rows, its table and its JSON.
#include "formulas/hardcases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace sward {
namespace {

TEST(HardCases, EveryRowPassesOnTheCpuAndItsPublishedFormDoesNot) {
    const auto rows = runHardCases(nullptr);
    EXPECT_GT(rows.size(), 50u);
    for (const HardCaseRow& r : rows) {
        EXPECT_TRUE(r.pass) << r.id << ' ' << r.name << ": " << r.oursCpu << r.fault;
        EXPECT_FALSE(r.hasGpu);
        if (r.hasPublished) {
            EXPECT_FALSE(r.published <= r.tolerance) << r.id << ' ' << r.name;
        }
    }
    EXPECT_TRUE(allPass(rows));
}

TEST(HardCases, CoverTheCasesThatFormulasCanBreak) {
    std::set<std::string> ids;
    for (const HardCaseRow& r : runHardCases(nullptr)) ids.insert(r.id);
    for (int i : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 15, 17, 18, 19, 20, 21, 22, 23, 24, 25})
        EXPECT_EQ(ids.count("B-" + std::to_string(i)), 1u) << i;
    for (int i = 1; i <= 8; ++i) EXPECT_EQ(ids.count("D-" + std::to_string(i)), 1u) << i;
    for (int i = 1; i <= 8; ++i) EXPECT_EQ(ids.count("H-" + std::to_string(i)), 1u) << i;
    for (int i : {1, 2, 3, 5, 6, 7, 9}) EXPECT_EQ(ids.count("J-" + std::to_string(i)), 1u) << i;
    for (int i : {3, 7, 8}) EXPECT_EQ(ids.count("T-" + std::to_string(i)), 1u) << i;
}

HardCaseRow broken() {
    HardCaseRow r;
    r.id = "X-1";
    r.name = "a \"quoted\" name";
    r.hasPublished = true;
    r.published = std::nan("");
    r.oursCpu = HUGE_VAL;
    r.tolerance = 1e-6;
    return r;
}

TEST(HardCases, JsonNamesNumbersThatAreNoneAndParses) {
    auto rows = runHardCases(nullptr);
    rows.push_back(broken());
    const auto json = nlohmann::json::parse(hardCasesJson(rows));
    ASSERT_EQ(json.at("rows").size(), rows.size());
    for (size_t i = 0; i < rows.size(); ++i) {
        const auto& j = json["rows"][i];
        EXPECT_EQ(j.at("id"), rows[i].id);
        EXPECT_EQ(j.at("name"), rows[i].name);
        EXPECT_EQ(j.at("pass"), rows[i].pass);
        EXPECT_TRUE(j.at("ours_gpu").is_null());
        EXPECT_EQ(j.at("tolerance").get<double>(), rows[i].tolerance);
    }
    EXPECT_EQ(json["rows"][0]["published"], "nan");  // the sun at noon
    EXPECT_EQ(json["rows"].back()["ours_cpu"], "inf");
    EXPECT_FALSE(allPass(rows));
}

TEST(HardCases, TextHasALineARowAndCountsThem) {
    const std::string text = hardCasesText({broken()});
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
    EXPECT_NE(text.find("NaN"), std::string::npos);
    EXPECT_NE(text.find("FAIL"), std::string::npos);
    EXPECT_NE(text.find("0 of 1 pass"), std::string::npos);
}

}  // namespace
}  // namespace sward
