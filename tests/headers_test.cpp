// Headers as manuals: how many of the functions that they declare have a comment above, beside, or above their group.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sources.h"
#include "support.h"

namespace {
namespace fs = std::filesystem;
using namespace sward::test;

// What is held; raised as it is reached, never lowered.
constexpr double kEngineShare = 0.95, kEditorShare = 0.95;

size_t indentOf(const std::string& line) { return std::min(line.find_first_not_of(' '), line.size()); }
std::string trimmed(const std::string& line) { return line.substr(indentOf(line)); }
std::string withoutComment(const std::string& line) { return line.substr(0, line.find("//")); }

// A declaration: lines [first, last] of a header.
struct Declared {
    size_t first = 0, last = 0;
    std::string code;  // on one line, without comments
};
Declared declaredAt(const Lines& lines, size_t first) {
    Declared d{first, first, trimmed(withoutComment(lines[first]))};
    const auto ends = [](const std::string& code) {
        const size_t last = code.find_last_not_of(' ');
        return last == std::string::npos || std::string(";{}").find(code[last]) != std::string::npos;
    };
    while (!ends(d.code) && d.last + 1 < lines.size() && d.last < first + 12)
        d.code += " " + trimmed(withoutComment(lines[++d.last]));
    return d;
}

// True for a function that somebody calls by its name: no constructor, destructor, operator or override of one.
bool declaresFunction(const std::string& code) {
    if (code.find('\\') != std::string::npos) return false;  // of a macro
    for (const char* word :
         {"//", "#", "}", "{", "using ", "static_assert", "namespace", "typedef", "friend ", "struct ", "class ",
          "enum ", "union ", "public:", "private:", "protected:", "template ", "return "})
        if (code.starts_with(word)) return false;
    for (const char* part : {" override", "= default", "= delete", "operator", "std::function<", "~"})
        if (code.find(part) != std::string::npos) return false;
    const size_t open = code.find('(');
    if (open == std::string::npos) return false;
    std::string before = code.substr(0, open);
    if (before.starts_with("explicit ")) before = before.substr(9);
    const size_t space = before.find_last_of(" &*>");
    return before.find('=') == std::string::npos && space != std::string::npos && space + 1 < before.size();
}

// True if the declaration has a comment beside it, or above it or above the functions right above it.
bool hasComment(const Lines& lines, const Declared& d) {
    for (size_t i = d.first; i <= d.last; ++i)
        if (lines[i].find("//") != std::string::npos) return true;
    const size_t indent = indentOf(lines[d.first]);
    for (size_t i = d.first; i-- > 0;) {
        const std::string line = trimmed(lines[i]);
        if (indentOf(lines[i]) < indent || line.empty()) return false;
        if (indentOf(lines[i]) > indent) continue;  // of a body, or of a long declaration
        if (line.starts_with("//")) return true;
        const bool field = line.ends_with(";") && line.find('(') == std::string::npos;
        if (field) return false;
    }
    return false;
}

struct Count {
    size_t functions = 0;
    Lines without;  // "file:line: declaration"
};
// Adds the functions that a header declares at the level of namespaces or of types, private members apart.
void countIn(const fs::path& root, const fs::path& file, Count& count) {
    const Lines lines = linesOf(root / file);
    size_t hidden = std::string::npos;  // indent of the "private:" that is in force
    for (size_t i = 0; i < lines.size(); ++i) {
        const std::string text = trimmed(lines[i]);
        const size_t indent = indentOf(lines[i]);
        if (text.starts_with("private:") || text.starts_with("protected:")) hidden = indent;
        if (text.starts_with("public:") || (text.starts_with("}") && indent < hidden)) hidden = std::string::npos;
        if ((indent != 0 && indent != 4) || text.empty() || hidden != std::string::npos) continue;
        const Declared d = declaredAt(lines, i);
        if (!declaresFunction(d.code)) continue;
        ++count.functions;
        if (!hasComment(lines, d)) count.without.push_back(fmt::format("{}:{}: {}", file.string(), i + 1, d.code));
        i = d.last;
        if (d.code.ends_with("{"))  // its body declares nothing
            while (i + 1 < lines.size() && !lines[i].starts_with(std::string(indent, ' ') + "}")) ++i;
    }
}
Count countUnder(const fs::path& root, const char* folder) {
    Count count;
    for (const fs::path& file : sources(root, {folder}))
        if (file.extension() == ".h") countIn(root, file, count);
    return count;
}

void expectShare(const char* folder, double wanted) {
    const Count count = countUnder(SWARD_SOURCE_DIR, folder);
    ASSERT_GT(count.functions, 200u) << "the headers were not found";
    const double share = 1 - double(count.without.size()) / double(count.functions);
    EXPECT_GE(share, wanted) << folder << ": " << count.without.size() << " of " << count.functions
                             << " functions say nothing of what they do:" << joined(count.without);
}
TEST(Headers, OfTheEngineSayWhatTheirFunctionsDo) { expectShare("engine", kEngineShare); }
TEST(Headers, OfTheEditorSayWhatTheirFunctionsDo) { expectShare("editor", kEditorShare); }

// --- the count itself

TEST(HeadersPlanted, EachFunctionWithoutACommentIsFoundAndNothingElse) {
    const TempDir dir;
    writeText(dir / "engine/a.h", R"(// A header.
#pragma once
// Above.
int above(int x);

int bare(int x);
int beside();  // says it
int longOne(int aaaa,
            int bbbb);

// Of both.
int first();
int second();

struct Thing {
    int field = 0;  // not a function
    int made = above(3);
    void (*pointer)(int);
    Thing(int x);
    ~Thing();
    bool operator==(const Thing&) const = default;
    int bareMember() const;
    // Has a body.
    int body() {
        return call(3);
    }
    int afterBody() const { return 1; }

  private:
    int hidden();
};
template <class T>
T generic(T x) {
    int inside(int);
    return x;
}
)");
    const Count count = countUnder(dir.path, "engine");
    EXPECT_EQ(count.without, (Lines{"engine/a.h:6: int bare(int x);", "engine/a.h:8: int longOne(int aaaa, int bbbb);",
                                    "engine/a.h:22: int bareMember() const;", "engine/a.h:33: T generic(T x) {"}));
    EXPECT_EQ(count.functions, 10u);
}

}  // namespace
