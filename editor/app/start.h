// What the editor offers while no project is open: those that were open last, and the samples that come with Sward.
// The former are kept in $XDG_STATE_HOME/sward/recent.txt, a folder a line, the newest first; a file that cannot be
// read or written changes nothing. Does not: draw, or open anything.
#pragma once
#include <filesystem>
#include <vector>

#include "app/templates.h"

namespace sward {

inline constexpr size_t kMostRecent = 8;

struct StartScreen {
    std::vector<std::filesystem::path> recent, samples;
    std::vector<ProjectTemplate> templates;  // of the folder templates/ among the samples
    bool keep = false;                       // whether what is opened is remembered
};
// Those of the file that still are projects, and the projects in `samples`, by name.
StartScreen loadStart(const std::filesystem::path& file, const std::filesystem::path& samples);
std::filesystem::path recentFile();
// To the front; written if `keep` is set.
void rememberProject(StartScreen& start, const std::filesystem::path& project, const std::filesystem::path& file);

}  // namespace sward
