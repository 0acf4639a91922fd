// `sward reference` and `sward merge`: parts of a picture, down to one.
#include <gtest/gtest.h>

#include "cli/cli.h"
#include "support.h"

namespace sward::test {
namespace {

int runReference(std::vector<std::string> args) {
    args.insert(args.begin(), "sward");
    std::vector<char*> argv;
    for (std::string& a : args) argv.push_back(a.data());
    testing::internal::CaptureStdout();
    const int code = runCommandLine(static_cast<int>(argv.size()), argv.data());
    testing::internal::GetCapturedStdout();
    return code;
}

// Who starts N jobs with --shard I/N and merges what they wrote need not ask whether N is 1.
TEST(ReferenceVerb, OneShardIsAPartAsAnyOther) {
    TempDir dir;
    const std::string project = (dir / "p").string(), whole = (dir / "whole.exr").string();
    ASSERT_EQ(runReference({"new", project}), 0);
    const auto reference = [&](std::vector<std::string> more) {
        std::vector<std::string> args = {"reference", project, "--size", "24x16", "--samples", "1"};
        args.insert(args.end(), more.begin(), more.end());
        return runReference(args);
    };
    ASSERT_EQ(reference({"--out", whole}), 0);
    for (const int shards : {1, 2}) {
        std::vector<std::string> merge = {"merge"};
        for (int i = 0; i < shards; ++i) {
            merge.push_back((dir / (std::to_string(shards) + "-" + std::to_string(i) + ".part")).string());
            ASSERT_EQ(reference({"--shard", std::to_string(i) + "/" + std::to_string(shards), "--out", merge.back()}),
                      0)
                << i << '/' << shards;
        }
        const std::string joined = (dir / "joined.exr").string();
        merge.insert(merge.end(), {"--out", joined});
        ASSERT_EQ(runReference(merge), 0);
        EXPECT_EQ(readText(joined), readText(whole)) << shards << " shards";
    }
}

}  // namespace
}  // namespace sward::test
