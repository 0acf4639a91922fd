// Each shader file brings what it needs: it compiles after its own includes and nothing else, in whatever order.
#include <epoxy/gl.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "frame/plan.h"
#include "gpu/program.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {
namespace {
namespace fs = std::filesystem;

// Every constant that some program is compiled with: features, and what its variants say.
std::string everyConstant() {
    const FeatureSet all = ~FeatureSet{};
    std::string out = featureConstants(all);
    std::set<std::string> names;
    const auto add = [&](const std::string& lines) {
        static const std::regex line(R"((const \w+ (\w+) = [^\n]*\n))");
        for (std::sregex_iterator it(lines.begin(), lines.end(), line), end; it != end; ++it)
            if (names.insert((*it)[2]).second) out += (*it)[1];
    };
    for (const EffectRow& e : tables().effects)
        for (const Pass& pass : e.passes)
            for (const ProgramRow& p : pass.programs)
                if (p.variants) add(p.variants().front());
    return out;
}

struct Stage {
    const char* suffix;
    GLenum type;
};
constexpr Stage kStages[] = {{".vert.glsl", GL_VERTEX_SHADER},
                             {".frag.glsl", GL_FRAGMENT_SHADER},
                             {".comp.glsl", GL_COMPUTE_SHADER},
                             {".tesc.glsl", GL_TESS_CONTROL_SHADER},
                             {".tese.glsl", GL_TESS_EVALUATION_SHADER}};

// The compiler's log; empty: it compiles.
std::string compile(GLenum type, const std::string& text) {
    const GLuint shader = glCreateShader(type);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    glDeleteShader(shader);
    return ok ? "" : "does not compile: " + log.substr(0, static_cast<size_t>(length));
}

// A file that is no entry point, with an empty main: some stage must take it.
std::string compileAlone(const ShaderText& text) {
    std::string log;
    for (const auto& [type, rest] : {std::pair{GL_FRAGMENT_SHADER, ""}, std::pair{GL_VERTEX_SHADER, ""},
                                     std::pair{GL_COMPUTE_SHADER, "layout(local_size_x = 1) in;\n"}}) {
        const std::string failed = compile(type, text.text + "\n" + rest + "void main() {}\n");
        if (failed.empty()) return "";
        log += failed;
    }
    return namedLog(log, text.files);
}

std::string compileFile(const fs::path& folder, const std::string& path, const std::string& constants) {
    const auto text = loadShaderText(folder, path, constants);
    if (!text) return text.error().text();
    for (const Stage& stage : kStages)
        if (path.ends_with(stage.suffix)) return namedLog(compile(stage.type, text->text), text->files);
    return compileAlone(*text);
}

void expectAllCompile(const fs::path& folder) {
    const std::string constants = everyConstant();
    size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string path = fs::relative(entry.path(), folder).string();
        if (!entry.is_regular_file() || path.starts_with("formulas/")) continue;  // those are made whole by their rows
        ++files;
        EXPECT_EQ(compileFile(folder, path, constants), "") << path;
    }
    EXPECT_GT(files, 90u);
}

// The same lines, each run of includes from the last to the first.
std::string turned(const std::string& text) {
    std::istringstream in(text);
    std::string out, line;
    std::vector<std::string> run;
    const auto flush = [&] {
        for (auto it = run.rbegin(); it != run.rend(); ++it) out += *it + "\n";
        run.clear();
    };
    while (std::getline(in, line)) {
        if (line.starts_with("#include")) {
            run.push_back(line);
            continue;
        }
        flush();
        out += line + "\n";
    }
    flush();
    return out;
}

TEST(Shaders, EveryShaderFileCompilesAfterItsOwnIncludesAlone) {
    NoGlErrors errors;
    gpu();
    expectAllCompile(shaderFolder());
}

TEST(Shaders, TheOrderOfIncludesDoesNotMatter) {
    NoGlErrors errors;
    gpu();
    TempDir dir;
    fs::copy(shaderFolder(), dir.path / "shaders", fs::copy_options::recursive);
    for (const auto& entry : fs::recursive_directory_iterator(dir.path / "shaders"))
        if (entry.is_regular_file()) writeText(entry.path(), turned(readText(entry.path())));
    expectAllCompile(dir.path / "shaders");
}

TEST(Shaders, AFileThatLacksAnIncludeDoesNotCompile) {
    gpu();
    TempDir dir;
    fs::copy(shaderFolder(), dir.path / "shaders", fs::copy_options::recursive);
    const fs::path lib = dir.path / "shaders/lib/transparency.glsl";
    writeText(lib, std::regex_replace(readText(lib), std::regex("#include[^\n]*\n"), ""));
    EXPECT_NE(compileFile(dir.path / "shaders", "lib/transparency.glsl", everyConstant()), "");
}

}  // namespace
}  // namespace sward::test
