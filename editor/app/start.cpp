#include "app/start.h"

#include <algorithm>
#include <sstream>

#include "core/file.h"

namespace sward {
namespace fs = std::filesystem;
namespace {

constexpr uint64_t kMostRecentBytes = 1 << 16;

bool isProject(const fs::path& folder) {
    std::error_code error;
    return fs::is_regular_file(folder / "project.json", error);
}

}  // namespace

fs::path recentFile() { return stateDir() / "recent.txt"; }

StartScreen loadStart(const fs::path& file, const fs::path& samples) {
    StartScreen start;
    std::error_code error;
    for (fs::directory_iterator it(samples, error), end; !error && it != end; it.increment(error))
        if (isProject(it->path())) start.samples.push_back(it->path());
    start.templates = projectTemplates(samples / "templates");
    std::sort(start.samples.begin(), start.samples.end());
    const Result<std::string> text = readFile(file, kMostRecentBytes);
    std::istringstream lines(text ? *text : "");
    for (std::string line; start.recent.size() < kMostRecent && std::getline(lines, line);)
        if (fs::path(line).is_absolute() && isProject(line)) start.recent.push_back(line);
    return start;
}

void rememberProject(StartScreen& start, const fs::path& project, const fs::path& file) {
    if (project.empty() || !isProject(project)) return;
    std::erase(start.recent, project);
    start.recent.insert(start.recent.begin(), project);
    if (start.recent.size() > kMostRecent) start.recent.resize(kMostRecent);
    if (!start.keep) return;
    std::string text;
    for (const fs::path& p : start.recent)
        if (p.string().find('\n') == std::string::npos) text += p.string() + "\n";
    if (makeFolderOf(file)) (void)writeFileAtomic(file, text);  // without it nothing is lost but comfort
}

}  // namespace sward
