#include <chrono>

#include "gpu/program.h"

#include "core/log.h"
#include "frame/draw_context.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {
namespace {

const char* kVertex = "void main() { gl_Position = vec4(VALUE); }\n";

struct Shaders {
    TempDir dir;
    ProgramSources sources{"test/program", "a.vert.glsl", "a.frag.glsl", nullptr};
    Shaders() {
        writeText(dir / "a.vert.glsl",
                  fmt::format("#include \"lib/value.glsl\"\n#include \"lib/value.glsl\"\n{}", kVertex));
        writeText(dir / "a.frag.glsl", "#include \"lib/value.glsl\"\nout vec4 c;\nvoid main() { c = vec4(VALUE); }\n");
        writeText(dir / "lib/value.glsl", "const float VALUE = 1.0;\n");
    }
    // A newer time, whatever the clock's resolution.
    void rewrite(const std::string& name, const std::string& text) {
        static int later = 0;
        writeText(dir / name, text);
        std::filesystem::last_write_time(dir / name,
                                         std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++later));
    }
};

TEST(Program, IncludesAreResolvedOnceAndCompile) {
    gpu();
    Shaders s;
    Programs programs(s.dir.path);
    const auto program = programs.get(s.sources, "");
    ASSERT_TRUE(program) << program.error().text();
    EXPECT_EQ(*programs.get(s.sources, ""), *program) << "compiled twice";
    EXPECT_EQ(programs.size(), 1u);
}

TEST(Program, ACompilersMessageNamesTheIncludedFileAndItsLine) {
    gpu();
    Shaders s;
    writeText(s.dir / "lib/value.glsl", "\nconst float VALUE = misspelt;\n");
    Programs programs(s.dir.path);
    const auto program = programs.get(s.sources, "");
    ASSERT_FALSE(program);
    EXPECT_NE(program.error().text().find("lib/value.glsl:2"), std::string::npos) << program.error().text();
}

// A linker names lines of any stage, so that no two files of a program have one number.
TEST(Program, LinesOfEachStageAreNumberedOnAfterTheOneBefore) {
    Shaders s;
    const auto vertex = loadShaderText(s.dir.path, "a.vert.glsl", "");
    ASSERT_TRUE(vertex);
    const auto fragment = loadShaderText(s.dir.path, "a.frag.glsl", "", vertex->files.size());
    ASSERT_TRUE(fragment);
    std::vector<std::string> files = vertex->files;
    files.insert(files.end(), fragment->files.begin(), fragment->files.end());
    ASSERT_EQ(files, (std::vector<std::string>{"a.vert.glsl", "lib/value.glsl", "a.frag.glsl", "lib/value.glsl"}));
    EXPECT_NE(fragment->text.find("#line 200001\n"), std::string::npos) << fragment->text;
    EXPECT_EQ(namedLog("Fragment info\n0(200003) : error C1068: array index out of bounds\n", files),
              "Fragment info\na.frag.glsl:3 : error C1068: array index out of bounds\n");
}

TEST(Program, AMissingIncludeNamesTheFileThatWantsIt) {
    gpu();
    Shaders s;
    writeText(s.dir / "a.frag.glsl", "\n#include \"lib/gone.glsl\"\n");
    Programs programs(s.dir.path);
    const auto program = programs.get(s.sources, "");
    ASSERT_FALSE(program);
    EXPECT_NE(program.error().text().find("gone.glsl"), std::string::npos);
    EXPECT_NE(program.error().text().find("a.frag.glsl:2"), std::string::npos) << program.error().text();
}

TEST(Program, SharedHeadersOfAnotherVersionAreSaidOnceAFolder) {
    TempDir dir;
    EXPECT_TRUE(otherHeaders(dir.path).empty()) << "what is not there is left to who includes it";
    EXPECT_TRUE(otherHeaders(shaderFolder()).empty());
    writeText(dir / "shared/frame.h", readText(shaderFolder() / "shared/frame.h"));
    EXPECT_TRUE(otherHeaders(dir.path).empty());
    std::string log;
    const int sink = addLogSink([&](LogLevel, const std::string& text) { log += text + "\n"; });
    Programs same(dir.path);
    EXPECT_EQ(log, "");
    writeText(dir / "shared/frame.h", readText(shaderFolder() / "shared/frame.h") + "\n#define TEX_OTHER 3\n");
    EXPECT_EQ(otherHeaders(dir.path), std::vector<std::string>{"shared/frame.h"});
    Programs one(dir.path), two(dir.path);
    removeLogSink(sink);
    const size_t first = log.find((dir / "shared/frame.h").string());
    EXPECT_NE(first, std::string::npos) << log;
    EXPECT_EQ(log.find("shared/frame.h", first + dir.path.string().size() + 5), std::string::npos) << log;
}

