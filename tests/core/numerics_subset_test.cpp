// The lint of the common subset: what compiles silently on one side and breaks, or means something else, on the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

#include "tests/support.h"

namespace sward {
namespace {
namespace fs = std::filesystem;

const fs::path kRoot = SWARD_SOURCE_DIR;

std::string withoutComments(const std::string& text) {
    return std::regex_replace(std::regex_replace(text, std::regex(R"(/\*[^]*?\*/)"), ""), std::regex(R"(//[^\n]*)"),
                              "");
}

// Without the includes that a formula file has for GLSL alone.
std::string withoutIncludes(const std::string& text) {
    static const std::regex block(R"(\n#ifndef __cplusplus\n(#include "numerics/\w+\.h"\n)+#endif\n)");
    return std::regex_replace(text, block, "\n", std::regex_constants::format_first_only);
}

struct Rule {
    const char* name;
    std::regex pattern;
};

const std::vector<Rule>& rules() {
    static const std::vector<Rule> list = {
        {"swizzle", std::regex(R"([\w\])]\s*\.\s*([xyzw]{2,4}|[rgba]{2,4}|[stpq]{2,4})\b)")},
        {"array parameter", std::regex(R"(\bFN\b[^;{]*\([^)]*\[)")},
        {"array constructor", std::regex(R"(\breal\s*\[\s*\d*\s*\]\s*\()")},
        {"stray #", std::regex(R"((^|\n)[ \t]*#)")},
        {"type outside the subset", std::regex(R"(\b(float|double|size_t|unsigned|auto|std::\w+)\b)")},
        {"relies on NaN", std::regex(R"(\b(isnan|isinf|NAN|INFINITY)\b)")},
        {"name taken by GLSL or C++",
         std::regex(
             R"(\b(partition|sample|active|filter|input|output|common|half|flat|new|this|class|union|and|or|not)\b)")},
        {"default argument", std::regex(R"(\bFN\b[^;{]*\([^)]*=[^)]*\)\s*\{)")},
        {"not ASCII", std::regex("[^\\x00-\\x7F]")},
    };
    return list;
}

// A literal with f that float cannot hold exactly, such as 0.1f, has one value in float and another in double.
bool hasInexactLiteral(const std::string& code) {
    static const std::regex literal(R"((?:\d+\.\d*|\.\d+|\d+(?=e))(?:e[+-]?\d+)?(?=f\b))");
    for (std::sregex_iterator it(code.begin(), code.end(), literal), end; it != end; ++it) {
        const double value = std::strtod(it->str().c_str(), nullptr);
        if (double(float(value)) != value) return true;
    }
    return false;
}

std::vector<std::string> breaches(const std::string& text) {
    const std::string code = withoutComments(text);
    std::vector<std::string> out;
    for (const Rule& rule : rules())
        if (std::regex_search(rule.name == std::string("not ASCII") ? text : code, rule.pattern))
            out.push_back(rule.name);
    if (hasInexactLiteral(code)) out.push_back("inexact literal");
    return out;
}

std::vector<std::string> functionsOf(const std::string& text) {
    static const std::regex function(R"(\bFN\s+\w+\s+(\w+)\s*\()");
    const std::string code = withoutComments(text);
    std::vector<std::string> names;
    for (std::sregex_iterator it(code.begin(), code.end(), function), end; it != end; ++it) names.push_back((*it)[1]);
    return names;
}

// How often each word stands in these texts; a definition counts as well.
std::map<std::string, int> wordsIn(const std::vector<std::string>& texts) {
    static const std::regex word(R"(\b(\w+)\b)");
    std::map<std::string, int> count;
    for (const std::string& text : texts) {
        const std::string code = withoutComments(text);
        for (std::sregex_iterator it(code.begin(), code.end(), word), end; it != end; ++it) ++count[(*it)[1]];
    }
    return count;
}

std::vector<std::string> unused(const std::vector<std::string>& formulas, const std::vector<std::string>& others) {
    std::vector<std::string> texts = formulas;
    texts.insert(texts.end(), others.begin(), others.end());
    auto words = wordsIn(texts);
    std::vector<std::string> out;
    for (const std::string& text : formulas)
        for (const std::string& name : functionsOf(text))
            if (words[name] < 2) out.push_back(name);
    return out;
}

std::vector<fs::path> formulaFiles() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kRoot / "shaders/numerics"))
        if (const auto name = entry.path().filename(); name != "all.h" && name != "glsl.h")
            files.push_back(entry.path());
    return files;
}

