// The lists of what ./check leaves to --long and ./check --quick leaves out name what is there: a suite, a test
// (Suite.Test), a script or a check of the form.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "sources.h"
#include "support.h"

namespace {
namespace fs = std::filesystem;
using namespace sward::test;

// "Suite" and "Suite.Test" of each test that these lines begin.
void addTests(const Lines& lines, std::set<std::string>& names) {
    static const std::regex begins(R"(^(?:TYPED_)?TEST(?:_F|_P)?\((\w+), (\w+)\).*)");
    std::smatch found;
    for (const std::string& line : lines) {
        if (!std::regex_match(line, found, begins)) continue;
        names.insert(found[1].str());
        names.insert(found[1].str() + "." + found[2].str());
    }
}

std::set<std::string> namesIn(const fs::path& root) {
    std::set<std::string> names{"form.clang-format"};
    for (const fs::path& file : sources(root, {"tests"})) addTests(linesOf(root / file), names);
    for (const auto& script : fs::directory_iterator(root / "tests/scripts"))
        if (script.path().extension() == ".lua") names.insert("script." + script.path().stem().string());
    return names;
}

Lines unknownOf(const Lines& list, const std::set<std::string>& names) {
    Lines unknown;
    for (const std::string& line : list)
        if (!line.empty() && line[0] != '#' && !names.contains(line)) unknown.push_back(line);
    return unknown;
}

TEST(SuiteLists, NameTestsThatAreThere) {
    const fs::path root = SWARD_SOURCE_DIR;
    const std::set<std::string> names = namesIn(root);
    ASSERT_GT(names.size(), 1000u) << "the tests were not found";
    for (const char* list : {"tests/slow_suites.txt", "tests/long_suites.txt"}) {
        const Lines unknown = unknownOf(linesOf(root / list), names);
        EXPECT_TRUE(unknown.empty()) << list << " names what is no test:" << joined(unknown);
    }
}

TEST(SuiteLists, ANameThatIsNoTestIsFound) {
    std::set<std::string> names;
    addTests({"TEST(Words, Rhyme) {", "TEST_F(Songs, AreSung) { sing(); }", "// TEST(Noise, IsNone)"}, names);
    EXPECT_EQ(unknownOf({"# all", "Words", "Words.Rhyme", "Songs.AreSung", "Songs.AreLong", "Noise"}, names),
              (Lines{"Songs.AreLong", "Noise"}));
}

}  // namespace
