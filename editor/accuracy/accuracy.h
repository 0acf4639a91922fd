// What accuracy costs, as the editor shows it: the view beside the ray-traced truth or another technique, the project's
// own time-appearance plot, a fit to a budget, and what a stroke adds. State and logic. Does not: draw;
// panels/accuracy.cpp and panels/viewport_compare.cpp do. Nothing is run or kept while it is off.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/side_run.h"
#include "core/jobs.h"
#include "cost/cost.h"
#include "frame/renderer.h"
#include "gpu/resources.h"
#include "metrics/metrics.h"
#include "reference/reference.h"
#include "world/view_camera.h"

namespace sward {

class Document;
struct FlyCamera;
struct FrameClock;
struct Messages;
struct ViewportHand;
struct ViewportPicture;

// --- passes of the reference: one sample a pixel each, of a seed of its own
struct PassSum {
    int width = 0, height = 0, passes = 0;
    std::vector<double> sum, squares;  // RGB, linear
    std::vector<double> grass;
};
void addPass(PassSum& sum, const Truth& pass);  // of the sum's size; the first gives it
// Mean of the passes, its standard error by their scatter (infinite of one), and the share of grass.
Truth meanOf(const PassSum& sum);
double meanError(const Truth& truth);  // mean of error over pixels and channels
inline constexpr int kMostPasses = 256;
inline constexpr int kHeadlessPasses = 8;  // that a screenshot waits for
inline constexpr double kCompareRestSeconds = 0.4;
inline constexpr int kCompareWidth = 480;  // pixels: the reference is traced, and scores are taken, no wider
// A size halved until it is at most kCompareWidth wide; at least 1 x 1.
glm::ivec2 comparisonSize(int width, int height);

// --- the comparison in the viewport
enum class Against { Off, Reference, Technique, Settings };
enum class CompareShow { Split, Error };
inline constexpr const char* kCompareShows[] = {"split", "error"};

// What a comparison is of; once it differs all that was made for it is dropped.
struct ComparisonKey {
    Against against = Against::Off;
    uint64_t revision = ~uint64_t(0);
    ViewCamera camera;
    int width = 0, height = 0;  // of the viewport's picture
    std::string settings;       // technique and settings that are shown
    bool operator==(const ComparisonKey& o) const;
};
struct ComparedPass {
    std::shared_ptr<const ReferenceScene> scene;
    PassSum sum;
    Picture picture;
    std::vector<float> grass;
    double truthError = 0;
    std::optional<Metrics> metrics;
};
struct Comparison {
    Against against = Against::Off;
    CompareShow show = CompareShow::Split;
    ErrorMetric metric = ErrorMetric::Appearance;
    float split = 0.5f;  // where the line is, as a share of the viewport's width
    bool gripHovered = false;
    std::string technique;               // what Against::Technique shows: the name of a row of the table
    std::optional<CostSetting> preview;  // what Against::Settings shows

