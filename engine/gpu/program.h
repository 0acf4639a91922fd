// Programs from GLSL files: includes, line mapping, feature constants, and reloading that keeps the last good one.
// An include is resolved once a program stage; the compiler's messages name the file and line that the reader knows.
// Does not: decide which programs run; the frame plan does, and drops the rest.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "gpu/resources.h"

namespace sward {

// Where shaders/ lies: beside the build tree of the running executable, else the source tree it was built from.
std::filesystem::path shaderFolder();

// Of the headers that C++ and GLSL share (shared/*.h): those in the folder that are not as they were when this program
// was built, by their paths. What is drawn with such is garbage. One that is not there is left to who includes it.
std::vector<std::string> otherHeaders(const std::filesystem::path& folder);

struct ShaderText {
    std::string text;                // "#version", feature constants, then the sources with #line
    std::vector<std::string> files;  // by the number that their lines carry
};
// path: under the folder. `constants`: lines put after #version, such as "const bool WIND = true;". firstFile: the
// number of the first file, which is that of the files of other stages of the same program.
// Error: Failed, naming the file that cannot be read and the file and line that includes it.
Result<ShaderText> loadShaderText(const std::filesystem::path& folder, const std::string& path,
                                  const std::string& constants, size_t firstFile = 0);
// Rewrites "0:300012(3)", "0(300012)" and "ERROR: 0:300012" of a compiler's log to the third file's name and line 12.
std::string namedLog(const std::string& log, const std::vector<std::string>& files);

// Paths under the shader folder; null where a stage is absent.
struct ProgramSources {
    const char* name;
    const char* vertex = nullptr;
    const char* fragment = nullptr;
    const char* compute = nullptr;
    const char* control = nullptr;  // of tessellation
    const char* evaluation = nullptr;
};

// What a reload did: programs made anew, and the compilers' logs of those that kept their last good version.
struct Reload {
    int renewed = 0;
    std::vector<std::string> failed;
    // True if no shader changed since the last reload.
    bool nothing() const { return renewed == 0 && failed.empty(); }
};

class Programs {
  public:
    // Warns, once a folder, if its shaders are of another version than this program.
    explicit Programs(std::filesystem::path folder = shaderFolder());
    // The program with those of these constants ("const bool WIND = true;\n" each) that its sources name, compiled at
    // first use. What they do not name makes no other program of it; so no constant may be made of another. Failed with
    // the compiler's log.
    Result<GLuint> get(const ProgramSources& sources, const std::string& constants);
    // Whether one of the sources, or what it includes, has this word outside of comments. No if one cannot be read.
    bool named(const ProgramSources& sources, std::string_view word);
    // Recompiles what changed on disk since it was last compiled, with what it names now.
    Reload reload();
    // Forgets every program whose name is not listed.
    void keepOnly(const std::vector<std::string>& names);
    std::vector<std::string> names() const;  // sorted
    size_t size() const;                     // programs that differ in their name or in what they declare

  private:
    struct Entry {
        ProgramSources sources;
        std::string declared;  // those of the constants that the sources name
        GlName<ProgramKind> program;
        std::filesystem::file_time_type newest;
        std::vector<std::string> files;
    };
    // What a source and its includes name.
    struct Words {
        std::set<std::string, std::less<>> words;
        std::filesystem::file_time_type newest;
        std::vector<std::string> files;
    };
    using Key = std::pair<std::string, std::string>;  // name and constants
    Result<GLuint> build(Entry& entry);
    const Words* wordsOf(const char* path);
    std::string declaredOf(const ProgramSources& sources, const std::string& constants);
    std::shared_ptr<Entry> find(const std::string& name, const std::string& declared) const;
    Entry rebuilt(const Key& asked, const Entry& stale, Reload& done);

    std::filesystem::path folder_;
    std::map<std::string, Words, std::less<>> words_;  // by path
    std::map<Key, std::shared_ptr<Entry>> asked_;  // by all constants that were offered; what declares the same is one
};

}  // namespace sward
