// Every shader that a scene may compile passes the reference compiler of the Khronos group, whose rules drivers are
// judged by: one driver's leniency is another's error. Skipped where glslangValidator is not installed.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "frame/draw_context.h"
#include "frame/plan.h"
#include "gpu/program.h"
#include "scene/features.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {
namespace {

namespace fs = std::filesystem;

struct Command {
    int code;
    std::string said;
};
Command runCommand(const std::string& command) {
    Command done{-1, {}};
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return done;
    char part[4096];
    while (const size_t n = fread(part, 1, sizeof part, pipe)) done.said.append(part, n);
    done.code = pclose(pipe);
    return done;
}
bool hasCompiler() { return runCommand("glslangValidator --version").code == 0; }

// All files of a folder in one process: most of the time of one is its start.
Command compiled(const fs::path& folder, const std::vector<fs::path>& files) {
    std::string names;
    for (const fs::path& file : files) names += " " + file.filename().string();
    return runCommand("cd " + folder.string() + " && glslangValidator" + names);
}

// The lines "const TYPE NAME = VALUE;" of those that a shader, with what it includes, names: the others would make the
// same shader over and over.
std::string namedOf(Programs& programs, const char* path, const std::string& constants) {
    std::string named;
    std::istringstream lines(constants);
    for (std::string line; std::getline(lines, line);) {
        const size_t end = line.find(" ="), begin = line.rfind(' ', end - 1) + 1;
        if (end == std::string::npos || programs.named({.name = path, .vertex = path}, line.substr(begin, end - begin)))
            named += line + "\n";
    }
    return named;
}

// Texts of all stages of all programs, each once, as files that end with the stage's name.
struct Texts {
    const fs::path folder;
    Programs programs = Programs();
    std::set<std::string> known = {};
    std::vector<fs::path> files = {};
    void add(const char* path, const char* stage, const std::string& constants) {
        if (!path) return;
        const auto text = loadShaderText(shaderFolder(), path, namedOf(programs, path, constants));
        ASSERT_TRUE(text) << text.error().text();
        if (!known.insert(stage + text->text).second) return;
        std::string name = path;
        std::replace(name.begin(), name.end(), '/', '-');
        files.push_back(folder / (std::to_string(files.size()) + "-" + name + "." + stage));
        writeText(files.back(), text->text);
    }
    void add(const ProgramRow& p, const FeatureSet& scene) {
        const ProgramSources s = sourcesOf(p);
        for (const std::string& variant : p.variants ? p.variants() : std::vector<std::string>{""}) {
            const std::string constants = featureConstants(scene) + variant;
            add(s.vertex, "vert", constants), add(s.fragment, "frag", constants), add(s.compute, "comp", constants);
            add(s.control, "tesc", constants), add(s.evaluation, "tese", constants);
        }
    }
};

TEST(ReferenceCompiler, TakesEveryShaderOfTheTableForEveryFeatureSet) {
    if (!hasCompiler()) GTEST_SKIP() << "there is no glslangValidator (Debian: glslang-tools)";
    const TempDir dir;
    Texts texts{dir.path};
    for (const EffectRow& e : tables().effects)
        for (const Pass& pass : e.passes)
            for (const ProgramRow& p : pass.programs)
                for (const FeatureSet& scene : {FeatureSet{}, ~FeatureSet{}}) texts.add(p, scene);
    std::printf("%zu shaders\n", texts.files.size());
    ASSERT_GT(texts.files.size(), 100u);
    const Command done = compiled(dir.path, texts.files);
    EXPECT_EQ(done.code, 0);
    std::istringstream lines(done.said);
    int shown = 0;
    for (std::string line; std::getline(lines, line) && shown < 20;)
        if (line.find("ERROR") != std::string::npos) ADD_FAILURE() << line, ++shown;
}

// What it must refuse: else the test above proves nothing.
TEST(ReferenceCompiler, RefusesWhatALenientDriverMayTake) {
    if (!hasCompiler()) GTEST_SKIP() << "there is no glslangValidator (Debian: glslang-tools)";
    const TempDir dir;
    writeText(dir / "a.frag", "#version 450 core\nout vec4 c;\nvoid main() { vec2 v = 1; c = v.xyxy; }\n");
    writeText(dir / "b.frag", "#version 450 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n");
    EXPECT_EQ(compiled(dir.path, {dir / "b.frag"}).code, 0);
    EXPECT_NE(compiled(dir.path, {dir / "a.frag", dir / "b.frag"}).code, 0);
}

}  // namespace
}  // namespace sward::test
