// JSON as it is written: one form for equal values, the fewest digits.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "core/json.h"

namespace sward {
namespace {

Json parsed(const std::string& text) {
    Result<Json> j = parseJson(text, "f.json");
    EXPECT_TRUE(j) << (j ? "" : j.error().text());
    return j ? *j : Json();
}

TEST(JsonWrite, TheWriterHasOneForm) {
    Json j = Json::makeObject();
    j["z"] = Json(Json::Array{Json(1), Json(2.5), Json(-3), Json(4)});
    j["five"] = Json(Json::Array{Json(1), Json(2), Json(3), Json(4), Json(5)});
    j["words"].push(Json("a"));
    j["a"]["empty"] = Json::makeObject();
    j["a"]["none"] = Json::makeArray();
    j["a"]["far"] = Json(std::numeric_limits<float>::infinity());
    j["a"]["yes"] = Json(true);
    j["a"]["big"] = Json(uint64_t(18446744073709551615u));
    j["a"]["null"] = Json();
    EXPECT_EQ(writeJson(j), R"({
  "a": {
    "big": 18446744073709551615,
    "empty": {},
    "far": "inf",
    "none": [],
    "null": null,
    "yes": true
  },
  "five": [
    1,
    2,
    3,
    4,
    5
  ],
  "words": [
    "a"
  ],
  "z": [1, 2.5, -3, 4]
}
)");
}

TEST(JsonWrite, NumbersTakeTheFewestDigitsThatReadBackTheSame) {
    EXPECT_EQ(shortestText(0.1f), "0.1");
    EXPECT_EQ(shortestText(0.1), "0.1");
    EXPECT_EQ(shortestText(double(0.1f)), "0.10000000149011612");
    EXPECT_EQ(shortestText(100000.0f), "100000");
    EXPECT_EQ(shortestText(-0.0), "0");
    EXPECT_EQ(shortestText(1e30f), "1e30");
    EXPECT_EQ(shortestText(1.5e-9), "1.5e-9");
    EXPECT_EQ(shortestText(std::numeric_limits<double>::infinity()), "inf");
    EXPECT_EQ(shortestText(std::numeric_limits<float>::quiet_NaN()), "nan");
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i) {
        const uint32_t bits = random();
        float f;
        std::memcpy(&f, &bits, sizeof f);
        if (!std::isfinite(f)) continue;
        EXPECT_EQ(static_cast<float>(parsed(writeJson(Json(f))).number), f);
    }
}

TEST(JsonWrite, WhatIsWrittenReadsBackAndWritesTheSame) {
    const std::string text =
        writeJson(parsed("{\"b\": [0.1, 1e-300, 12345678901234567890, \"\\u0001\\t\"], \"a\": {\"k\": [[], {}]}}"));
    EXPECT_EQ(writeJson(parsed(text)), text);
}

}  // namespace
}  // namespace sward
