#include "gpu/program.h"

#include <cctype>
#include <fstream>
#include <mutex>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "core/log.h"
#include "core/resources.h"

namespace sward {
namespace fs = std::filesystem;

fs::path shaderFolder() { return resource("shaders/numerics").parent_path(); }

namespace {

struct SharedHeader {
    const char *path, *text;
};
constexpr SharedHeader kSharedHeaders[] = {
#include "shared_headers.inc"
};

std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void warnOfOthers(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> told;
    const std::vector<std::string> others = otherHeaders(folder);
    const std::lock_guard lock(mutex);
    if (!others.empty() && told.insert(folder).second)
        logWarning(
            fmt::format("{}: not as it was when this program was built; pictures may be garbage (build again, or bring "
                        "back the shaders of this version)",
                        (folder / others[0]).string()));
}

std::optional<std::string> includeOf(const std::string& line) {
    const size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) return {};
    const size_t a = line.find('"'), b = line.rfind('"');
    if (a == std::string::npos || b <= a) return {};
    return line.substr(a + 1, b - a - 1);
}

// A line's number carries its file's: Mesa forgets #line's second number in half of its messages.
constexpr size_t kLinesPerFile = 100000;
std::string lineDirective(size_t file, int line) {
    return fmt::format("#line {}\n", file * kLinesPerFile + static_cast<size_t>(line));
}

struct Loader {
    fs::path folder;
    size_t firstFile;
    ShaderText out;
    std::set<std::string> done;

    Status append(const std::string& path, const std::string& from, int fromLine) {
        if (!done.insert(path).second) return {};
        std::ifstream in(folder / path);
        if (!in) {
            const std::string where = from.empty() ? "" : fmt::format(", included by {}:{}", from, fromLine);
            return failed("shader source not found" + where, "the program needs the shaders/ folder of its own version")
                .at((folder / path).string());
        }
        const size_t number = firstFile + out.files.size();
        out.files.push_back(path);
        out.text += lineDirective(number, 1);
        std::string line;
        for (int n = 1; std::getline(in, line); ++n) {
            const auto include = includeOf(line);
            if (!include) {
                if (line.rfind("#pragma once", 0) != 0) out.text += line;
                out.text += "\n";
                continue;
            }
            if (Status s = append(*include, path, n); !s) return s;
            out.text += lineDirective(number, n + 1);
        }
        return {};
    }
};

}  // namespace

std::vector<std::string> otherHeaders(const fs::path& folder) {
    std::vector<std::string> others;
    std::error_code ec;
    for (const SharedHeader& h : kSharedHeaders)
        if (fs::exists(folder / h.path, ec) && textOf(folder / h.path) != h.text) others.push_back(h.path);
    return others;
}

Programs::Programs(fs::path folder) : folder_(std::move(folder)) { warnOfOthers(folder_); }

Result<ShaderText> loadShaderText(const fs::path& folder, const std::string& path, const std::string& constants,
                                  size_t firstFile) {
    Loader loader{folder, firstFile, {}, {}};
    loader.out.text = "#version 450 core\n" + constants;
    if (Status s = loader.append(path, "", 0); !s) return s.error();
    return std::move(loader.out);
}

std::string namedLog(const std::string& log, const std::vector<std::string>& files) {
    static const std::regex place(R"((^|ERROR: |\n)\d+[:(](\d+)\)?)");
    std::string out;
    auto at = log.cbegin();
    for (std::sregex_iterator it(log.begin(), log.end(), place), end; it != end; ++it) {
        out.append(at, log.cbegin() + it->position());
        const size_t number = std::stoull((*it)[2]), file = number / kLinesPerFile;
        out +=
            (*it)[1].str() + (file < files.size() ? files[file] : "?") + ":" + std::to_string(number % kLinesPerFile);
        at = log.cbegin() + it->position() + it->length();
    }
    out.append(at, log.cend());
    return out;
}

