// The house's order, read from the #includes: what is low knows nothing of what is high, and domains nothing of each
// other (docs/architecture.md). With it what style asks of every file and can be read off its text.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sources.h"
#include "support.h"

namespace {
namespace fs = std::filesystem;
using namespace sward::test;

// From low to high; folders of one row are neighbours that never include each other.
const std::vector<std::vector<std::string>> kLayers = {
    {"engine/core"},
    {"engine/ecs"},
    {"engine/gpu"},
    {"engine/maps"},
    {"engine/mesh"},
    {"engine/scene"},
    {"engine/world"},
    {"engine/project"},
    {"engine/frame"},
    {"engine/terrain", "engine/grass", "engine/objects", "engine/forest", "engine/sky", "engine/water", "engine/post"},
    {"engine/reference"},
    {"engine/exchange"},
    {"engine/metrics"},
    {"engine/cost"},
    {"engine/formulas"},
    {"engine/."},  // techniques.cpp, the table of contents
    {"editor"},
};
constexpr size_t kMaxFileLines = 600;
constexpr size_t kMaxFunctionLines = 80;

struct Place {
    int layer = -1;      // index into kLayers; -1: none of ours, or a folder without a place
    std::string folder;  // as in kLayers
};
Place placeOf(const fs::path& relative) {
    const auto part = relative.begin();
    std::string folder = part->string();
    if (folder == "engine") folder += "/" + (std::next(part, 2) == relative.end() ? "." : std::next(part)->string());
    for (size_t i = 0; i < kLayers.size(); ++i)
        if (std::find(kLayers[i].begin(), kLayers[i].end(), folder) != kLayers[i].end())
            return {static_cast<int>(i), folder};
    return {-1, folder};
}

// What an #include line names, without quotes or brackets; empty if the line is none.
std::string includedBy(const std::string& line) {
    const size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') return "";
    const size_t word = line.find("include", hash);
    const size_t open = line.find_first_of("\"<", hash);
    if (word == std::string::npos || open == std::string::npos || word > open) return "";
    const size_t close = line.find_first_of("\">", open + 1);
    return close == std::string::npos ? "" : line.substr(open + 1, close - open - 1);
}

// The file of ours that `name` means in `from`, relative to root; empty if none.
fs::path resolve(const fs::path& root, const fs::path& from, const std::string& name) {
    for (const fs::path& base : {(root / from).parent_path(), root, root / "engine", root / "editor"})
        if (fs::is_regular_file(base / name))
            return fs::weakly_canonical(base / name).lexically_relative(fs::weakly_canonical(root));
    return {};
}

// Why `file` must not include `name`; empty if it may.
std::string refusal(const fs::path& root, const fs::path& file, const std::string& name) {
    const Place mine = placeOf(file);
    if (mine.folder != "editor" && name.find("imgui") != std::string::npos) return "the engine knows no Dear ImGui";
    const fs::path target = resolve(root, file, name);
    if (target.empty() || (*target.begin() != "engine" && *target.begin() != "editor")) return "";
    const Place other = placeOf(target);
    if (other.layer < 0) return other.folder + " has no place in the order of layers";
    if (other.layer > mine.layer) return other.folder + " is above " + mine.folder;
    if (other.layer == mine.layer && other.folder != mine.folder)
        return mine.folder + " and " + other.folder + " are neighbours";
    return "";
}

Lines layerBreaches(const fs::path& root) {
    Lines out;
    for (const fs::path& file : sources(root, {"engine", "editor"})) {
        if (placeOf(file).layer < 0)
            out.push_back(file.string() + ": " + placeOf(file).folder + " has no place in the order of layers");
        const Lines lines = linesOf(root / file);
        for (size_t i = 0; i < lines.size(); ++i)
            if (const std::string name = includedBy(lines[i]); !name.empty())
                if (const std::string why = refusal(root, file, name); !why.empty())
                    out.push_back(fmt::format("{}:{}: includes {}: {}", file.string(), i + 1, name, why));
    }
    return out;
}

// A header opens with what it is for, and has its guard; or says in its opening comment why it has "no guard".
Lines headerBreaches(const fs::path& root) {
    Lines out;
    for (const fs::path& file : sources(root, {"engine", "editor", "tests", "bench"})) {
        if (file.extension() != ".h") continue;
        const Lines lines = linesOf(root / file);
        bool guarded = std::find(lines.begin(), lines.end(), "#pragma once") != lines.end();
        for (size_t i = 0; i < lines.size() && lines[i].starts_with("//"); ++i)
            guarded |= lines[i].find("no guard") != std::string::npos;
        const bool says =
            !lines.empty() && lines[lines[0] == "#pragma once" && lines.size() > 1 ? 1 : 0].starts_with("// ");
        if (!guarded || !says)
            out.push_back(file.string() + ": a header opens with a line that says what it is, and #pragma once");
    }
    return out;
}

// True if a line that ends in "{" opens a function rather than a type, a namespace or a table.
bool opensFunction(const std::string& line) {
    if (!line.ends_with("{") || line.find('(') == std::string::npos) return false;
    const std::string text = line.substr(line.find_first_not_of(' '));
    for (const char* word : {"namespace", "struct ", "class ", "enum ", "union ", "extern ", "}"})
        if (text.starts_with(word)) return false;
    return !text.ends_with("= {");
}

// Functions at namespace or class level that are too long: clang-format puts their closing brace at their own indent.
Lines lengthBreaches(const fs::path& root) {
    Lines out;
    for (const fs::path& file : sources(root, {"engine", "editor", "tests", "bench"})) {
        const Lines lines = linesOf(root / file);
        if (lines.size() > kMaxFileLines)
            out.push_back(fmt::format("{}: {} lines; over {}, a file lacks a second name", file.string(), lines.size(),
                                      kMaxFileLines));
        for (size_t i = 0; i < lines.size(); ++i) {
            const size_t indent = lines[i].find_first_not_of(' ');
            if (indent > 4 || indent == std::string::npos || !opensFunction(lines[i])) continue;
            const size_t opened = lines[i][indent] == ':' ? indent - 4 : indent;  // a list of members stands deeper
            const std::string closing = std::string(opened, ' ') + "}";
            size_t end = i + 1;
            while (end < lines.size() && !lines[end].starts_with(closing)) ++end;
            if (end - i + 1 > kMaxFunctionLines)
                out.push_back(fmt::format("{}:{}: a function of {} lines; over {}, it lacks a second name",
                                          file.string(), i + 1, end - i + 1, kMaxFunctionLines));
            i = indent == 0 ? end : i;
        }
    }
    return out;
}

const fs::path kRoot = SWARD_SOURCE_DIR;

TEST(Layers, NoFileIncludesWhatIsAboveOrBesideIt) {
    const Lines found = layerBreaches(kRoot);
    EXPECT_TRUE(found.empty()) << joined(found);
    EXPECT_GT(sources(kRoot, {"engine", "editor"}).size(), 20u) << "the sources were not found";
}
TEST(Layers, EveryHeaderSaysWhatItIs) {
    const Lines found = headerBreaches(kRoot);
    EXPECT_TRUE(found.empty()) << joined(found);
}
TEST(Layers, NoFileOrFunctionIsLongerThanItsNameCanCarry) {
    const Lines found = lengthBreaches(kRoot);
    EXPECT_TRUE(found.empty()) << joined(found);
}

// Sources under `folder` of root that have no test of their own path: tests/<path>_test.cpp or _gl_test.cpp, where the
// engine's folders stand directly under tests/.
Lines withoutTest(const fs::path& root, const char* folder, size_t* all) {
    Lines out;
    for (const fs::path& file : sources(root, {folder})) {
        if (file.extension() != ".cpp") continue;
        ++*all;
        fs::path stem = root / "tests" / (*file.begin() == "engine" ? file.lexically_relative("engine") : file);
        stem.replace_extension();
        if (!fs::exists(stem.string() + "_test.cpp") && !fs::exists(stem.string() + "_gl_test.cpp"))
            out.push_back(file.string());
    }
    return out;
}
// What is held; raised as it is reached, never lowered.
constexpr double kTestedEngine = 0.6, kTestedEditor = 0.6;

void expectTested(const char* folder, double wanted) {
    size_t all = 0;
    const Lines without = withoutTest(kRoot, folder, &all);
    ASSERT_GT(all, 50u) << "the sources were not found";
    EXPECT_GE(1 - double(without.size()) / double(all), wanted)
        << without.size() << " of " << all << " sources have no test of their own name:" << joined(without);
}
TEST(Layers, TestsMirrorTheSources) {
    expectTested("engine", kTestedEngine);
    expectTested("editor", kTestedEditor);
}

// --- the checks themselves

TEST(LayersPlanted, ASourceWithoutATestOfItsNameIsFound) {
    const TempDir dir;
    for (const char* file : {"engine/core/a.cpp", "engine/core/b.cpp", "engine/core/c.cpp", "engine/core/c.h",
                             "editor/ui/a.cpp", "editor/ui/b.cpp", "tests/core/a_test.cpp", "tests/core/b_gl_test.cpp",
                             "tests/editor/ui/a_test.cpp", "tests/ui/b_test.cpp"})
        writeText(dir / file, "// A file.\n");
    size_t all = 0;
    EXPECT_EQ(withoutTest(dir.path, "engine", &all), Lines{"engine/core/c.cpp"});
    EXPECT_EQ(withoutTest(dir.path, "editor", &all), Lines{"editor/ui/b.cpp"});
    EXPECT_EQ(all, 5u);
}

TEST(LayersPlanted, EveryKindOfBreachIsFoundWithFileAndLine) {
    const TempDir dir;
    const auto plant = [&](const char* file, const char* text) { writeText(dir / file, text); };
    for (const char* header : {"core/low.h", "scene/scene.h", "grass/grass.h", "sky/sky.h", "techniques.h"})
        plant((std::string("engine/") + header).c_str(), "// Is here.\n#pragma once\n");
    plant("editor/panel.h", "// A panel.\n#pragma once\n#include <imgui.h>\n#include \"techniques.h\"\n");  // may
    plant("engine/grass/fine.cpp",
          "#include \"grass/grass.h\"\n#include \"grass.h\"\n#include \"scene/scene.h\"\n#include <vector>\n");
    EXPECT_EQ(layerBreaches(dir.path), Lines{});

    plant("engine/core/up.cpp", "\n#include \"scene/scene.h\"\n");
    plant("engine/grass/beside.cpp", "#include \"../sky/sky.h\"\n");
    plant("engine/scene/table.cpp", "#include \"engine/techniques.h\"\n");
    plant("engine/sky/window.cpp", "  #  include \"editor/panel.h\"\n");
    plant("engine/ecs/gui.cpp", "#include <imgui/imgui.h>\n");
    plant("engine/magic/spell.cpp", "// no layer\n");
    EXPECT_EQ(layerBreaches(dir.path),
              (Lines{"engine/core/up.cpp:2: includes scene/scene.h: engine/scene is above engine/core",
                     "engine/ecs/gui.cpp:1: includes imgui/imgui.h: the engine knows no Dear ImGui",
                     "engine/grass/beside.cpp:1: includes ../sky/sky.h: engine/grass and engine/sky are neighbours",
                     "engine/magic/spell.cpp: engine/magic has no place in the order of layers",
                     "engine/scene/table.cpp:1: includes engine/techniques.h: engine/. is above engine/scene",
                     "engine/sky/window.cpp:1: includes editor/panel.h: editor is above engine/sky"}));
}

TEST(LayersPlanted, MuteHeadersAndLongFunctionsAreFound) {
    const TempDir dir;
    writeText(dir / "engine/core/mute.h", "#include <vector>\n#pragma once\n");
    writeText(dir / "engine/core/bare.h", "// No guard.\n");
    writeText(dir / "engine/core/fine.h", "#pragma once\n// Says it.\n");
    EXPECT_EQ(headerBreaches(dir.path).size(), 2u);

    const auto function = [](size_t lines) {
        std::string text = "void f(int a) {\n";
        for (size_t i = 2; i < lines; ++i) text += "    ++a;\n";
        return text + "}\n";
    };
    writeText(dir / "engine/core/long.cpp", function(80) + function(81));
    writeText(dir / "engine/core/longer.cpp", std::string(601, '\n'));
    const Lines found = lengthBreaches(dir.path);
    ASSERT_EQ(found.size(), 2u) << joined(found);
    EXPECT_TRUE(found[0].starts_with("engine/core/long.cpp:81: a function of 81 lines")) << found[0];
    EXPECT_TRUE(found[1].starts_with("engine/core/longer.cpp: 601 lines")) << found[1];
}

}  // namespace
