#include "app/commands.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "app/add_actions.h"
#include "app/app.h"
#include "app/path_actions.h"
#include "app/step_actions.h"
#include "model/antialias_edit.h"
#include "model/blade_height.h"
#include "model/float_heights.h"
#include "model/path_ground.h"
#include "model/whole_map.h"
#include "panels/map_windows.h"
#include "panels/viewport_objects.h"
#include "panels/viewport_path.h"
#include "scene/scatter.h"
#include "tools/brush_target.h"
#include "ui/keys.h"

namespace sward {
namespace {

void focusGround(FlyCamera& camera, const std::optional<glm::dvec3>& ground, float brushRadius) {
    if (!ground) return;
    const double distance = glm::length(*ground - camera.eye);
    focus(camera, *ground, std::min(distance, std::max(3.0, 4.0 * static_cast<double>(brushRadius))));
}

void shiftErases(BrushBook& brushes, Messages& messages) {
    brushes.shiftErases = !brushes.shiftErases;
    say(messages, brushes.shiftErases ? "Shift erases while painting" : "Shift smooths while painting");
}

void timeStrokes(StrokeTiming& timing, Messages& messages) {
    dropTiming(timing);
    timing.on = !timing.on;
    say(messages, timing.on ? "strokes are timed once all rests" : "strokes are not timed");
}

// On another thread, with a message in the end.
void editAndSay(Document& doc, Waiting& waiting, Messages& messages, const std::string& label, const std::string& done,
                WaitedEdit edit) {
    editBeside(waiting, doc, label, std::move(edit), [&messages, done](const Status& ended) {
        if (accept(messages, ended)) say(messages, done);
    });
}

void bakeOcclusion(Document& doc, std::optional<OcclusionBake>& bake, Messages& messages) {
    Result<OcclusionBake> started = startOcclusion(doc, {});
    if (!started) return showError(messages, started.error());
    bake = std::move(*started);
    say(messages, "baking ambient occlusion");
}

// Of the density that is painted, else of the first one.
void makeBladeHeight(Document& doc, Waiting& waiting, const std::string& painted, Messages& messages) {
    std::string density;
    for (const ConstFieldRef& map : allMaps(doc.project(), doc.tables().components))
        if (map.row->map->role == MapRole::Density && (density.empty() || map.path == painted)) density = map.path;
    if (density.empty()) return say(messages, "Height from Density: no species has a density map");
    editAndSay(doc, waiting, messages, "Height from density", "blades are lower towards the edges of " + density,
               [density](Document& d, JobControl&) { return heightFromDensity(d, density); });
}

// What is done to the whole of the map that the brush paints.
void wholeMap(EditorApp& app, const char* doing, const char* done, Status (*change)(Document&, const BrushSettings&)) {
    BrushSettings brush = currentBrush(app.brushes);
    brush.map = app.brushes.map;
    brush.color = currentColor(app.brushes);
    editAndSay(app.doc, app.background.waiting, app.messages, doing + brush.map,
               fmt::format("{} is {}", brush.map, done),
               [brush, change](Document& d, JobControl&) { return change(d, brush); });
}

// --- adapters of the table's rows: each hands the parts of the editor out that its command uses

template <FileTask Task>
void task(EditorApp& app) {
    requestTask(app.files, app.unsaved, app.doc, Task);
}
template <int Steps>
void size(EditorApp& app) {
    growBrush(currentBrush(app.brushes), Steps);
}
template <int Steps>
void strength(EditorApp& app) {
    strengthenBrush(currentBrush(app.brushes), Steps);
}
void play(EditorApp& app) { togglePlay(playParts(app), app.view.camera, app.hand, app.edits, ui::typing(app.book)); }
void lookOnly(EditorApp& app) { toggleLook(app.doc, app.brushes, app.messages); }
void pick(EditorApp& app) { pickFromGround(app.doc, app.brushes, app.messages, app.hand.ground); }
void flattenPath(EditorApp& app) {
    const std::string entity = pathMeant(app.doc, app.selection);
    editAndSay(app.doc, app.background.waiting, app.messages, "Flattening along " + entity, "level across " + entity,
               [entity](Document& d, JobControl&) { return flattenAlong(d, entity); });
}
// With the path tool the point that is chosen, else what is chosen.
void remove(EditorApp& app) {
    if (!removePathPoint(objectParts(app))) removeChosen(app.doc, app.selection, app.messages);
}
void walk(EditorApp& app) {
    walkPath(playParts(app), app.selection, app.view.camera, app.hand, app.edits, ui::typing(app.book));
}
// A little to the right of the originals, as the view has it.
glm::dvec3 besideChosen(EditorApp& app) {
    const std::optional<Extent> extent = extentOf(objectParts(app));
    const double metres = extent ? std::clamp(2 * extent->radius, 0.3, 2.0) : 0;
    const double yaw = app.view.camera.yaw;
    return {metres * std::cos(yaw), 0, metres * std::sin(yaw)};
}
void duplicate(EditorApp& app) { duplicateChosen(app.doc, app.selection, app.messages, besideChosen(app)); }
// The tab with the objects to place, which also comes back if it was closed.
void chooseObject(EditorApp& app) {
    app.layout.hidden.erase("Objects");
    app.layout.tab = "Objects";
}
template <GizmoMode Mode>
void takeMode(EditorApp& app) {
    selectTool(app.doc, app.brushes, app.messages, kViewTool);
    app.objects.mode = Mode;
}
// What was to be placed is laid down.
void takePath(EditorApp& app) {
    takeMode<GizmoMode::Path>(app);
    app.objects.placing.clear();
}
void newPath(EditorApp& app) {
    takePath(app);
    beginPath(objectParts(app));
}
template <GizmoMode Mode>
bool inMode(EditorApp& app) {
    return app.brushes.tool == kViewTool && app.objects.mode == Mode;
}

void fill(EditorApp& app) { wholeMap(app, "Filling ", "filled", fillMap); }
void clear(EditorApp& app) {
    wholeMap(app, "Clearing ", "cleared", [](Document& d, const BrushSettings& b) { return clearMap(d, b.map); });
}
void invert(EditorApp& app) {
    wholeMap(app, "Inverting ", "inverted", [](Document& d, const BrushSettings& b) { return invertMap(d, b.map); });
}
void floatHeights(EditorApp& app) {
    editAndSay(app.doc, app.background.waiting, app.messages, "Heights as floats",
               "heights are floats in metres, without a range",
               [](Document& d, JobControl&) { return heightsAsFloats(d); });
}
void bladeHeight(EditorApp& app) { makeBladeHeight(app.doc, app.background.waiting, app.brushes.map, app.messages); }
void pond(EditorApp& app) {
    addPond(app.doc, app.background.waiting, viewOf(app.view.camera), app.selection, app.messages);
}

void save(EditorApp& app) { saveNow({app.doc, app.files, app.outside, app.messages, app.background.waiting}); }
void importMapImage(EditorApp& app) { requestImage(app.images, app.doc, ImageTask::Map, app.brushes.map); }
// The camera chosen last, else the one whose view is shown or the first.
std::string cameraMeant(EditorApp& app) {
    if (!app.doc.isOpen()) return {};
    const std::string chosen = shownEntity(app.selection);
    const Entity e = findEntity(app.doc.project(), chosen);
    const bool isCamera = e != kNoEntity && app.doc.project().registry.get<Camera>(e);
    return isCamera ? chosen : accuracyCamera(app.doc, app.view.camera);
}
void acceptPictureOf(EditorApp& app) { acceptNow(app.pictureRun, app.doc, app.gpu, app.messages, cameraMeant(app)); }
void checkPictures(EditorApp& app) {
    app.layout.hidden.erase("Pictures");
    app.layout.tab = "Pictures";
    startPictures(app.pictureRun, app.doc, app.messages);
}

void startRecording(EditorApp& app) {
    if (accept(app.messages, app.recorder.start(app.doc))) say(app.messages, "recording what is edited from here on");
}
// The dialog asks where; the recording goes on until it is written.
void saveRecording(EditorApp& app) {
    app.files.write = [&app](const std::filesystem::path& file) {
        const Status written = writeRecording(app.recorder, file);
        if (written) app.recorder.stop();
        return written;
    };
    requestTask(app.files, app.unsaved, app.doc, FileTask::Recording);
}
void dropRecording(EditorApp& app) {
    app.recorder.stop();
    say(app.messages, "the recording is dropped");
}
bool recording(EditorApp& app) { return app.recorder.recording(); }
bool canRecord(EditorApp& app) { return app.doc.isOpen() && !app.recorder.recording(); }

bool always(EditorApp&) { return true; }
bool opened(EditorApp& app) { return app.doc.isOpen(); }
bool atRest(EditorApp& app) { return !app.doc.stroking() && app.edits.holding.empty(); }
void samplesOverTime(EditorApp& app) {
    const bool temporal = temporalOf(app.doc.project()) != nullptr;
    if (accept(app.messages, chooseAntialias(app.doc, temporal ? Antialiasing::Msaa : Antialiasing::Temporal)))
        say(app.messages, temporal ? "each frame takes all samples" : "frames add up, one sample a pixel each");
}

bool canUndo(EditorApp& app) { return app.doc.canUndo() && atRest(app); }
bool canRedo(EditorApp& app) { return app.doc.canRedo() && atRest(app); }
bool hasMap(EditorApp& app) { return app.doc.isOpen() && !app.brushes.map.empty() && atRest(app); }
bool hasPath(EditorApp& app) { return !pathMeant(app.doc, app.selection).empty(); }
bool pathChosen(EditorApp& app) { return atRest(app) && !pathInHand(objectParts(app)).empty(); }
bool drawsPath(EditorApp& app) { return atRest(app) && inMode<GizmoMode::Path>(app); }
bool anyChosen(EditorApp& app) { return app.doc.isOpen() && !app.selection.entities.empty() && atRest(app); }
bool scatterChosenLast(EditorApp& app) {
    const Entity e = anyChosen(app) ? findEntity(app.doc.project(), shownEntity(app.selection)) : kNoEntity;
    return e != kNoEntity && app.doc.project().registry.get<Scatter>(e);
}
bool canExport(EditorApp& app) { return app.doc.isOpen() && !app.background.exporting; }
bool canFilm(EditorApp& app) { return app.doc.isOpen() && !app.background.film; }
bool hasCamera(EditorApp& app) { return atRest(app) && !cameraMeant(app).empty(); }
bool canBake(EditorApp& app) { return app.doc.isOpen() && !app.background.occlusion && app.edits.holding.empty(); }

using App = EditorApp;
constexpr Command kCommands[] = {
    {"File", "New...", "ctrl+n", "", task<FileTask::New>, always},
    {"File", "Open...", "ctrl+o", "", task<FileTask::Open>, always},
    {"File", "Save", "ctrl+s", "", save, opened},
    {"File", "Save As...", "ctrl+shift+s", "", task<FileTask::SaveAs>, opened},
    {"File", "Export...", "", "", task<FileTask::Export>, canExport},
    {"File", "Screenshot...", "", "", [](App& a) { askFilm(a.film, a.doc, false); }, canFilm},
    {"File", "Film...", "", "", [](App& a) { askFilm(a.film, a.doc, true); }, canFilm},
    {"File", "Quit", "ctrl+q", "", requestQuit, always, true, nullptr, true},
    {"Edit", "Undo", "ctrl+z", "", [](App& a) { undoStep(a.doc, a.selection, a.messages); }, canUndo},
    {"Edit", "Redo", "ctrl+y", "ctrl+shift+z", [](App& a) { redoStep(a.doc, a.selection, a.messages); }, canRedo},
    {"Edit", "Start Recording", "", "", startRecording, canRecord, true, recording},
    {"Edit", "Stop and Save Recording...", "", "", saveRecording, recording},
    {"Edit", "Drop Recording", "", "", dropRecording, recording},
    {"Edit", "Heights as Floats", "", "", floatHeights, opened},
    {"Object", "Duplicate", "ctrl+d", "", duplicate, anyChosen},
    {"Object", "Rename...", "f2", "", [](App& a) { askName(a.rename, a.selection); }, anyChosen},
    {"Object", "Delete", "delete", "", remove, anyChosen},
    {"Object", "Hide or Show", "h", "", [](App& a) { hideChosen(a.doc, a.selection, a.messages); }, anyChosen},
    {"Object", "Show All", "shift+h", "", [](App& a) { showAll(a.doc, a.messages); }, opened},
    {"Object", "Lock or Unlock", "l", "", [](App& a) { lockChosen(a.doc, a.selection, a.messages); }, anyChosen},
    {"Object", "Unlock All", "shift+l", "", [](App& a) { unlockAll(a.doc, a.messages); }, opened},
    {"Object", "Add Scatter", "", "", [](App& a) { scatterChosen(a.doc, a.selection, a.messages); }, opened},
    {"Object", "Make Objects of It", "", "", [](App& a) { makeObjectsOfChosen(a.doc, a.selection, a.messages); },
     scatterChosenLast},
    {"Object", "Put into Folder", "ctrl+g", "", [](App& a) { folderChosen(a.doc, a.selection, a.messages); },
     anyChosen},
    {"Object", "Out of Folder", "ctrl+shift+g", "", [](App& a) { unfolderChosen(a.doc, a.selection, a.messages); },
     anyChosen},
    {"Object", "Objects or Brush", "v", "", lookOnly, opened},
    {"Object", "Move", "w", "", takeMode<GizmoMode::Move>, opened, true, inMode<GizmoMode::Move>},
    {"Object", "Turn", "e", "", takeMode<GizmoMode::Turn>, opened, true, inMode<GizmoMode::Turn>},
    {"Object", "Scale", "r", "", takeMode<GizmoMode::Scale>, opened, true, inMode<GizmoMode::Scale>},
    {"Object", "Path", "p", "", takePath, opened, true, inMode<GizmoMode::Path>},
    {"Object", "New Path", "shift+p", "", newPath, opened},
    {"Object", "End Path", "enter", "escape", [](App& a) { endPath(objectParts(a)); }, drawsPath},
    {"Object", "Flatten Along Path", "", "", flattenPath, pathChosen},
    {"Object", "Camera Path from Path", "", "", [](App& a) { cameraFromPath(a.doc, a.selection, a.messages); },
     pathChosen},
    {"Add", "Object", "", "", chooseObject, opened},
    {"Add", "Path on the Ground", "", "", newPath, opened},
    {"Add", "Lamp", "", "", [](App& a) { addLamp(a.doc, viewOf(a.view.camera), a.selection, a.messages); }, opened},
    {"Add", "Camera", "", "", [](App& a) { addCamera(a.doc, viewOf(a.view.camera), a.selection, a.messages); }, opened},
    {"Add", "Pond", "", "", pond, opened},
    {"Add", "Flowers", "", "", [](App& a) { addFlowers(a.doc, a.selection, a.brushes, a.messages); }, opened},
    {"Add", "Forest", "", "", [](App& a) { addForest(a.doc, a.selection, a.brushes, a.messages); }, opened},
    {"Brush", "Larger", "]", "", size<1>, opened},
    {"Brush", "Smaller", "[", "", size<-1>, opened},
    {"Brush", "Stronger", "=", "", strength<1>, opened},
    {"Brush", "Weaker", "-", "", strength<-1>, opened},
    {"Brush", "Map Overlay", "o", "", [](App& a) { toggleOverlay(a.doc, a.brushes); }, opened, true,
     [](App& a) { return overlayShown(a.doc, a.brushes); }},
    {"Brush", "Pick Under Pointer", "i", "", pick, opened, false},
    {"Brush", "Fill Map", "", "", fill, hasMap},
    {"Brush", "Clear Map", "", "", clear, hasMap},
    {"Brush", "Invert Map", "", "", invert, hasMap},
    {"Brush", "Shift Erases", "", "", [](App& a) { shiftErases(a.brushes, a.messages); }, always, true,
     [](App& a) { return a.brushes.shiftErases; }},
    {"Brush", "Time Strokes", "", "", [](App& a) { timeStrokes(a.strokeTiming, a.messages); }, always, true,
     [](App& a) { return a.strokeTiming.on; }},
    {"Maps", "Import Image...", "", "", importMapImage, hasMap},
    {"Maps", "Place Heights...", "", "", [](App& a) { requestImage(a.images, a.doc, ImageTask::Heights); }, opened},
    {"Maps", "Check Maps", "", "", [](App& a) { checkMaps(a.mapHealth, a.doc, a.background.waiting); }, opened},
    {"Play", "Start or Stop", "f5", "", play, opened, true, [](App& a) { return playing(a.doc); }, true},
    {"Play", "Pause", "f6", "", [](App& a) { togglePause(playParts(a)); }, opened, true, nullptr, true},
    {"Play", "One Step", "f11", "", [](App& a) { stepOnce(playParts(a)); }, opened, true, nullptr, true},
    {"Play", "Walk Along Path", "", "", walk, hasPath, true, nullptr, true},
    {"Bake", "Ambient Occlusion", "", "", [](App& a) { bakeOcclusion(a.doc, a.background.occlusion, a.messages); },
     canBake},
    {"Bake", "Height from Density", "", "", bladeHeight, opened},
    {"Test", "Accept Picture of This Camera", "", "", acceptPictureOf, hasCamera},
    {"Test", "Check Pictures", "", "", checkPictures, opened},
    {"View", "Focus", "f", "", focusChosen, opened},
    {"View", "Samples over Time", "", "", samplesOverTime, opened, true,
     [](App& a) { return a.doc.isOpen() && temporalOf(a.doc.project()) != nullptr; }},
    {"View", "Command Palette...", "ctrl+shift+p", "f3", [](App& a) { openPalette(a.palette); }, always},
    {"Help", "Keys...", "f1", "", [](App& a) { openKeys(a.keys); }, always},
};

bool dialogOpen(const EditorApp& a) {
    return a.files.task != FileTask::None || a.unsaved.then || !a.autosave.found.empty() || !a.rename.entity.empty() ||
           a.palette.open || a.keys.open || a.film.open || waits(a.background.waiting) ||
           a.images.task != ImageTask::None || !a.outside.files.empty();
}
// A text line has the keyboard: only what no text line uses goes past it, such as Ctrl+S.
bool hasKeyboard(const ui::WidgetBook& book) { return ImGui::GetIO().WantTextInput || !book.editing.empty(); }
bool goesPastText(const Command& c) { return std::string(c.menu) == "File" || std::string(c.menu) == "Play"; }

// Letters walk while the mouse is captured; what else waits for the end of play says so.
void refuseInPlay(const Command& c, const Chord& pressed, bool captured, Messages& messages) {
    if (pressed.ctrl || !captured) say(messages, fmt::format("{}: not while playing; F5 stops", c.label));
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

void focusChosen(EditorApp& app) {
    FlyCamera& camera = app.view.camera;
    const std::optional<Extent> extent = extentOf(objectParts(app));
    if (!extent) return focusGround(camera, app.hand.ground, currentBrush(app.brushes).radius);
    const double half = std::sin(glm::radians(static_cast<double>(camera.fovDeg)) / 2);
    focus(camera, extent->middle, std::max(2.0, 1.3 * extent->radius / half));
}

std::vector<CommandState> commandStates(EditorApp& app) {
    std::vector<CommandState> states;
    for (const Command& c : kCommands)
        states.push_back({&c, chordOf(app.bindings, c), c.enabled(app) && (c.inPlay || !playing(app.doc)),
                          c.checked && c.checked(app)});
    return states;
}

void runShortcuts(EditorApp& app) {
    if (dialogOpen(app)) return;
    for (const int key : app.in.pressedKeys) {
        const Chord pressed{key, app.in.ctrl(), app.in.shift(), app.in.alt()};
        const bool flying = app.hand.gesture == Gesture::Look && !pressed.ctrl;  // letters move the camera then
        for (const Command& c : commands()) {
            if (!runsBy(app.bindings, c, pressed)) continue;
            const bool text = hasKeyboard(app.book);
            if (playing(app.doc) && !c.inPlay && !text) {
                refuseInPlay(c, pressed, app.play.captured, app.messages);
                break;
            }
            if (flying || (text && !goesPastText(c)) || (!c.anywhere && !app.hand.hovered) || !c.enabled(app)) continue;
            c.run(app);
            break;
        }
    }
}

}  // namespace sward