namespace {

// files: of the stages before it, and then of this one; their lines carry their number among all, as a linker that
// finds an error names lines of any stage.
Result<GLuint> compileStage(const fs::path& folder, GLenum stage, const char* path, const std::string& constants,
                            std::vector<std::string>& files) {
    auto text = loadShaderText(folder, path, constants, files.size());
    if (!text) return text.error();
    files.insert(files.end(), text->files.begin(), text->files.end());
    const GLuint shader = glCreateShader(stage);
    const char* source = text->text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    std::string log(16384, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<size_t>(length));
    glDeleteShader(shader);
    return failed("does not compile:\n" + namedLog(log, files)).at(path);
}

Result<GLuint> link(const char* name, const std::vector<GLuint>& shaders, const std::vector<std::string>& files) {
    const GLuint program = glCreateProgram();
    for (GLuint s : shaders) glAttachShader(program, s);
    glLinkProgram(program);
    GLint ok = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok) {
        glObjectLabel(GL_PROGRAM, program, -1, name);
        return program;
    }
    std::string log(16384, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<size_t>(length));
    glDeleteProgram(program);
    return failed("does not link:\n" + namedLog(log, files)).at(name);
}

fs::file_time_type newestOf(const fs::path& folder, const std::vector<std::string>& files) {
    fs::file_time_type newest = fs::file_time_type::min();
    for (const std::string& f : files) {
        std::error_code ec;
        if (const auto t = fs::last_write_time(folder / f, ec); !ec) newest = std::max(newest, t);
    }
    return newest;
}

bool inWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Where what begins at `at` ends, if that is a comment; else `at`.
size_t afterComment(const std::string& text, size_t at) {
    const bool line = text.compare(at, 2, "//") == 0;
    if (!line && text.compare(at, 2, "/*") != 0) return at;
    const size_t end = text.find(line ? "\n" : "*/", at + 2);
    return end == std::string::npos ? text.size() : end + (line ? 1 : 2);
}

// All words of a text that stand outside of its comments.
std::set<std::string, std::less<>> wordsIn(const std::string& text) {
    std::set<std::string, std::less<>> words;
    for (size_t at = 0; at < text.size();) {
        if (const size_t after = afterComment(text, at); after != at) {
            at = after;
            continue;
        }
        size_t end = at;
        while (end < text.size() && inWord(text[end])) ++end;
        const std::string_view word(text.data() + at, end - at);
        if (!word.empty() && !words.contains(word)) words.emplace(word);
        at = std::max(end, at + 1);
    }
    return words;
}

// The name in "const TYPE NAME = ..."; empty: the line is no constant's.
std::string_view nameOf(std::string_view line) {
    if (!line.starts_with("const ")) return {};
    const size_t type = line.find(' ', 6), from = type == std::string_view::npos ? line.size() : type + 1;
    size_t end = from;
    while (end < line.size() && inWord(line[end])) ++end;
    return line.substr(from, end - from);
}

}  // namespace

Result<GLuint> Programs::build(Entry& entry) {
    const std::pair<GLenum, const char*> stages[] = {{GL_VERTEX_SHADER, entry.sources.vertex},
                                                     {GL_FRAGMENT_SHADER, entry.sources.fragment},
                                                     {GL_COMPUTE_SHADER, entry.sources.compute},
                                                     {GL_TESS_CONTROL_SHADER, entry.sources.control},
                                                     {GL_TESS_EVALUATION_SHADER, entry.sources.evaluation}};
    std::vector<GLuint> shaders;
    std::vector<std::string> files;
    std::optional<Error> error;
    for (const auto& [stage, path] : stages) {
        if (!path || error) continue;
        auto shader = compileStage(folder_, stage, path, entry.declared, files);
        if (shader)
            shaders.push_back(*shader);
        else
            error = shader.error();
    }
    Result<GLuint> program = error ? Result<GLuint>(*error) : link(entry.sources.name, shaders, files);
    for (GLuint s : shaders) glDeleteShader(s);
    if (!files.empty()) entry.files = files;
    entry.newest = newestOf(folder_, entry.files);
    return program;
}

