// Sources that are compiled as one (CMakeLists.txt: compile_together) mean what they mean alone. A function of an
// anonymous namespace hides those of its name in the namespace around it from all sources behind it in the unit,
// without a word of the compiler where the arguments fit.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "sources.h"
#include "support.h"

namespace {
namespace fs = std::filesystem;
using namespace sward::test;

using Names = std::set<std::string>;

// What a line that begins a function at the left margin names; empty if it is none.
std::string functionOn(const std::string& line) {
    static const std::regex begins(R"(^(?:[\w:<>,*&\[\]]+\s+)+[&*]*(\w+)\(.*)");
    std::smatch found;
    if (line.find('(') == std::string::npos || line.front() == ' ' || line.front() == '#' || line.front() == '/')
        return "";
    return std::regex_match(line, found, begins) ? found[1].str() : "";
}

Names declaredIn(const Lines& header) {
    Names names;
    for (const std::string& line : header) names.insert(functionOn(line));
    names.erase("");
    return names;
}

const Names& namesOfHeader(const fs::path& header) {
    static std::map<fs::path, Names> known;
    const auto [at, isNew] = known.try_emplace(header);
    if (isNew && fs::exists(header)) at->second = declaredIn(linesOf(header));
    return at->second;
}

Names hiddenBy(const Lines& source) {
    Names names;
    bool anonymous = false;
    for (const std::string& line : source) {
        if (line == "namespace {") anonymous = true;
        if (line == "}  // namespace") anonymous = false;
        if (anonymous) names.insert(functionOn(line));
    }
    names.erase("");
    return names;
}

struct Source {
    fs::path file;
    std::string text;
    Names hides;
    Names fromHeaders;  // declared in those that it includes itself
};

Source sourceOf(const fs::path& file, const fs::path& root) {
    static const std::regex include(R"re(^#include "(.+\.h)")re");
    const Lines lines = linesOf(file);
    Source s{file.lexically_relative(root), joined(lines), hiddenBy(lines), {}};
    std::smatch found;
    for (const std::string& line : lines) {
        if (!std::regex_search(line, found, include)) continue;
        for (const char* folder : {"engine", "editor", "tests", "."}) {
            const Names& names = namesOfHeader(root / folder / found[1].str());
            s.fromHeaders.insert(names.begin(), names.end());
        }
    }
    return s;
}

bool calls(const std::string& text, const std::string& name) {
    return std::regex_search(text, std::regex("[^\\w.>:]" + name + "\\("));
}

// What a source hides from those behind it.
Lines faultsOf(const std::vector<Source>& unit) {
    Lines faults;
    for (size_t i = 0; i < unit.size(); ++i)
        for (size_t k = i + 1; k < unit.size(); ++k)
            for (const std::string& name : unit[i].hides)
                if (unit[k].fromHeaders.contains(name) && !unit[k].hides.contains(name) && calls(unit[k].text, name))
                    faults.push_back(unit[i].file.string() + ": its " + name + "() hides the one that " +
                                     unit[k].file.string() + " calls: give it another name");
    return faults;
}

TEST(Units, NoHelperHidesAFunctionThatALaterSourceOfItsUnitCalls) {
    static const std::regex include(R"re(^#include "(/.+\.cpp)")re");
    const fs::path root = SWARD_SOURCE_DIR;
    Lines faults;
    size_t units = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SWARD_BINARY_DIR) / "CMakeFiles")) {
        if (!entry.path().filename().string().starts_with("unity_") || entry.path().extension() != ".cxx") continue;
        std::vector<Source> unit;
        std::smatch found;
        for (const std::string& line : linesOf(entry.path()))
            if (std::regex_search(line, found, include)) unit.push_back(sourceOf(found[1].str(), root));
        const Lines here = faultsOf(unit);
        faults.insert(faults.end(), here.begin(), here.end());
        ++units;
    }
    if (units == 0) GTEST_SKIP() << "this build compiles a source at a time";
    EXPECT_TRUE(faults.empty()) << joined(faults);
}

TEST(Units, AHiddenFunctionIsFoundOnlyWhereItIsCalled) {
    const auto source = [](const char* file, const Lines& lines, Names fromHeaders) {
        return Source{file, joined(lines), hiddenBy(lines), std::move(fromHeaders)};
    };
    const Source hiding =
        source("a.cpp", {"namespace {", "double brightness(const Image& i) {", "}  // namespace"}, {});
    EXPECT_EQ(hiding.hides, Names{"brightness"});
    EXPECT_EQ(
        declaredIn({"inline double brightness(const Image& image) {", "    return sum(image);", "struct Image {"}),
        Names{"brightness"});
    const Source caller = source("b.cpp", {"    return brightness(image);"}, {"brightness"}),
                 stranger = source("c.cpp", {"    return brightness(image);"}, {}),
                 member = source("d.cpp", {"    return image.brightness();"}, {"brightness"}),
                 own = source("e.cpp", {"namespace {", "int brightness(int x) {", "    return brightness(x);"},
                              {"brightness"});
    EXPECT_EQ(faultsOf({hiding, caller}).size(), 1u);
    EXPECT_TRUE(faultsOf({caller, hiding}).empty()) << "it was compiled before";
    for (const Source& other : {stranger, member, own}) EXPECT_TRUE(faultsOf({hiding, other}).empty()) << other.file;
}

}  // namespace
