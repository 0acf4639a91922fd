// The text of formulas: found by their names, with what is said above them.
#include "formulas/case_source.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

const std::string kFile =
    "// About the file.\n\n// Twice.\n// Of x.\nFN real twice(real x) { return 2.0f * x; }\n\nstruct Pair {\n    real "
    "a;\n};\n// Long.\nFN real longer(real x,\n               real y) {\n    return x;\n}\nFN real twice(vec2 x) {\n   "
    " "
    "return x.x;\n}\n";

TEST(CaseSource, AFunctionComesWithItsCommentAndItsBody) {
    EXPECT_EQ(functionText(kFile, "longer"),
              "// Long.\nFN real longer(real x,\n               real y) {\n    return x;\n}\n");
}

TEST(CaseSource, OverloadsComeTogetherAndOthersNot) {
    EXPECT_EQ(functionText(kFile, "twice"),
              "// Twice.\n// Of x.\nFN real twice(real x) { return 2.0f * x; }\n\nFN real twice(vec2 x) {\n    return "
              "x.x;\n}\n");
    EXPECT_EQ(functionText(kFile, "twi"), "");
    EXPECT_EQ(functionText("", "twice"), "");
}

TEST(CaseSource, EveryCaseHasItsText) {
    for (const HardCase& h : hardCases()) {
        const auto text = caseText(h.curve);
        ASSERT_TRUE(text) << text.error().text();
        EXPECT_NE(text->find(" " + h.curve.function + "("), std::string::npos) << h.key;
    }
}

TEST(CaseSource, ThePrintedFormStandsBelowOurs) {
    for (const HardCase& h : hardCases()) {
        if (h.key != "B-8") continue;
        const auto text = caseText(h.curve);
        ASSERT_TRUE(text);
        EXPECT_LT(text->find("FN real lodRamp("), text->find("FN LodWeights lodWeightsPublished("));
    }
}

}  // namespace
}  // namespace sward
