// Programs from GLSL files: includes, line mapping, feature constants, and reloading that keeps the last good one.
// An include is resolved once a program stage; the compiler's messages name the file and line that the reader knows.
// Does not: decide which programs run; the frame plan does, and drops the rest.
#pragma once
#include <filesystem>
#include <map>
#include <string>
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
// path: under the folder. `constants`: lines put after #version, such as "const bool WIND = true;".
// Error: Failed, naming the file that cannot be read and the file and line that includes it.
Result<ShaderText> loadShaderText(const std::filesystem::path& folder, const std::string& path,
                                  const std::string& constants);
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
    // The program with these constants, compiled at first use. Failed with the compiler's log.
    Result<GLuint> get(const ProgramSources& sources, const std::string& constants);
    // Recompiles what changed on disk since it was last compiled.
    Reload reload();
    // Forgets every program whose name is not listed.
    void keepOnly(const std::vector<std::string>& names);
    std::vector<std::string> names() const;  // sorted
    size_t size() const { return programs_.size(); }

  private:
    struct Entry {
        ProgramSources sources;
        std::string constants;
        GlName<ProgramKind> program;
        std::filesystem::file_time_type newest;
        std::vector<std::string> files;
    };
    Result<GLuint> build(Entry& entry);
    std::filesystem::path folder_;
    std::map<std::pair<std::string, std::string>, Entry> programs_;  // by name and constants
};

}  // namespace sward