std::string Programs::declaredOf(const ProgramSources& sources, const std::string& constants) {
    std::string declared;
    for (size_t at = 0; at < constants.size();) {
        const size_t end = std::min(constants.find('\n', at), constants.size() - 1) + 1;
        const std::string_view line(constants.data() + at, end - at);
        if (const std::string_view name = nameOf(line); name.empty() || named(sources, name)) declared += line;
        at = end;
    }
    return declared;
}

const Programs::Words* Programs::wordsOf(const char* path) {
    if (const auto it = words_.find(std::string_view(path)); it != words_.end()) return &it->second;
    auto text = loadShaderText(folder_, path, "");
    if (!text) return nullptr;
    Words w{wordsIn(text->text), newestOf(folder_, text->files), text->files};
    return &words_.emplace(path, std::move(w)).first->second;
}

bool Programs::named(const ProgramSources& s, std::string_view word) {
    for (const char* path : {s.vertex, s.fragment, s.compute, s.control, s.evaluation}) {
        const Words* words = path ? wordsOf(path) : nullptr;
        if (words && words->words.contains(word)) return true;
    }
    return false;
}

std::shared_ptr<Programs::Entry> Programs::find(const std::string& name, const std::string& declared) const {
    for (auto it = asked_.lower_bound({name, ""}); it != asked_.end() && it->first.first == name; ++it)
        if (it->second->declared == declared) return it->second;
    return nullptr;
}

Result<GLuint> Programs::get(const ProgramSources& sources, const std::string& constants) {
    Key asked(sources.name, constants);
    if (auto it = asked_.find(asked); it != asked_.end()) return it->second->program.id();
    const std::string declared = declaredOf(sources, constants);
    std::shared_ptr<Entry> entry = find(asked.first, declared);
    if (!entry) {
        entry = std::make_shared<Entry>(Entry{sources, declared, {}, {}, {}});
        auto program = build(*entry);
        if (!program) return program;
        entry->program = GlName<ProgramKind>(*program);
    }
    return asked_.emplace(std::move(asked), std::move(entry)).first->second->program.id();
}

// Compiled from the sources as they are now; no program where they do not compile.
Programs::Entry Programs::rebuilt(const Key& asked, const Entry& stale, Reload& done) {
    Entry entry{stale.sources, declaredOf(stale.sources, asked.second), {}, {}, stale.files};
    auto program = build(entry);
    if (program) {
        entry.program = GlName<ProgramKind>(*program);
        ++done.renewed;
    } else {
        done.failed.push_back(program.error().text());
    }
    return entry;
}

// A source that changed may name other constants: what declared the same before may part, and the other way round.
Reload Programs::reload() {
    std::erase_if(words_, [&](const auto& w) { return newestOf(folder_, w.second.files) > w.second.newest; });
    std::set<const Entry*> stale;
    for (const auto& [asked, entry] : asked_)
        if (newestOf(folder_, entry->files) > entry->newest) stale.insert(entry.get());
    Reload done;
    std::map<Key, std::shared_ptr<Entry>> made;
    for (auto& [asked, entry] : asked_) {
        if (!stale.contains(entry.get())) continue;
        std::shared_ptr<Entry>& anew = made[{asked.first, declaredOf(entry->sources, asked.second)}];
        if (!anew) anew = std::make_shared<Entry>(rebuilt(asked, *entry, done));
        if (anew->program.id())
            entry = anew;
        else
            entry->newest = anew->newest, entry->files = anew->files;  // told once
    }
    return done;
}

void Programs::keepOnly(const std::vector<std::string>& names) {
    std::erase_if(asked_,
                  [&](const auto& p) { return std::find(names.begin(), names.end(), p.first.first) == names.end(); });
}

std::vector<std::string> Programs::names() const {
    std::vector<std::string> out;
    for (const auto& [key, entry] : asked_)
        if (out.empty() || out.back() != key.first) out.push_back(key.first);
    return out;
}

size_t Programs::size() const {
    std::set<const Entry*> entries;
    for (const auto& [key, entry] : asked_) entries.insert(entry.get());
    return entries.size();
}

}  // namespace sward
