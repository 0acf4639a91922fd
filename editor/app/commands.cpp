#include "app/commands.h"

#include <imgui.h>

#include "model/blade_height.h"
#include "tools/brush_target.h"
#include "ui/keys.h"

namespace sward {
namespace {

bool always(EditorApp&) { return true; }
bool opened(EditorApp& app) { return app.doc.isOpen(); }
bool canUndo(EditorApp& app) { return app.doc.canUndo() && !app.doc.stroking() && app.holding.empty(); }
bool canRedo(EditorApp& app) { return app.doc.canRedo() && !app.doc.stroking() && app.holding.empty(); }

void undo(EditorApp& app) {
    const std::string label = app.doc.undoLabel();
    if (app.doc.undo()) say(app, "undone: " + label);
}
void redo(EditorApp& app) {
    const std::string label = app.doc.redoLabel();
    if (app.doc.redo()) say(app, "done again: " + label);
}
void save(EditorApp& app) { saveNow(app); }
template <FileTask Task>
void task(EditorApp& app) {
    requestTask(app, Task);
}
template <int Steps>
void size(EditorApp& app) {
    growBrush(currentBrush(app.brushes), Steps);
}
template <int Steps>
void strength(EditorApp& app) {
    strengthenBrush(currentBrush(app.brushes), Steps);
}
void focusGround(EditorApp& app) {
    Viewport& v = app.viewport;
    if (!v.ground) return;
    const double distance = glm::length(*v.ground - v.camera.eye);
    focus(v.camera, *v.ground,
          std::min(distance, std::max(3.0, 4.0 * static_cast<double>(currentBrush(app.brushes).radius))));
}

void shiftErases(EditorApp& app) {
    app.brushes.shiftErases = !app.brushes.shiftErases;
    say(app, app.brushes.shiftErases ? "Shift erases while painting" : "Shift smooths while painting");
}

bool played(EditorApp& app) { return playing(app); }

bool canBake(EditorApp& app) { return app.doc.isOpen() && !app.occlusion && app.holding.empty(); }
void bakeOcclusion(EditorApp& app) {
    Result<OcclusionBake> bake = startOcclusion(app.doc, {});
    if (!bake) return showError(app, bake.error());
    app.occlusion = std::move(*bake);
    say(app, "baking ambient occlusion");
}

// Of the density that is painted, else of the first one.
void makeBladeHeight(EditorApp& app) {
    std::string density;
    for (const ConstFieldRef& map : allMaps(app.doc.project(), app.doc.tables().components))
        if (std::string_view(map.row->name) == "density" && (density.empty() || map.path == app.brushes.map))
            density = map.path;
    if (density.empty()) return say(app, "Height from Density: no species has a density map");
    if (Status s = heightFromDensity(app.doc, density); !s) return showError(app, s.error());
    say(app, "blades are lower towards the edges of " + density);
}

constexpr Command kCommands[] = {
    {"File", "New...", "ctrl+n", "", task<FileTask::New>, always},
    {"File", "Open...", "ctrl+o", "", task<FileTask::Open>, always},
    {"File", "Save", "ctrl+s", "", save, opened},
    {"File", "Save As...", "ctrl+shift+s", "", task<FileTask::SaveAs>, opened},
    {"File", "Quit", "ctrl+q", "", requestQuit, always, true, nullptr, true},
    {"Edit", "Undo", "ctrl+z", "", undo, canUndo},
    {"Edit", "Redo", "ctrl+y", "ctrl+shift+z", redo, canRedo},
    {"Brush", "Larger", "]", "", size<1>, opened},
    {"Brush", "Smaller", "[", "", size<-1>, opened},
    {"Brush", "Stronger", "=", "", strength<1>, opened},
    {"Brush", "Weaker", "-", "", strength<-1>, opened},
    {"Brush", "Look Without Painting", "v", "", toggleLook, opened},
    {"Brush", "Map Overlay", "o", "", toggleOverlay, opened, true, overlayShown},
    {"Brush", "Pick Colour Under Pointer", "i", "", pickColor, opened, false},
    {"Brush", "Shift Erases", "", "", shiftErases, always, true,
     [](EditorApp& app) { return app.brushes.shiftErases; }},
    {"Play", "Start or Stop", "f5", "", togglePlay, opened, true, played, true},
    {"Play", "Pause", "f6", "", togglePause, opened, true, nullptr, true},
    {"Play", "One Step", "f11", "", stepOnce, opened, true, nullptr, true},
    {"Bake", "Ambient Occlusion", "", "", bakeOcclusion, canBake},
    {"Bake", "Height from Density", "", "", makeBladeHeight, opened},
    {"View", "Focus Under Pointer", "f", "", focusGround, opened, false},
};

bool matches(const char* chord, const Chord& pressed) {
    const std::optional<Chord> wanted = chord[0] ? parseChord(chord) : std::nullopt;
    return wanted && *wanted == pressed;
}

bool dialogOpen(const EditorApp& app) {
    return app.files.task != FileTask::None || app.unsaved.then || !app.autosave.found.empty();
}
// A text line has the keyboard: only what no text line uses goes past it, such as Ctrl+S.
bool typing(const EditorApp& app) { return ImGui::GetIO().WantTextInput || !app.book.editing.empty(); }
bool goesPastText(const Command& c) { return std::string(c.menu) == "File" || std::string(c.menu) == "Play"; }

// Letters walk while the mouse is captured; what else waits for the end of play says so.
void refuseInPlay(EditorApp& app, const Command& c, const Chord& pressed) {
    if (pressed.ctrl || !app.play.captured) say(app, fmt::format("{}: not while playing; F5 stops", c.label));
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

void runShortcuts(EditorApp& app) {
    if (dialogOpen(app)) return;
    for (const int key : app.in.pressedKeys) {
        const Chord pressed{key, app.in.ctrl(), app.in.shift(), app.in.alt()};
        const bool flying = app.viewport.gesture == Gesture::Look && !pressed.ctrl;  // letters move the camera then
        for (const Command& c : commands()) {
            if (!matches(c.chord, pressed) && !matches(c.chord2, pressed)) continue;
            if (playing(app) && !c.inPlay && !typing(app)) {
                refuseInPlay(app, c, pressed);
                break;
            }
            if (flying || (typing(app) && !goesPastText(c)) || (!c.anywhere && !app.viewport.hovered) ||
                !c.enabled(app))
                continue;
            c.run(app);
            break;
        }
    }
}

}  // namespace sward
