// Numbers as text, and back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "ui/widgets.h"

namespace sward::ui {
namespace {

TEST(NumberText, IsTheShortestThatGivesTheSameNumber) {
    EXPECT_EQ(numberText(0.5), "0.5");
    EXPECT_EQ(numberText(12), "12");
    EXPECT_EQ(numberText(static_cast<double>(0.1f)), "0.1") << "as a float";
    EXPECT_EQ(numberText(0.1, false, true), "0.1");
    EXPECT_EQ(numberText(7, true), "7");
    EXPECT_EQ(numberText(std::numeric_limits<double>::infinity()), "inf");
    EXPECT_EQ(numberText(-0.0), "0");
    EXPECT_EQ(numberText(-0.0, false, true), "0");
    for (const double v : {1e-7, 123456.789, 1.0 / 3})
        EXPECT_EQ(std::stod(numberText(v, false, true)), v) << numberText(v, false, true);
}

TEST(ParseNumber, TakesWhatLiesInTheHardRangeAndSaysWhatDoesNot) {
    NumberSpec spec;
    spec.hardMin = 0.1, spec.hardMax = 500;
    std::string error;
    EXPECT_EQ(parseNumber("2.5", spec, error), 2.5);
    EXPECT_EQ(error, "");
    for (const char* text : {"", "two", "2.5x", "0", "501", "nan", "inf", "-1"}) {
        error.clear();
        EXPECT_FALSE(parseNumber(text, spec, error)) << text;
        EXPECT_NE(error, "") << text;
    }
    spec.allowInf = true, spec.hardMax = std::numeric_limits<double>::infinity();
    EXPECT_EQ(parseNumber("inf", spec, error), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace sward::ui
