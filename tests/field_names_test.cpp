// What is known of a field or component stands in its row: no source decides what to do by comparing a name with a
// text. And what is const stays so: casts that take const away are listed, with their reasons. Read off the sources.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>

#include "techniques.h"

namespace {
namespace fs = std::filesystem;
using sward::ComponentRow;
using sward::FieldRow;
using Names = std::set<std::string, std::less<>>;

struct Allowed {
    const char* file;
    const char* text;  // in the line
    const char* why;
};
constexpr Allowed kComparisons[] = {
    {"engine/project/project_json_read.cpp", "key == \"name\"", "the project's own name, which is no field"},
};
constexpr Allowed kCasts[] = {
    {"engine/gpu/gpu.cpp", "const_cast<void*>(user)", "GL hands back as const what it was given"},
    {"engine/maps/map.cpp", "const_cast<Tile&>(*slot)", "a tile that only this map holds, made non-const, is written"},
};

void addNames(std::span<const FieldRow> fields, Names& out) {
    for (const FieldRow& f : fields) {
        out.insert(f.name);
        if (f.list) addNames(f.list->fields, out);
    }
}
Names namesOfRows() {
    Names out;
    for (const ComponentRow& row : sward::tables().components) {
        out.insert(row.name);
        addNames(row.fields, out);
    }
    return out;
}

// Whether a text literal that stands at [open, close] in a line is compared with something.
bool isCompared(std::string_view line, size_t open, size_t close) {
    std::string_view before = line.substr(0, open), after = line.substr(close + 1);
    while (before.ends_with(' ')) before.remove_suffix(1);
    while (after.starts_with(' ')) after.remove_prefix(1);
    const bool equals =
        before.ends_with("==") || before.ends_with("!=") || after.starts_with("==") || after.starts_with("!=");
    const size_t call = before.rfind('(');
    const std::string_view callee = before.substr(0, call == std::string_view::npos ? 0 : call);
    return equals || callee.ends_with("starts_with") || callee.ends_with("ends_with") || callee.ends_with("compare") ||
           callee.ends_with("findComponent");
}

// The first name in the line that is compared, alone or as the tail of a path; empty if none is.
std::string comparedName(std::string_view line, const Names& names) {
    if (const size_t comment = line.find("//"); comment != std::string_view::npos) line = line.substr(0, comment);
    for (size_t open = line.find('"'); open != std::string_view::npos;) {
        const size_t close = line.find('"', open + 1);
        if (close == std::string_view::npos) break;
        const std::string_view text = line.substr(open + 1, close - open - 1);
        const std::string_view tail = text.substr(text.rfind('.') + 1);
        if (names.contains(tail) && isCompared(line, open, close)) return std::string(text);
        open = line.find('"', close + 1);
    }
    return {};
}

// Calls f with each line of the sources of engine and editor: file, number from 1, text.
template <class F>
void eachLine(F&& f) {
    const fs::path root = SWARD_SOURCE_DIR;
    for (const char* folder : {"engine", "editor"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const fs::path ext = entry.path().extension();
            if (ext != ".h" && ext != ".cpp") continue;
            std::ifstream in(entry.path());
            int number = 0;
            for (std::string line; std::getline(in, line);)
                f(entry.path().lexically_relative(root).generic_string(), ++number, line);
        }
}

bool isAllowed(std::span<const Allowed> list, const std::string& file, const std::string& line, size_t& used) {
    for (size_t i = 0; i < list.size(); ++i)
        if (file == list[i].file && line.find(list[i].text) != std::string::npos) {
            used |= size_t(1) << i;
            return true;
        }
    return false;
}

TEST(FieldNames, AreComparedWithNoTextToDecideWhatToDo) {
    const Names names = namesOfRows();
    ASSERT_GT(names.size(), 100u);
    size_t used = 0;
    eachLine([&](const std::string& file, int number, const std::string& line) {
        const std::string name = comparedName(line, names);
        if (!name.empty() && !isAllowed(kComparisons, file, line, used))
            ADD_FAILURE() << file << ":" << number << ": compares \"" << name << "\": say it in the field's row";
    });
    EXPECT_EQ(used, (size_t(1) << std::size(kComparisons)) - 1) << "an exception is listed that nothing needs";
}

TEST(FieldNames, ComparisonsOfEveryFormAreFound) {
    const Names names{"density", "Camera"};
    for (const char* line : {"if (std::string_view(row.name) == \"density\") x();", "a = name != \"density\";",
                             "if (\"density\" == name)", "if (map.ends_with(\".density\")) return map;",
                             "if (findComponent(rows, \"Camera\"))", "path.ends_with(\"lawn.GrassField.density\")"})
        EXPECT_FALSE(comparedName(line, names).empty()) << line;
    for (const char* line :
         {"map(\"density\", offsetof(Species, density), &kDensity, \"help\"),", "return path + \".density\";",
          "name == \"dense\"", "// name == \"density\"", "log(\"density\", a == b);"})
        EXPECT_TRUE(comparedName(line, names).empty()) << line;
}

TEST(Const, IsCastAwayOnlyWhereAReasonIsListed) {
    size_t used = 0;
    eachLine([&](const std::string& file, int number, const std::string& line) {
        for (const char* cast : {"const_cast<", "const_pointer_cast<"})
            if (line.find(cast) != std::string::npos && !isAllowed(kCasts, file, line, used))
                ADD_FAILURE() << file << ":" << number << ": casts const away";
    });
    EXPECT_EQ(used, (size_t(1) << std::size(kCasts)) - 1) << "an exception is listed that nothing needs";
}

}  // namespace
