// The log: who gets which lines.
#include "core/log.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace sward {
namespace {

using Lines = std::vector<std::pair<LogLevel, std::string>>;

TEST(Log, SinksGetEveryLineUntilTheyAreRemoved) {
    Lines first, second;
    const int a = addLogSink([&](LogLevel level, const std::string& text) { first.push_back({level, text}); });
    const int b = addLogSink([&](LogLevel level, const std::string& text) { second.push_back({level, text}); });
    EXPECT_NE(a, b);
    testing::internal::CaptureStderr();
    logInfo("loaded");
    removeLogSink(b);
    logWarning("repaired");
    logError("failed");
    removeLogSink(a);
    logError("unheard");
    testing::internal::GetCapturedStderr();
    EXPECT_EQ(second, (Lines{{LogLevel::Info, "loaded"}}));
    EXPECT_EQ(first, (Lines{{LogLevel::Info, "loaded"}, {LogLevel::Warning, "repaired"}, {LogLevel::Error, "failed"}}));
}

TEST(Log, StandardErrorGetsFactsOnlyWhereTheyAreWanted) {
    const auto said = [](bool verbose) {
        setLogVerbose(verbose);
        testing::internal::CaptureStderr();
        logInfo("fact");
        logWarning("odd");
        logError("bad");
        setLogVerbose(false);
        return testing::internal::GetCapturedStderr();
    };
    EXPECT_EQ(said(false), "sward: warning: odd\nsward: error: bad\n");
    EXPECT_EQ(said(true), "sward: fact\nsward: warning: odd\nsward: error: bad\n");
}

TEST(Log, RemovingAnUnknownSinkDoesNothing) {
    int lines = 0;
    const int id = addLogSink([&](LogLevel, const std::string&) { ++lines; });
    removeLogSink(id + 1000);
    testing::internal::CaptureStderr();
    logWarning("heard");
    testing::internal::GetCapturedStderr();
    removeLogSink(id);
    EXPECT_EQ(lines, 1);
}

}  // namespace
}  // namespace sward
