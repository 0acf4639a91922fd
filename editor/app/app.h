// The editor: one document, one renderer, and the panels between them and the person.
// The same code runs in a window and headless (ui/surface.h); scripts drive it through ui/driver.h.
// Does not: change the project but through Document. One ImGui context each; several may live one after the other.
#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "accuracy/accuracy.h"
#include "app/layout.h"
#include "app/play_control.h"
#include "app/resolution.h"
#include "core/log.h"
#include "frame/renderer.h"
#include "model/autosave.h"
#include "model/bakes.h"
#include "model/document.h"
#include "tools/brush_book.h"
#include "tools/brush_cost.h"
#include "tools/camera_control.h"
#include "tools/tier_view.h"
#include "ui/surface.h"
#include "ui/widgets.h"
#include "world/view_camera.h"

struct ImGuiContext;

namespace sward {

// What the left, right or middle button is doing in the viewport since it went down there.
enum class Gesture { None, Look, Orbit, Pan, Paint, Ring, Split };

struct Viewport {
    FlyCamera camera;
    float pathSecond = 0;  // where the inspector last moved it along a path
    ViewMode mode = ViewMode::Final;
    Rect rect;  // window coordinates
    bool hovered = false;
    std::optional<glm::dvec3> ground;  // under the pointer
    Gesture gesture = Gesture::None;
    bool flying = false;            // keys move the camera in this frame
    double lastX = -1, lastY = -1;  // pointer at the last step of the gesture
    Resolution resolution;
    double lastMs = 0;           // of the last drawing, all its parts together
    FrameStats stats;            // of the same
    double bladesVirtual = 0;    // the population, counted at rest
    uint64_t bladesVisible = 0;  // counted at rest while measuring
    uint64_t populationRevision = ~uint64_t(0), countedRevision = ~uint64_t(0);
    unsigned picture = 0, pictureTarget = 0, pictureSource = 0;  // GL texture on the screen, and how it is written
    int pictureWidth = 0, pictureHeight = 0;
    int skipped = 0;  // frames that showed an old image because input was waiting
    // What the image on the screen shows.
    uint64_t drawnRevision = ~uint64_t(0);
    ViewCamera drawnCamera;
    ViewSettings drawnSettings;
    bool hasImage = false;
};

struct LogLine {
    LogLevel level;
    std::string text;
};
// Lines come from any thread.
struct LogBook {
    std::mutex mutex;
    std::deque<LogLine> fresh;  // not yet seen by a frame
    std::deque<LogLine> lines;  // the last thousand; frames only
    int sink = 0;
};

enum class FileTask { None, Open, SaveAs, New };
struct FileDialog {
    FileTask task = FileTask::None;
    bool opening = false;          // ImGui's popup is to be opened in this frame
    std::filesystem::path folder;  // whose folders are listed
    std::string path;              // what is typed
    std::string error;
    std::vector<std::pair<std::string, bool>> entries;  // name, is a project
};
// What waits for the answer to "save, discard or cancel".
struct UnsavedDialog {
    std::function<void()> then;  // empty: not asked
    bool opening = false;
    std::string error;
};

struct EditorApp {
    // `keepLayout`: read and write the person's layout file. The document and the GPU must outlive the editor.
    EditorApp(Document& document, Gpu& gpu, std::unique_ptr<ui::Surface> surface, bool keepLayout);
    ~EditorApp();
    EditorApp(const EditorApp&) = delete;
    EditorApp& operator=(const EditorApp&) = delete;

    Document& doc;
    Gpu& gpu;
    std::unique_ptr<ui::Surface> surface;
    std::unique_ptr<Renderer> renderer;
    ImGuiContext* imgui = nullptr;

    InputQueue queue;
    FrameInput in;  // of the frame being built
    ui::WidgetBook book;
    Layout layout;
    Areas areas;
    bool keepLayout = false;

    Viewport viewport;
    BrushBook brushes;
    BrushCost brushCost;
    int brushBarRows = 1;  // that the brush bar's widgets took in the last frame
    TierView tierView;
    PlayControl play;
    std::string selected;   // entity, by name
    std::string newEntity;  // being typed in the outliner
    bool measure = false;   // the profiler's
    LogBook log;
    std::string consoleLine;
    std::vector<std::string> consoleHistory;
    std::string notice;      // the red bar over the viewport; empty: none
    std::string drawNotice;  // what the last drawing raised there, while it fails; empty: it did not fail
    std::string status;      // last message
    FileDialog files;
    UnsavedDialog unsaved;
    Autosave autosave;
    Accuracy accuracy;
    std::optional<OcclusionBake> occlusion;  // being baked
    std::vector<JobNews> making;             // what the renderer makes beside, as of the last frame
    std::string holding;                     // path whose slider holds an undo group

    std::function<Status(const std::string&)> runLua;  // the console's line; empty: the console only shows
    std::deque<std::string> luaLines;             // entered, run before the next frame: they may run frames themselves
    std::vector<std::function<void()>> deferred;  // edits, run once the widgets of this frame are built
    bool quit = false;
    bool refineNow = false;  // screenshots: draw in full though something moves
    std::string shownTitle;
    std::filesystem::path shownProject;  // whose first camera the viewport took
    double now = 0;                      // seconds since the start, as frames count them
    double deltaSeconds = 1.0 / 60;
    int framesWanted = 3;                             // ImGui needs a few after any event to settle
    std::function<void(ui::Surface&)> beforePresent;  // once, on the next frame (screenshots)
};

// One frame: takes input, builds the widgets, draws, presents. Waits up to `waitSeconds` for input first.
void runFrame(EditorApp& app, double waitSeconds = 0);
// Seconds until the next frame is needed though nothing comes from the person; 0: at once.
double idleSeconds(const EditorApp& app);
// Frames until the person asks to quit.
void runUntilQuit(EditorApp& app);

// Logs the error and raises the red bar over the viewport.
void showError(EditorApp& app, const Error& error);
// For results of edits: shows the error if there is one. True if there was none.
bool accept(EditorApp& app, const Status& status);
void say(EditorApp& app, const std::string& message);  // status bar and console

// --- what menus and keys do
void requestQuit(EditorApp& app);                 // asks first if there is unsaved work
void requestTask(EditorApp& app, FileTask task);  // opens the file dialog; Open and New ask first
bool saveNow(EditorApp& app);  // asks where if the project was never saved; false then, or on an error
// After the document holds another project: its first camera, its first paintable map, nothing selected.
void adoptProject(EditorApp& app);
// Moves the view to a camera of the project. False if there is none of this name.
bool goToCamera(EditorApp& app, const std::string& name);

}  // namespace sward
