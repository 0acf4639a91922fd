// What JSON may ask for of memory: apart from json_test.cpp, for it takes the sanitizers three seconds.
#include <gtest/gtest.h>

#include "core/json.h"

using namespace sward;

TEST(JsonMemory, WhatASmallFileAsksForIsLimited) {
    std::string text = "[";
    for (size_t i = 0; i < kMaxJsonValues; ++i) text += "0,";
    const Result<Json> j = parseJson(text + "0]", "f.json");
    ASSERT_FALSE(j);
    EXPECT_EQ(j.error().message, fmt::format("more than {} values", kMaxJsonValues));
    EXPECT_EQ(j.error().code, ExitCode::Unsound);
    EXPECT_EQ(j.error().line, 1);
}
