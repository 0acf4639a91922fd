// Scenes to begin a project from: a Lua script each in projects/templates, with a picture beside it. The script works
// on a new project that is open and gets what the person chose: `size` (metres each way) and `relief` (metres between
// the lowest and the highest ground that it makes). Its first line, a comment, says "Title: what it is".
// Does not: draw them (panels/start.cpp, panels/new_project.cpp).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/document.h"

namespace sward {

struct ProjectTemplate {
    std::string name;  // of its script, without ".lua"
    std::string title, help;
    std::filesystem::path script;
    std::string picture;  // of a file beside the script; there need not be one
    float size = 40;      // metres that suit it; its script's second line says them: "-- 40 m, 0 m of relief"
    float relief = 0;
};
// Those in a folder, in the order of their names; scripts without a title are no templates.
std::vector<ProjectTemplate> projectTemplates(const std::filesystem::path& folder);

// What the person chose for a new project.
struct NewProject {
    std::string name;             // of a template; empty: the bare field that `sward new` makes
    float size = 40, relief = 0;  // metres
};
inline constexpr float kLeastSize = 4, kMostSize = 4000, kMostRelief = 500;

// A new project of the template in a folder that is empty or is not there yet; saved. Errors of Document::create, and
// of the script; nothing is left behind then. Usage error: a size or relief out of range.
Status makeProject(const Tables& tables, const std::filesystem::path& dir, const ProjectTemplate& from,
                   const NewProject& wish);

}  // namespace sward