TEST(Program, AMisspeltFeatureIsACompileError) {
    gpu();
    Shaders s;
    writeText(s.dir / "a.frag.glsl", "out vec4 c;\nvoid main() { c = vec4(0.0); if (WINDY) c.x = 1.0; }\n");
    Programs programs(s.dir.path);
    EXPECT_FALSE(programs.get(s.sources, "const bool WIND = true;\n"));
}

TEST(Program, OnlyConstantsThatItsSourcesNameMakeItAnother) {
    gpu();
    Shaders s;
    writeText(s.dir / "a.frag.glsl",
              "#include \"lib/value.glsl\"\nout vec4 c; // as RAIN would\n/* or\nFOG */ const float SUNNY = 1.0;\n"
              "void main() { c = vec4(VALUE); if (WIND) c.x = SUNNY; }\n");
    Programs programs(s.dir.path);
    const auto with = [&](const std::string& constants) { return *programs.get(s.sources, constants); };
    const GLuint calm = with("const bool SUN = false;\nconst bool WIND = false;\n"),
                 windy = with("const bool WIND = true;\n");
    EXPECT_NE(calm, windy) << "a constant that is named";
    EXPECT_EQ(with("const bool SUN = true;\nconst bool WIND = true;\n"), windy) << "a part of another word";
    EXPECT_EQ(with("const int RAIN = 2;\nconst bool WIND = true;\nconst bool FOG = true;\n"), windy) << "comments";
    EXPECT_EQ(programs.size(), 2u);
    EXPECT_TRUE(programs.named(s.sources, "VALUE")) << "in an include";
    EXPECT_TRUE(programs.named(s.sources, "WIND"));
    EXPECT_FALSE(programs.named(s.sources, "FOG"));
    EXPECT_FALSE(programs.named({"test/gone", "gone.vert.glsl"}, "WIND"));
}

TEST(Program, ReloadingDeclaresWhatSourcesNameNow) {
    gpu();
    Shaders s;
    Programs programs(s.dir.path);
    const std::string rain = "const bool RAIN = true;\n", dry = "const bool RAIN = false;\n";
    EXPECT_EQ(*programs.get(s.sources, rain), *programs.get(s.sources, dry));
    s.rewrite("lib/value.glsl", "const float VALUE = RAIN ? 1.0 : broken;\n");
    EXPECT_EQ(programs.reload().failed.size(), 2u) << "with rain and without";
    EXPECT_TRUE(programs.reload().nothing()) << "told twice";
    s.rewrite("lib/value.glsl", "const float VALUE = RAIN ? 1.0 : 0.0;\n");
    EXPECT_EQ(programs.reload().renewed, 2);
    EXPECT_NE(*programs.get(s.sources, rain), *programs.get(s.sources, dry));
    s.rewrite("lib/value.glsl", "const float VALUE = 1.0;\n");
    EXPECT_EQ(programs.reload().renewed, 1);
    EXPECT_EQ(*programs.get(s.sources, rain), *programs.get(s.sources, dry));
}

TEST(Program, ReloadingTakesAChangedIncludeAndKeepsTheLastGoodProgram) {
    gpu();
    Shaders s;
    Programs programs(s.dir.path);
    const GLuint first = *programs.get(s.sources, "");
    EXPECT_TRUE(programs.reload().nothing()) << "nothing changed";
    EXPECT_EQ(*programs.get(s.sources, ""), first);

    s.rewrite("lib/value.glsl", "const float VALUE = broken;\n");
    const auto failed = programs.reload().failed;
    ASSERT_EQ(failed.size(), 1u);
    EXPECT_NE(failed[0].find("lib/value.glsl:1"), std::string::npos) << failed[0];
    EXPECT_EQ(*programs.get(s.sources, ""), first) << "the last good program is gone";
    GLint linked = 0;
    glGetProgramiv(first, GL_LINK_STATUS, &linked);
    EXPECT_EQ(linked, GL_TRUE);
    EXPECT_TRUE(programs.reload().nothing()) << "the same fault is not told twice";

    s.rewrite("lib/value.glsl", "const float VALUE = 2.0;\n");
    EXPECT_EQ(programs.reload().renewed, 1);
    EXPECT_TRUE(programs.get(s.sources, ""));
}

void expectCompiles(Programs& programs, const ProgramRow& p, const FeatureSet& scene) {
    const std::vector<std::string> variants = p.variants ? p.variants() : std::vector<std::string>{""};
    for (const std::string& constants : variants) {
        const auto program = programs.get(sourcesOf(p), featureConstants(scene) + constants);
        EXPECT_TRUE(program) << (program ? "" : program.error().text()) << " with " << constants;
    }
}

TEST(Program, EveryProgramOfTheTableCompilesForEveryFeatureSet) {
    NoGlErrors errors;
    Programs programs;
    for (const EffectRow& e : tables().effects)
        for (const Pass& pass : e.passes)
            for (const ProgramRow& p : pass.programs)
                for (const FeatureSet& scene : {FeatureSet{}, ~FeatureSet{}}) expectCompiles(programs, p, scene);
}

}  // namespace
}  // namespace sward::test