    ComparisonKey key;
    double changed = -1e9;  // seconds: since when the key stands
    // Made for the key alone.
    Picture own, other;        // at the comparison's size
    std::vector<float> grass;  // weights of the scores; empty: all pixels
    PassSum sum;
    double truthError = 0;
    std::optional<Metrics> metrics;
    Texture picture, heat;         // shown; no picture: nothing to show yet
    std::vector<Texture> retired;  // that this frame's widgets may still show; gone in the next
    bool topFirst = false;         // the picture's first row is its top
    int strips = 0;                // of a technique's picture, drawn so far
    bool heatDue = false;
    Job<ComparedPass> job;
    // Kept while only the camera moves.
    std::shared_ptr<const ReferenceScene> scene;
    std::shared_ptr<Project> copy;  // a snapshot, with the technique or settings that are shown
    uint64_t copyRevision = ~uint64_t(0);
    std::unique_ptr<Renderer> renderer;  // of a technique
};
// Another choice drops what was made for the last one; Off all of it. `now`: seconds, as frames count them.
void compareWith(Comparison& c, double now, Against against, const std::string& technique = {});
// Techniques by which the project can be drawn: those of the table, and those of forests where it has one.
std::vector<std::string> comparedTechniques(const Project& project, const Tables& tables);
// What a person may compare with: "off", "reference", each technique, and "preview" where there is one.
std::vector<std::string> comparisonNames(const Comparison& c, std::span<const std::string> techniques);
// The place of what is compared with among them, and the choice of another by its place.
int comparisonChosen(const Comparison& c, std::span<const std::string> techniques);
void chooseComparison(Comparison& c, double now, std::span<const std::string> techniques, int chosen);
// Compares with the project under these settings, which it does not take on.
void previewSettings(Comparison& c, double now, const CostSetting& setting);
// The measure that the map of errors shows.
void chooseMetric(Comparison& c, ErrorMetric metric);
// What of the view is compared.
struct ComparedView {
    ViewCamera camera;
    int width = 0, height = 0;  // of the viewport's picture
    bool rests = false;         // that picture is whole, and neither the view nor what it shows changes
};
// `making`: the renderer still makes things beside that will show.
ComparedView comparedView(const FlyCamera& camera, const ViewportPicture& picture, const ViewportHand& hand,
                          const FrameClock& clock, bool making);
// What a comparison is made with.
struct CompareParts {
    Document& doc;
    Gpu& gpu;
    Renderer& renderer;  // the viewport's
    FrameClock& clock;
    Messages& messages;
};
// Once a frame, after the viewport's picture: starts, takes in, or drops what is due. Never waits, but for headless
// screenshots. What fails is shown and ends the comparison.
void followComparison(Comparison& c, const CompareParts& parts, const ComparedView& view);
// With all its memory at once: no frame is being built.
void endComparison(Comparison& c);
// There is more to come though nothing moves.
bool comparing(const Comparison& c, const Document& document, const FrameClock& clock);
// "reference, 24 samples"
std::string comparisonLabel(const Comparison& c, const Document& document, const FrameClock& clock);
// Of the project's first field; "" without one.
std::string techniqueShown(const Document& document);

// --- the project's own plot, measured by `sward cost` beside the editor
struct Sweep : SideRun {
    std::optional<CostRun> run;  // while it runs: the rows that are drawn, by their first frames
    uint64_t revision = 0;       // of the document that was measured, as it was then
};
// --- settings for a budget, by `sward fit`
struct FitShown {
    bool fits = false;
    double budget = 0, ms = 0, appearance = 0, shippedMs = 0, shippedAppearance = 0;
    std::string technique, settings,
        better,   // the next better one that does not fit, described; "": none was seen
        outcome;  // of the search against the shipped settings and the grid, from cameras that it did not see; in words
    std::string error;
    bool cutShort = false;  // the best so far: the search was not at its end
};
struct Fit : SideRun {
    float budget = 16;               // ms
    float minutes = 2;               // that it may search
    bool forests = false;            // turns those of a project that has grass, too
    std::optional<FitShown> result;  // the best so far, while it runs
};

struct Accuracy {
    std::string program = "/proc/self/exe";  // that measures: this one
    Comparison comparison;
    Sweep sweep;
    Fit fit;
};

// Starts on a copy of the project as it is now, from the view that is shown; what was measured before is reused. Shows
// why if it cannot: no project, or it runs already.
void startSweep(Sweep& sweep, const MeasureParts& parts);
// The same for a fit to its budget.
void startFit(Fit& fit, const MeasureParts& parts);
// Once a frame: takes in what has ended, and says so.
void followRuns(Accuracy& accuracy, FrameClock& clock, Messages& messages);
// A sweep or a fit runs.
bool measuring(const Accuracy& accuracy);
// Kills it and drops its copy; what it has measured so far is kept and reused by the next.
void stopSweep(Sweep& sweep);
// The same for a fit; the best so far stays, to be previewed or adopted.
void stopFit(Fit& fit);
// Both.
void stopRuns(Accuracy& accuracy);
// Rows of a camera that a sweep in this folder has drawn so far, each with the median of its frames so far.
std::vector<CostRow> rowsSoFar(const std::filesystem::path& work, const std::string& camera);
// The project's camera that is shown; else a name for the view, another one for another view.
std::string accuracyCamera(const Document& document, const FlyCamera& view);
// What adopting says: "adopted: flat" or "adopted: hybrid, maxGeom 6; 4 samples stay as they are". `left`: settings of
// the view, which the project does not take.
std::string adoptedText(const CostSetting& setting, std::span<const std::string> left);

// "maxGeom=6 msaa=4" of a technique.
CostSetting settingOf(const std::string& technique, const std::string& text);
// Whether the project is drawn by it, with the view as the editor's: 4 samples, all detail.
bool isPresent(const Document& document, const CostSetting& setting);
// Sets each field of grass in one undo step. Settings of the view (msaa, detail) are not the project's: returns those.
Result<std::vector<std::string>> adoptSettings(Document& document, const CostSetting& setting);
// What `sward fit --json` printed. Unsound if it is no JSON or holds no result.
Result<FitShown> fitFrom(const std::string& json);

}  // namespace sward
