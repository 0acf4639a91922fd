// The command line: one function a verb, options as plain structs. What each option means stands in the README.
// Every verb prints its failure as "sward: error: file:line: message (remedy)" and returns the exit code of
// core/error.h.
#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "frame/renderer.h"
#include "world/view_camera.h"

namespace sward {

// Reads the arguments, runs their verb, and gives the exit code of the process. No verb: the editor.
int runCommandLine(int argc, char** argv);

// Options that render, and what later sweeps and measures pictures, share.
struct RenderOptions {
    std::string project;
    std::string camera;  // empty: all
    std::string path;    // a CameraPath to film along instead; empty: none
    std::string size = "1024x768";
    std::string technique;         // empty: the project's
    std::vector<std::string> set;  // PATH=VALUE
    std::string view = "final";
    int msaa = 4;
    double time = 0;
    int frames = 0;  // measured after 3 warm-ups; 0: the picture alone
    double fps = 0;  // with frames: write that many pictures
    int first = 0;   // ... from this one on: the others of a film are another machine's
    std::string out;
    std::string stats;
};
// `sward render`: pictures of a project, or measured frames.
int renderVerb(const RenderOptions& options);
struct ReferenceOptions : RenderOptions {
    int samples = 16;
    std::string lighting = "full";
    std::string shard;  // "I/N"; empty: the whole image
    uint32_t seed = 1;
};
// `sward reference`: pictures by the path tracer, or a shard of one.
int referenceVerb(const ReferenceOptions& options);
struct MergeCommand {
    std::vector<std::string> parts;
    std::string out;
};
// `sward merge`: shards of one picture, or of one sweep, joined.
int mergeVerb(const MergeCommand& options);

struct CostOptions : RenderOptions {
    int samples = 32, rounds = 5;
    double maxMs = 0;
    std::string lighting = "full", shard;
    uint32_t seed = 1;
    bool numerics = false, json = false;  // the formulas' price instead of a project's
};
// `sward cost`: time and error of each technique at many settings.
int costVerb(const CostOptions& options);
// The parts of a sharded sweep, joined into a cost.json or cost.csv.
int mergeCostVerb(const MergeCommand& options);
// Whether a file or folder is a part of a sweep.
bool isCostPart(const std::filesystem::path& file);
struct FitOptions : CostOptions {
    double budgetMs = 0;
    int candidates = 40;
    double seconds = std::numeric_limits<double>::infinity();
    std::string soFar;  // file for the best so far
    bool write = false;
};
// `sward fit`: the truest settings within a budget.
int fitVerb(const FitOptions& options);

struct EffectOptions : RenderOptions {
    int pairs = 7;
    bool json = false;
};
// `sward effects`: where each effect changes the picture, what it costs, and what turns it off.
int effectsVerb(const EffectOptions& options);

struct CompareOptions {
    std::string a, b, mask, heatmap, metric = "appearance";
    double ppd = 67;  // pixels per degree, of FLIP
    bool json = false, linear = false;
};
// `sward compare`: how two pictures or films differ, by all metrics.
int compareVerb(const CompareOptions& options);

struct TransitionOptions {
    std::string project, path, size = "160x120", technique, out;
    std::vector<std::string> set;
    int pictures = 25, samples = 4;
    double time = 0, from = 0, to = 0;
    bool json = false;
};
// `sward transitions`: what pops along a path of the camera.
int transitionsVerb(const TransitionOptions& options);
struct NewCommand {
    std::string dir, from;              // of a template; empty: one terrain, one field, a sun, a camera
    std::optional<float> size, relief;  // metres; absent: what suits the template
};
// `sward new`: a project in a folder that is empty or is not there yet.
int newVerb(const NewCommand& options);
// `sward check`: reads the project and says what is wrong with it. `strict`: warnings count as errors.
int checkVerb(const std::string& project, bool strict);
struct PictureOptions {
    std::string project, camera, out, size;
    std::optional<double> time;
    bool accept = false, json = false;
};
// `sward check --pictures`: the accepted pictures of cameras as tests, or made.
int pictureVerb(const PictureOptions& options);
struct ImportCommand {
    std::string project, map, file;
    bool flip = false, packed = false;
    std::string range;  // "LOW,HIGH"
};
// `sward import`: an image file into a map.
int importVerb(const ImportCommand& options);
struct ExportCommand {
    std::string project, map, out;  // no map: the scene
    bool flip = false, packed = false;
    std::optional<double> bladesWithin;  // of the scene: metres from the camera
    std::string camera, stats;
};
// `sward export`: a map into an image file, or the scene into a .glb.
int exportVerb(const ExportCommand& options);
int exportSceneVerb(const ExportCommand& options);
struct BakeCommand {
    std::string project;
    std::vector<std::string> only;  // flags of the bakes wanted; none: all
    int samples = 64, size = 0;
};
// `sward bake`: what model/bakes.h lists.
int bakeVerb(const BakeCommand& options);
// `sward explain`: the passes that run for a project, and why.
int explainVerb(const std::string& project, bool json);
struct HardCasesOptions {
    bool json = false;
    std::string curve, out;  // one case along its variable: its key, and a file for it; empty: it is printed
};
// `sward hardcases`: the formulas on the CPU and the GPU where they are hardest.
int hardcasesVerb(const HardCasesOptions& options);
struct ScriptOptions {
    std::string file, project;
    std::string size = "1280x800";  // of the editor without a window, in points
    float density = 1;              // its pixels a point
    bool window = false;
};
// `sward script`: a Lua file, without a window unless one is asked for.
int scriptVerb(const ScriptOptions& options);
// The editor in a window; `project` may be empty. `widgets`: a file for where each widget is, or empty.
int editVerb(const std::string& project, const std::string& widgets = {});

// --- shared by the verbs
// Prints the error and gives its exit code.
int report(const Error& error);
// The project with --set and --technique applied, repairs told on standard error.
Result<Project> openForRendering(const RenderOptions& options);
// Which cameras, in the order of their names. Errors: none, or none of that name.
Result<std::vector<std::string>> cameraNames(const Project& project, const std::string& wanted);
// Of what pictures are taken: the cameras, or the path alone, whose rate and length then stand in `options` (25 a
// second, all of it, where they are not given). Errors: as cameraNames; no path of that name, or one without keys; a
// path and a camera.
Result<std::vector<std::string>> shotNames(RenderOptions& options, const Project& project);
// The camera of that name, or where it is on the path that many seconds from its beginning.
ViewCamera shotAt(const RenderOptions& options, const Project& project, const std::string& name, double seconds);
// Where each camera's picture goes.
std::filesystem::path outputOf(const RenderOptions& options, const Project& project, const std::string& camera,
                               bool several);
// "I/N"; empty: 0 of 1. Usage error otherwise.
Result<std::pair<int, int>> parseShard(const std::string& text);
// "1024x768"; Usage error otherwise. Each side from 1 to 16384.
Result<std::pair<int, int>> parseSize(const std::string& text);

}  // namespace sward
