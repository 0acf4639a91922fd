// Shaders include what they use by name, and what no shader uses on the GPU says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support.h"

namespace sward::test {
namespace {
namespace fs = std::filesystem;

const fs::path kShaders = fs::path(SWARD_SOURCE_DIR) / "shaders";

std::vector<std::string> all(const std::string& text, const char* pattern) {
    const std::regex expression(pattern, std::regex::ECMAScript | std::regex::multiline);
    std::vector<std::string> out;
    for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) out.push_back((*it)[1]);
    return out;
}
std::vector<std::string> includesOf(const std::string& text) { return all(text, R"x(^#include "([^"]+)")x"); }
std::string codeOf(const std::string& text) {
    return std::regex_replace(text, std::regex(R"(//[^\n]*|#include[^\n]*)"), "");
}

// What a file gives to others: functions, structs, constants, macros, and variables of blocks, samplers and stages.
std::set<std::string> givenBy(const std::string& text) {
    std::set<std::string> out;
    const std::string code = codeOf(text);
    for (const char* pattern :
         {R"(^(?:FN )?\w+ (\w+)\([^;{]*\)\s*\{)", R"(^struct (?:STD140 )?(\w+))", R"(^#define (\w+))",
          R"((?:^const \w+|,) (\w+) =)", R"(\{ \w+ (\w+)(?:\[\w*\])?; \})", R"( uniform \w+ (\w+)(?:\[\w*\])?;)",
          R"(^(?:layout\([^)]*\) )?(?:flat |centroid )*(?:in|out) \w+ (\w+);)"})
        for (const std::string& name : all(code, pattern)) out.insert(name);
    return out;
}
std::set<std::string> wordsOf(const std::string& text) {
    const std::vector<std::string> words = all(codeOf(text), R"((\b[A-Za-z_]\w*))");
    return {words.begin(), words.end()};
}

// Includes of which a text uses no name.
std::vector<std::string> idleIncludes(const std::string& text) {
    const std::set<std::string> words = wordsOf(text);
    std::vector<std::string> out;
    for (const std::string& path : includesOf(text)) {
        const std::set<std::string> given = givenBy(readText(kShaders / path));
        if (std::none_of(given.begin(), given.end(), [&](const std::string& name) { return words.contains(name); }))
            out.push_back(path);
    }
    return out;
}

std::vector<std::string> shaderFiles() {
    std::vector<std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(kShaders))
        if (entry.is_regular_file()) out.push_back(fs::relative(entry.path(), kShaders).string());
    return out;
}
bool isEntry(const std::string& path) {
    static const std::regex stage(R"(.*\.(vert|frag|comp|tesc|tese)\.glsl)");
    return std::regex_match(path, stage);
}

void reach(const std::string& path, std::set<std::string>& seen) {
    if (!seen.insert(path).second) return;
    for (const std::string& other : includesOf(readText(kShaders / path))) reach(other, seen);
}

TEST(Shaders, ShadersUseANameOfEachFileThatTheyInclude) {
    size_t checked = 0;
    for (const std::string& path : shaderFiles()) {
        if (path == "numerics/all.h" || path.starts_with("formulas/")) continue;  // both want every formula
        ++checked;
        for (const std::string& idle : idleIncludes(readText(kShaders / path)))
            ADD_FAILURE() << path << " uses nothing of " << idle;
    }
    EXPECT_GT(checked, 90u);
    EXPECT_EQ(idleIncludes("#include \"lib/mirror.glsl\"\n#include \"numerics/hash.h\"\n"
                           "void main() { cutAtWater(0.0); }  // hash3\n"),
              std::vector<std::string>{"numerics/hash.h"});
}

TEST(Shaders, LibrariesAreUsedAndFormulasThatNoShaderDrawsWithSaySo) {
    std::set<std::string> drawn;
    for (const std::string& path : shaderFiles())
        if (isEntry(path) && !path.starts_with("formulas/")) reach(path, drawn);
    for (const std::string& path : shaderFiles()) {
        if (path.starts_with("lib/") || path.starts_with("shared/")) {
            EXPECT_TRUE(drawn.contains(path)) << path << " is included by no shader";
        }
        if (!path.starts_with("numerics/") || path == "numerics/all.h") continue;
        const bool says =
            readText(kShaders / path).find("On the GPU only the formula suite runs this") != std::string::npos;
        EXPECT_NE(drawn.contains(path), says) << path;
    }
}

}  // namespace
}  // namespace sward::test
