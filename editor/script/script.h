// Runs Lua scripts on the open document: the same calls serve tests, batch work, map making and the editor's console.
// The calls are described in docs/scripting.md.
// Does not: open windows; ui.* goes to the UiDriver that the host has, and fails without one.
// Scripts are Lua 5.4 text without os, io, debug, load and require, bounded in instructions, time and memory, and reach
// only files in the script's folder, the open project's and temporary copies that they make.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/document.h"
#include "script/ui_driver.h"

namespace sward {

struct FilmPlan;

struct ScriptLimits {
    uint64_t instructions = 4'000'000'000;   // about half a minute; map operations count by their texels
    double seconds = 600;                    // of the processor's time in the script's thread
    size_t memoryBytes = size_t(512) << 20;  // of Lua's values
    size_t mapBytes = size_t(2) << 30;       // of all maps of the project together, for what scripts create
};

struct ScriptHost {
    Document& document;
    UiDriver* ui = nullptr;          // null: ui.* fails and says so
    std::filesystem::path folder{};  // of the console: where relative paths begin; runScript takes the script's
    std::function<void(const std::string&)> print{};      // a line from print(); none: standard output
    std::function<void(const std::string&)> useCamera{};  // camera.use: shows the view of this entity
    // bake.NAME: bakes with so many samples, at this size (0: its own choice); see model/bakes.h.
    std::map<std::string, std::function<Status(int samples, int size)>> bakes{};
    // project.export: the scene into a .glb, with blades within so many metres of a camera (below 0: all); what it
    // holds, by name. None: it fails and says so. See model/scene_export.h.
    std::function<Result<std::vector<std::pair<const char*, size_t>>>(const std::filesystem::path& file, double within,
                                                                      const std::string& camera)>
        exportScene{};
    // camera.picture and camera.film: from a camera (""; the first) where the plan has no path. None: they fail and say
    // so. See app/film.h.
    std::function<Status(const FilmPlan& plan, const std::string& camera)> film{};
    std::function<PlayStart()> playStart{};  // where play.start begins; none: at `camera`, moved by play.step alone
    std::string camera{};                    // the last that camera.use named
    BrushSettings brush{};                   // the last that brush.select chose
    std::vector<std::string> alsoPaints{};   // further maps that it named
    ScriptLimits limits{};
    std::function<bool()> stopped{};  // asked now and then: true ends the script, with the exit code of interruptions
};

// Runs a script file. An error carries the script's file and line, and the exit code of what failed (1 for the
// script's own errors and expectations, else that of the call: 2 for an unknown path, 3 for an unsound project).
// What the script changed before it failed stays in the document, as undo steps.
Status runScript(const std::filesystem::path& file, ScriptHost& host);

// A Lua state that lives on from line to line, with the same calls and bounds (instructions: per line).
class ScriptConsole {
  public:
    explicit ScriptConsole(ScriptHost& host);  // host must outlive it
    ~ScriptConsole();
    // Runs one line; the values of an expression are printed.
    Status run(const std::string& line);
    // What a word that is being typed may become, sorted: "map.me" becomes "map.mean" and "map.median".
    std::vector<std::string> completions(const std::string& word);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sward
