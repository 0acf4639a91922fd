// The report of a sweep: one page that needs nothing else, and the files beside it.
#include "cost/cost_report.h"

#include <gtest/gtest.h>

#include "cost/cost_rows.h"
#include "maps/map_io.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {
namespace {

TEST(CostReport, IsOneFileThatRefersToNothingElse) {
    const TempDir dir;
    CostRun r = run({row(0, 10, 0.1), row(1, 20, 0.05)}, 2);
    r.project = "<park> & co";
    markFrontier(r.rows);
    const std::vector<uint8_t> gray(20 * 20 * 3, 128);
    ASSERT_TRUE(writeImagePng(dir / "row.png", 20, 20, 3, gray));
    ASSERT_TRUE(writeImagePng(dir / "truth.png", 20, 20, 3, gray));
    ASSERT_TRUE(writeCostFiles(r, dir.path, dir.path, tables().techniques));
    const std::string html = readText(dir / "report.html");
    EXPECT_NE(html.find("&lt;park&gt; &amp; co"), std::string::npos);
    EXPECT_NE(html.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
    for (const char* outside : {"src=\"http", "href=", "url(", "@import", "src=\"row"})
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
    for (const char* file : {"cost.csv", "cost.json", "plot-eye.svg", "plot-eye.png", "shipped.md"})
        EXPECT_TRUE(std::filesystem::exists(dir / file)) << file;
}

TEST(CostReport, Base64IsTheStandards) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace sward::test
