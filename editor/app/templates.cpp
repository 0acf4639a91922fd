#include "app/templates.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/file.h"
#include "script/script.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr uint64_t kMostScriptBytes = 1 << 20;

// "-- Title: what it is." and "-- 40 m, 0 m of relief" of a script's head; false if it has no title.
bool readHead(const std::string& text, ProjectTemplate& t) {
    std::istringstream lines(text);
    std::string first, second;
    std::getline(lines, first);
    std::getline(lines, second);
    const size_t colon = first.find(": ");
    if (!first.starts_with("-- ") || colon == std::string::npos) return false;
    t.title = first.substr(3, colon - 3);
    t.help = first.substr(colon + 2);
    if (!t.help.empty()) t.help[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(t.help[0])));
    (void)std::sscanf(second.c_str(), "-- %f m, %f m of relief", &t.size, &t.relief);
    return true;
}

Status runOn(Document& doc, const ProjectTemplate& from, const NewProject& wish) {
    const Result<std::string> text = readFile(from.script, kMostScriptBytes);
    if (!text) return text.error();
    ScriptHost host{doc};
    host.print = [](const std::string&) {};
    ScriptConsole lua(host);
    if (Status set = lua.run(fmt::format("size, relief = {}, {}", wish.size, wish.relief)); !set) return set;
    Status done = lua.run(*text);
    return done ? done : Status{failed(done.error().message).at(from.script, done.error().line)};
}

Status checkWish(const NewProject& w) {
    if (!(w.size >= kLeastSize && w.size <= kMostSize))
        return usage(fmt::format("a terrain of {} m cannot be made", w.size),
                     fmt::format("choose {} to {} m", kLeastSize, kMostSize));
    if (!(w.relief >= 0 && w.relief <= kMostRelief))
        return usage(fmt::format("a relief of {} m cannot be made", w.relief),
                     fmt::format("choose 0 to {} m", kMostRelief));
    return {};
}

}  // namespace

std::vector<ProjectTemplate> projectTemplates(const fs::path& folder) {
    std::vector<ProjectTemplate> found;
    std::error_code fault;
    for (fs::directory_iterator it(folder, fault), end; !fault && it != end; it.increment(fault)) {
        ProjectTemplate t;
        t.script = it->path();
        t.name = t.script.stem().string();
        t.picture = t.name + ".png";
        const Result<std::string> text =
            t.script.extension() == ".lua" ? readFile(t.script, kMostScriptBytes) : std::string();
        if (text && readHead(*text, t)) found.push_back(std::move(t));
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return found;
}

Status makeProject(const Tables& tables, const fs::path& dir, const ProjectTemplate& from, const NewProject& wish) {
    if (Status sound = checkWish(wish); !sound) return sound;
    std::error_code fault;
    const bool wasThere = fs::exists(dir, fault);
    Document doc(tables);
    if (Status made = doc.create(dir); !made) return made;
    Status done = runOn(doc, from, wish);
    if (done)
        if (const auto saved = doc.save(); !saved) done = saved.error();
    if (done) return done;
    for (fs::directory_iterator it(dir, fault), end; !fault && it != end; it.increment(fault)) {
        std::error_code ignored;
        fs::remove_all(it->path(), ignored);
    }
    if (!wasThere) fs::remove(dir, fault);
    return done;
}

}  // namespace sward
