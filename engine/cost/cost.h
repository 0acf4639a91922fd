// What accuracy costs in time: a project's cameras, or moments of a path, drawn by every technique at many settings;
// for each picture how long it takes and how far it is from the ray-traced truth; and which of them nothing beats in
// both beyond doubt (the frontier). One row a view is the project as it ships; rows of a technique that draw the very
// same picture are one, the first of them. Times: wall clock with one finish a frame, taken in rounds over all rows, so
// that a change of the machine's load meets all alike; each after one frame of the same setting that is not counted
// (cost_times.h). Errors: metrics.h over the truth's grass, of the picture as it is drawn, and of the mean of
// kConvergedFrames frames, the drawn one and others moved by fractions of a pixel, which has less noise of sampling.
// What takes longer than a limit is left out and named: after a frame, or unseen, where a setting that takes no more
// did already. Rows, truths and times are kept in a folder as they are finished, under a hash of all that they follow
// from; a sweep that was stopped goes on from there, and one that is run again only reads. Does not: write tables,
// plots or reports (cost_files.h, cost_report.h).
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cost/cost_settings.h"
#include "gpu/gpu.h"
#include "metrics/metrics.h"
#include "reference/reference.h"
#include "world/view_camera.h"

namespace sward {

inline constexpr int kConvergedFrames = 4;

// One picture. Values that were not taken are not-a-number.
struct CostRow {
    std::string camera, technique, settings;
    double msMedian = std::numeric_limits<double>::quiet_NaN(), msP95 = msMedian;
    double msSigma =
        msMedian;            // standard error of the median, from the scatter of the timed frames; not-a-number of one
    std::vector<double> ms;  // the timed frames
    Metrics metrics;         // as drawn
    Appearance converged;
    uint64_t gpuBytes = 0;
    bool onFrontier = false;  // of its camera, on its machine
    std::string skipped;      // why it was not drawn; empty: it was
    std::string image;        // the picture's file, relative to the sweep's folder
    std::string pixels;       // hash of the picture as it is drawn, before tone mapping; empty of what was not drawn
    int index = 0;            // in the whole sweep
    int machine = 0;          // index into CostRun::machines
};
// What scores are to be held against, by camera.
struct CostFloors {
    std::string camera;
    Appearance seed = {};      // the truth of the same field with other blades: nothing need be nearer
    Appearance sampling = {};  // the truth at as few samples a pixel as techniques have: what noise alone makes
    Appearance flat = {};      // the truth with each row of its grass at its mean colour: worse is worthless
    double truthError = 0;     // mean standard error of the truth, linear
    std::string image = {};    // the truth as a picture, relative to the sweep's folder
};
struct CostMachine {
    std::string renderer, timing;  // timing: "wall-finish"
    int cores = 0;
    std::string host{}, cpu{};  // names; empty: unknown
};
struct CostRun {
    std::string project, hash;  // hash: of project, size, time and truth; parts of one sweep share it
    int width = 0, height = 0, samples = 0;
    std::string lighting;
    std::vector<CostMachine> machines;
    std::vector<CostFloors> floors;
    std::vector<CostRow> rows;
    int total = 0;  // rows of the whole sweep, of which a shard has some
};

// From where pictures are taken: a camera of the project, or a moment of a path.
struct CostView {
    std::string name;  // no two of a request's are alike; with the project it says where the view is
    ViewCamera camera;
    double since = 0;  // scene seconds after the request's own
};
struct CostRequest {
    std::vector<CostView> views;
    int width = 1024, height = 768;
    double time = 0;          // scene seconds
    ReferenceSettings truth;  // size and time are taken from here
    std::vector<CostSetting> settings;
    int rounds = 5;    // of timing, at most; slow rows are timed in fewer
    double maxMs = 0;  // rows that take longer, or would, are left out; 0: twice what the project's own settings take,
                       // at least 250
    int shard = 0, shards = 1;     // of the rows, those whose index is shard modulo shards
    std::filesystem::path folder;  // where finished rows are kept
};
// What is being done and which share of it is done; false stops.
using CostProgress = std::function<bool(const std::string& what, double share)>;

// Interrupted error once progress says no: what is finished is kept. Failed: a folder that cannot be written, no
// context.
Result<CostRun> runCost(const CostRequest& request, const Project& project, const Tables& tables, Gpu& gpu,
                        const CostProgress& progress);

// Whether `a` is better than `b` beyond doubt: in one of time and appearance by more than their joint standard error,
// and in the other not worse by more. Rows of which neither beats the other in anything are one point.
bool beats(const CostRow& a, const CostRow& b);
// Sets onFrontier: no other drawn row of the same camera and machine beats it.
void markFrontier(std::vector<CostRow>& rows);
// Indices of the rows that stay when those go that draw the same picture as an earlier row of their camera and
// technique.
std::vector<size_t> distinctRows(const std::vector<CostRow>& rows);
// Leaves the others out of a whole sweep and numbers the rest anew.
void keepDistinct(CostRun& run);

}  // namespace sward