std::vector<std::string> textsUnder(std::initializer_list<const char*> folders, const std::string& except) {
    std::vector<std::string> texts;
    for (const char* folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
            if (entry.is_regular_file() && entry.path().string().find(except) == std::string::npos)
                texts.push_back(test::readText(entry.path()));
    return texts;
}

TEST(NumericsSubset, EveryFormulaHeaderKeepsTheRules) {
    ASSERT_GT(formulaFiles().size(), 10u);
    for (const fs::path& file : formulaFiles())
        for (const std::string& breach : breaches(withoutIncludes(test::readText(file))))
            ADD_FAILURE() << file.filename() << ": " << breach;
}

TEST(NumericsSubset, EveryFormulaHeaderIsInAllOnce) {
    const std::string all = test::readText(kRoot / "shaders/numerics/all.h");
    for (const fs::path& file : formulaFiles()) {
        const std::string line = "#include \"numerics/" + file.filename().string() + "\"";
        const size_t at = all.find(line);
        EXPECT_NE(at, std::string::npos) << line;
        EXPECT_EQ(all.find(line, at + 1), std::string::npos) << line;
    }
}

TEST(NumericsSubset, EveryFormulaHasACallerOrARow) {
    std::vector<std::string> formulas;
    for (const fs::path& file : formulaFiles()) formulas.push_back(test::readText(file));
    for (const std::string& name : unused(formulas, textsUnder({"engine", "editor", "shaders"}, "/numerics/")))
        ADD_FAILURE() << name;
}

TEST(NumericsSubset, PlantedMistakesAreFound) {
    const std::pair<const char*, const char*> planted[] = {
        {"swizzle", "FN vec2 f(vec3 v) { return v.xz; }"},
        {"swizzle", "FN vec3 f(vec4 v) { return (v + v).rgb; }"},
        {"array parameter", "FN real f(real a[3]) { return a[0]; }"},
        {"array constructor", "FN real f() { real a[2] = real[2](1.0f, 2.0f); return a[0]; }"},
        {"stray #", "FN real f() { return 1.0f; }\n  #define X 1\n"},
        {"type outside the subset", "FN float f(real x) { return x; }"},
        {"relies on NaN", "FN bool f(real x) { return isnan(x); }"},
        {"name taken by GLSL or C++", "FN real f(real sample) { return sample; }"},
        {"default argument", "FN real f(real x = 1.0f) { return x; }"},
        {"not ASCII", "// \xC3\xA9\nFN real f(real x) { return x; }"},
        {"inexact literal", "FN real f(real x) { return x * 0.1f; }"},
        {"inexact literal", "FN real f(real x) { return x * 1e-3f; }"},
    };
    for (const auto& [name, text] : planted) {
        const auto found = breaches(text);
        EXPECT_NE(std::find(found.begin(), found.end(), name), found.end()) << name << ": " << text;
    }
    EXPECT_TRUE(
        breaches("FN real f(vec3 v) { return v.x + m.tip.y * 0.5f + real(0.1); }  // v.xz, 0.1f, float").empty());
}

TEST(NumericsSubset, FunctionsWithoutACallerAreFound) {
    const std::string text =
        "FN real used(real x) { return x; }\nFN real unusedOne(real x) { return used(x); } // unusedOne(1)";
    EXPECT_EQ(unused({text}, {}), std::vector<std::string>{"unusedOne"});
    EXPECT_TRUE(unused({text}, {"BODY(y[0] = unusedOne(x[0]);)"}).empty());
}

}  // namespace
}  // namespace sward
