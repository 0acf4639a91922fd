// The log of the console, from any thread, and the lines of Lua that wait.
#include "app/console.h"

#include <gtest/gtest.h>

#include <thread>

namespace sward {
namespace {

TEST(LogBook, TakesWhatAnyThreadLoggedInOrderAndNothingAfterItsEnd) {
    LogBook log;
    openLog(log);
    EXPECT_FALSE(hasFreshLog(log));
    EXPECT_FALSE(takeLog(log));
    std::thread([] { logWarning("first"); }).join();
    logInfo("second");
    EXPECT_TRUE(hasFreshLog(log));
    EXPECT_TRUE(takeLog(log));
    EXPECT_FALSE(hasFreshLog(log));
    ASSERT_EQ(log.lines.size(), 2u);
    EXPECT_EQ(log.lines[0].text, "first");
    EXPECT_EQ(log.lines[0].level, LogLevel::Warning);
    EXPECT_EQ(log.lines[1].text, "second");
    closeLog(log);
    logInfo("third");
    EXPECT_FALSE(takeLog(log));
}

TEST(LogBook, KeepsTheLastThousandLines) {
    LogBook log;
    openLog(log);
    for (int i = 0; i < 1205; ++i) logInfo(std::to_string(i));
    takeLog(log);
    closeLog(log);
    ASSERT_EQ(log.lines.size(), 1000u);
    EXPECT_EQ(log.lines.front().text, "205");
    EXPECT_EQ(log.lines.back().text, "1204");
}

TEST(Console, RunsEnteredLinesInOrderAndLogsWhatFails) {
    Console console;
    console.luaLines = {"a", "bad", "b"};
    EXPECT_EQ(runEntered(console), 0) << "nobody runs Lua";
    EXPECT_EQ(console.luaLines.size(), 3u);
    openLog(console.log);
    std::string ran;
    console.runLua = [&](const std::string& line) -> Status {
        ran += line + " ";
        if (line == "bad") return Error{ExitCode::Failed, "no such call", "", 0, 0, ""};
        return {};
    };
    EXPECT_EQ(runEntered(console), 3);
    EXPECT_EQ(ran, "a bad b ");
    EXPECT_TRUE(takeLog(console.log));
    closeLog(console.log);
    EXPECT_EQ(console.log.lines.back().text, "no such call");
    EXPECT_EQ(runEntered(console), 0);
}

TEST(Console, FormerLinesComeBackAndGoAgain) {
    Console c;
    c.history = {"one()", "two()"};
    EXPECT_EQ(recall(c, "thr", -1), "two()");
    EXPECT_EQ(recall(c, "two()", -1), "one()");
    EXPECT_EQ(recall(c, "one()", -1), "one()") << "there is none before the first";
    EXPECT_EQ(recall(c, "one()", 1), "two()");
    EXPECT_EQ(recall(c, "two()", 1), "thr") << "what was being typed";
    EXPECT_EQ(recall(c, "thr", 1), "thr");
}

TEST(Console, AWordIsCompletedAsFarAsAllAgree) {
    Console c;
    EXPECT_EQ(completed(c, "map.me"), "map.me") << "nobody knows any names";
    c.completions = [](const std::string& word) {
        std::vector<std::string> all;
        for (const char* name : {"map.mean", "map.median", "map.size"})
            if (std::string(name).starts_with(word)) all.push_back(name);
        return all;
    };
    EXPECT_EQ(completed(c, "x = map.s"), "x = map.size");
    EXPECT_EQ(completed(c, "print(map.me"), "print(map.me");
    EXPECT_EQ(completed(c, "map.mean"), "map.mean");
    EXPECT_EQ(completed(c, "nothing"), "nothing");
    EXPECT_EQ(completed(c, "x = "), "x = ");
}

}  // namespace
}  // namespace sward
