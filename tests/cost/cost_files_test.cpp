// A sweep's files: what is written comes back, parts join, and what somebody or something has spoilt is refused, never
// believed.
#include <gtest/gtest.h>

#include <random>

#include "core/json.h"
#include "cost/cost_files.h"
#include "cost/cost_rows.h"
#include "support.h"

namespace sward::test {
namespace {

TEST(CostFiles, CsvHasTheColumnsPromised) {
    std::vector<CostRow> rows = {row(0, 10, 0.1), row(1, 20, 0.05)};
    rows[1].skipped = "1e9 blades, \"too many\"";
    const std::string csv = costCsv(run(rows, 2));
    EXPECT_EQ(csv,
              "camera,technique,settings,ms_median,ms_p95,appearance,appearance_sigma,bias,contrast,flip,rmse,gpu_"
              "bytes,on_frontier,skipped\n"
              "eye,hybrid,maxGeom=0,10,20,0.1,0.010000000000000002,0.05,0.03333333333333333,0.25,0.125,1000,0,\n"
              "eye,hybrid,maxGeom=1,,,,,,,,,,0,\"1e9 blades, \"\"too many\"\"\"\n");
}
TEST(CostFiles, JsonComesBackBitForBit) {
    CostRun before = run({row(0, 10.0 / 3, 0.1 / 3), row(1, std::numeric_limits<double>::quiet_NaN(), 0.05)}, 2);
    before.rows[0].ms = {3, 10.0 / 3}, before.rows[0].msSigma = 0.1;
    before.rows[0].metrics.appearance.sigma = std::numeric_limits<double>::quiet_NaN();
    const std::string text = writeJson(costJson(before));
    auto json = parseJson(text, "cost.json");
    ASSERT_TRUE(json) << json.error().text();
    auto after = costFrom(*json, "cost.json");
    ASSERT_TRUE(after) << after.error().text();
    EXPECT_EQ(writeJson(costJson(*after)), text);
    json->object.erase("floors");
    auto broken = costFrom(*json, "cost.json");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().code, ExitCode::Unsound);
    EXPECT_NE(broken.error().message.find("floors"), std::string::npos);
}

TEST(CostMerge, OfPartsIsTheWholeInOrder) {
    const CostRun whole = run({row(0, 1, 1), row(1, 2, 0.5), row(2, 3, 0.2)}, 3);
    auto merged = mergeCosts({run({row(1, 2, 0.5)}, 3), run({row(0, 1, 1), row(2, 3, 0.2)}, 3)});
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_EQ(merged->machines.size(), 2u);
    EXPECT_EQ(merged->rows[1].machine, 0);
    EXPECT_EQ(merged->rows[2].machine, 1);
    for (CostRow& r : merged->rows) r.machine = 0;
    merged->machines.resize(1);
    EXPECT_EQ(writeJson(costJson(*merged)), writeJson(costJson(whole)));
}
TEST(CostMerge, RefusesOtherSweepsAndMissingOrDoubleRows) {
    CostRun other = run({row(1, 2, 0.5)}, 2);
    other.hash = "def";
    const CostRun first = run({row(0, 1, 1)}, 2), second = run({row(1, 2, 0.5)}, 2);
    EXPECT_FALSE(mergeCosts({first, other}));
    EXPECT_NE(mergeCosts({first, first}).error().message.find("two parts"), std::string::npos);
    EXPECT_NE(mergeCosts({first}).error().message.find("row 1 is in none"), std::string::npos);
    EXPECT_NE(mergeCosts({second}).error().message.find("row 0 is in none"), std::string::npos);
    EXPECT_FALSE(mergeCosts({}));
}

TEST(CostFiles, SpoiltInAnyPlaceAreReadOrRefusedButNeverWorse) {
    const std::string good = writeJson(costJson(run({row(0, 10, 0.1), row(1, 20, 0.05)}, 2)));
    std::mt19937 random(7);
    int read = 0, refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string text = good;
        for (int edits = 1 + static_cast<int>(random() % 3); edits > 0; --edits) {
            const size_t at = random() % text.size();
            constexpr const char* kPieces[] = {"1e308", "-1e308", "null", "\"inf\"", "[", "{}", "9", "-", "\"", "true"};
            if (random() % 2)
                text[at] = static_cast<char>(random() % 256);
            else
                text.replace(at, random() % 6, kPieces[random() % std::size(kPieces)]);
        }
        const auto json = parseJson(text, "cost.json");
        const auto back = json ? costFrom(*json, "cost.json") : Result<CostRun>(json.error());
        back ? ++read : ++refused;
        if (back)
            EXPECT_FALSE(costCsv(*back).empty()), (void)static_cast<bool>(mergeCosts({*back}));
        else
            EXPECT_EQ(back.error().code, ExitCode::Unsound);
    }
    EXPECT_GT(read, 50) << "some edits spoil nothing";
    EXPECT_GT(refused, 500);
}
// A part of a sweep that was damaged on its way is refused: whichever byte it was, unless no value follows from it.
TEST(CostFiles, AFileWithAnyOtherByteIsRefused) {
    TempDir dir;
    const std::string good = writeJson(costJson(run({row(0, 10, 0.1)}, 1)));
    const auto file = dir / "cost.json";
    writeText(file, good);
    ASSERT_TRUE(readCost(file));
    for (size_t i = 0; i < good.size(); ++i) {
        if (std::isspace(static_cast<unsigned char>(good[i]))) continue;
        std::string text = good;
        text[i] = static_cast<char>(text[i] ^ 1);
        writeText(file, text);
        const auto back = readCost(file);
        ASSERT_FALSE(back) << "byte " << i << ", '" << good[i] << "'";
        EXPECT_EQ(back.error().code, ExitCode::Unsound);
    }
}
TEST(CostFiles, NumbersThatNoFieldHoldsAreNone) {
    std::string text = writeJson(costJson(run({row(0, 10, 0.1)}, 1)));
    text.replace(text.find("320"), 3, "1e300");
    const auto json = parseJson(text, "cost.json");
    ASSERT_TRUE(json);
    const auto back = costFrom(*json, "cost.json");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->width, 0);
}

}  // namespace
}  // namespace sward::test
