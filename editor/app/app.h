// The editor: one document, one renderer, and the parts that panels and tools read and change.
// The same code runs in a window and headless (ui/surface.h); scripts drive it through ui/driver.h.
// Each panel and tool gets the parts that it uses (panels/panels.h); the whole is known to the frame loop, to the
// tables of panels and commands, which hand the parts out, and to the driver. Does not: change the project but through
// Document. One ImGui context each; several may live one after the other.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/accuracy.h"
#include "app/background_work.h"
#include "app/bindings.h"
#include "app/console.h"
#include "app/edits.h"
#include "app/effect_run.h"
#include "app/file_tasks.h"
#include "app/film_dialog.h"
#include "app/frame_clock.h"
#include "app/frame_times.h"
#include "app/hardcase_run.h"
#include "app/height_placing.h"
#include "app/image_tasks.h"
#include "app/layout.h"
#include "app/map_health_view.h"
#include "app/messages.h"
#include "app/object_actions.h"
#include "app/palette.h"
#include "app/picture_run.h"
#include "app/play_control.h"
#include "app/selection.h"
#include "app/start.h"
#include "app/stroke_timing.h"
#include "app/thumbnails.h"
#include "app/transition_run.h"
#include "app/viewport.h"
#include "frame/renderer.h"
#include "model/autosave.h"
#include "model/document.h"
#include "model/recorder.h"
#include "tools/brush_book.h"
#include "tools/brush_cost.h"
#include "tools/layer_view.h"
#include "tools/object_tool.h"
#include "tools/species_palette.h"
#include "tools/tier_view.h"
#include "ui/surface.h"
#include "ui/widgets.h"

struct ImGuiContext;

namespace sward {

struct ObjectParts;

struct EditorApp {
    // `keepLayout`: read and write the person's layout file. The document and the GPU must outlive the editor.
    EditorApp(Document& document, Gpu& gpu, std::unique_ptr<ui::Surface> surface, bool keepLayout);
    ~EditorApp();
    EditorApp(const EditorApp&) = delete;
    EditorApp& operator=(const EditorApp&) = delete;

    // --- what it stands on
    Document& doc;
    Gpu& gpu;
    std::unique_ptr<ui::Surface> surface;
    std::unique_ptr<Renderer> renderer;
    ImGuiContext* imgui = nullptr;

    // --- what comes in, and the widgets of a frame
    InputQueue queue;
    FrameInput in;  // of the frame being built
    FrameClock clock;
    FrameTimes frameTimes;
    double pictureMs = 0;  // of the frame being built: the viewport's picture
    ui::WidgetBook book;
    Layout layout;
    Areas areas;
    int brushBarRows = 1;  // that the brush bar's widgets took in the last frame

    // --- the viewport
    ViewState view;
    ViewportHand hand;
    ViewportPicture picture;
    ViewCounts counts;

    // --- tools
    BrushBook brushes;
    BrushCost brushCost;
    StrokeTiming strokeTiming;
    TierView tierView;
    LayerView layerView;
    SpeciesPalette speciesPalette;
    Selection selection;
    ObjectTool objects;
    Edits edits;
    PlayControl play;
    Accuracy accuracy;
    PictureRun pictureRun;
    HardCaseRun hardCases;
    TransitionMeter transitions;
    EffectRun effects;
    Recorder recorder;
    size_t historyShown = 0;  // steps behind when the history was last drawn
    BackgroundWork background;
    Thumbnails thumbnails;
    Autosave autosave;

    // --- what is said and asked
    Messages messages;
    Console console;
    FileDialog files;
    ImageDialog images;
    HeightPlacing placing;
    MapHealthView mapHealth;
    StartScreen start;
    UnsavedDialog unsaved;
    OutsideDialog outside;
    RenameDialog rename;
    Palette palette;
    KeysDialog keys;
    FilmDialog film;
    Bindings bindings;

    // --- the program
    bool keepLayout = false;
    bool quit = false;
    std::string shownTitle;
    std::filesystem::path shownProject;                     // whose first camera the viewport took
    std::function<void(ui::Surface&)> beforePresent;        // once, on the next frame (screenshots)
    std::function<void(const ui::WidgetBook&)> afterFrame;  // each, once it is on the screen; empty: nobody asks
};

// One frame: takes input, builds the widgets, draws, presents. Waits up to `waitSeconds` for input first.
void runFrame(EditorApp& app, double waitSeconds = 0);
// Seconds until the next frame is needed though nothing comes from the person; 0: at once.
double idleSeconds(const EditorApp& app);
// Frames until the person asks to quit.
void runUntilQuit(EditorApp& app);

// Stops play, and asks first if there is unsaved work; then runUntilQuit ends.
void requestQuit(EditorApp& app);
// After the document holds another project: its first camera, its first paintable map, its last field selected.
void adoptProject(EditorApp& app);
// The parts that play starts, steps and stops with.
PlayParts playParts(EditorApp& app);
// The parts that objects are chosen and moved with.
ObjectParts objectParts(EditorApp& app);

}  // namespace sward
