// A verb of this program that works beside the editor on a copy of the project as it is now, from the view that is
// shown: how it is started, followed and stopped. Each has a folder of its project's under the state folder, where what
// it prints lies as VERB.out and VERB.err. Does not: read results; who starts it does.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/child_process.h"
#include "core/jobs.h"

namespace sward {

class Document;
struct FlyCamera;
struct FrameClock;
struct Messages;

// How far a program beside is: what it printed last of the share done of its present part.
struct RunNews {
    std::string what = {};          // "human: hybrid maxGeom=6"; empty: nothing was told yet
    double share = 0;               // of this part
    double since = 0, read = -1e9;  // seconds: when the part began; when the file was looked at last
};
// The last line "NN %  what" of a text; nothing without one.
std::optional<RunNews> newsFrom(const std::string& text);
// "41 %, 20 s left: human: hybrid maxGeom=6", or that it starts.
std::string newsText(const RunNews& news, double now);

struct SideRun {
    Job<bool> copying;  // of the project, beside the frames: maps of 4096 x 4096 texels take seconds to write
    std::vector<std::string> command;  // that starts once the copy is there
    ChildProcess child;
    std::filesystem::path folder, copy;
    double started = 0;
    RunNews news;
    std::string camera;  // from which it measures
    std::string error;   // why it gave nothing; empty: it did, or runs still

    bool running() const { return copying.active() || child.running(); }
};
// What a measurement is started from.
struct MeasureParts {
    Document& doc;
    const std::string& program;  // that measures: this one, as its file
    const FlyCamera& camera;
    const FrameClock& clock;
    Messages& messages;
};

// Where runs of the project as it is now keep what they make: another state of it has another folder.
std::filesystem::path sideFolder(const Document& document);
// Starts `sward VERB COPY --camera CAMERA ARGS...` once the copy is written. `camera`: of the project; else the copy
// gets one of this name that sees what is shown. Fails if no project is open or it runs already.
Status launchRun(SideRun& run, const MeasureParts& parts, const char* verb, const std::string& camera,
                 const std::vector<std::string>& args);
// Once a frame: its exit code, once, when it has ended, and 1 if it could not be started; its copy is gone then.
std::optional<int> endedRun(SideRun& run, FrameClock& clock);
// Why it could not be started; else what it said last that is no progress; else that it ended with this code.
std::string failureOf(const SideRun& run, const char* verb, int code);
// Looks now and then at what it printed. True if it is further.
bool followNews(SideRun& run, const char* verb, double now);
// Kills it and drops its copy, which is gone a moment later where it was being written.
void stopRun(SideRun& run);

}  // namespace sward
