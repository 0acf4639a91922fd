// The panels, one row each; a panel is a file of its own beside this one.
// A panel gets the parts of the editor that it reads or changes and no more; its row hands them out (panel_rows.cpp).
// Does not: keep state; that is in those parts.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/layout.h"
#include "frame/renderer.h"

namespace sward {

class Document;
struct Accuracy;
struct Autosave;
struct BackgroundWork;
struct Bindings;
struct BrushBook;
struct BrushCost;
struct Command;
struct CommandState;
struct Console;
struct EditorApp;
struct EffectRun;
struct Edits;
struct FieldParts;
struct FileDialog;
struct FilmDialog;
struct FrameInput;
struct FrameTimes;
struct ImageDialog;
struct KeysDialog;
struct LayerNote;
struct LayerView;
struct MeasureParts;
struct Messages;
struct ObjectTool;
struct OutsideDialog;
struct Palette;
struct PaletteLine;
struct PictureRun;
struct RenameDialog;
struct SaveParts;
struct Selection;
struct Thumbnails;
struct SpeciesPalette;
struct StrokeTiming;
struct TierView;
struct UnsavedDialog;
struct ViewCounts;
struct ViewState;
struct Waiting;

enum class GizmoMode;
enum class Dock { Menu, BrushBar, Tools, Viewport, Outliner, Inspector, Bottom, StatusBar, Dialog };

struct PanelRow {
    const char* name;  // the first part of its widgets' paths
    Dock dock;
    void (*draw)(EditorApp&);    // hands the panel its parts
    bool hideable;               // listed in the View menu
    const char* menu = nullptr;  // what it is called there, if not by its name
    bool edits = false;          // greyed while the project is played
};
// All rows; panels of the menu bar in the order from left to right, tabs of the bottom likewise.
std::span<const PanelRow> panelRows();
// All of them, each in its area, with the splitters between, in a window of this size; what they take of it is written
// to `areas`. `playing`: panels that edit are greyed. The editor is handed on to the rows.
void drawPanels(EditorApp& app, Layout& layout, Areas& areas, const glm::vec2& size, int brushBarRows, bool playing);

// --- the panels; between ImGui's Begin and End of their areas, but for menus and dialogs, which open their own

// The menus' commands and, in View, view modes and panels. The command that was chosen in this frame, or null.
const Command* drawMenuBar(const Document& document, std::span<const CommandState> states, ViewMode& mode,
                           Layout& layout);
enum class PlayAction { None, Toggle, Pause, Step };
// Start, pause and step, in the middle of the menu bar. What was pressed.
PlayAction drawPlayBar(const Document& document);
// What the brush paints on and how. `yaw` of the view, for directions as they are seen. Returns the rows that it took.
// With the select tool: the steps to which it snaps; with the path tool: what clicks do.
int drawBrushBar(const Rect& area, double yaw, Document& document, BrushBook& brushes, ObjectTool& objects,
                 Edits& edits, Messages& messages, ImageDialog& images, Waiting& waiting);
// Buttons for choosing, moving, turning and scaling objects, and one a brush; choosing one may choose another map.
void drawToolStrip(const Document& document, BrushBook& brushes, GizmoMode& mode, Messages& messages);
// The entities: searched for, chosen, added by a typed name, removed. `menu`: set where a right click asks for the
// context menu.
void drawOutliner(const FieldParts& parts, Selection& selection, bool& menu);
// The components of the entity that is `selected`, the one chosen last; its camera tools move the view.
void drawInspector(const FieldParts& parts, const std::string& selected, ViewState& view);
// The steps that can be undone or done again; a click goes there. `shownSteps`: how many were behind when it was last
// drawn: the list follows.
void drawHistory(Document& document, Selection& selection, Edits& edits, Messages& messages, size_t& shownSteps);
// `inputWaits`: something came in that the next frame takes, so the keyboard's focus stays free.
void drawConsole(Console& console, bool inputWaits);
// The last frames, the passes of the viewport's picture and its blades by species. `measured`: the counts are of a
// measured drawing.
void drawProfiler(ViewCounts& counts, FrameTimes& times, bool measured, const std::string& gpuName);
// The project's objects, to be placed by clicks in the viewport.
void drawAssets(const Document& document, BrushBook& brushes, ObjectTool& objects, Thumbnails& thumbnails,
                Messages& messages);
// The species of a field and presets to add or to dress one in, as pictures. `selected`: the entity chosen last.
void drawSpecies(const FieldParts& parts, SpeciesPalette& palette, BrushBook& brushes, const std::string& selected);
// The layers over the map that the brush paints. `notes`: of those that the last drawing showed.
void drawLayers(const FieldParts& parts, BrushBook& brushes, LayerView& view, const std::vector<LayerNote>& notes);
// What the panel of tiers changes, and for which picture: pixels that a metre is wide in it, one metre away.
struct TierParts {
    const FieldParts& edit;
    float pixelsPerMetre;
};
// The distances of a hybrid field, how its tiers look and what they cost. `measured`: as in drawProfiler.
void drawTiers(const TierParts& parts, TierView& tiers, const std::string& selected, ViewState& view,
               ViewCounts& counts, bool measured);
// `lastMs`: what the last drawing of the viewport took.
void drawAccuracy(Accuracy& accuracy, const MeasureParts& parts, Edits& edits, double lastMs);
struct PictureParts {
    PictureRun& run;
    Document& doc;
    Gpu& gpu;
    Edits& edits;
    Messages& messages;
};
// The accepted pictures of the project's cameras as tests.
void drawPictures(const PictureParts& parts);
struct EffectParts {
    EffectRun& run;
    const MeasureParts& measure;
    Edits& edits;
    glm::ivec2 size;  // pixels at which the view is measured
    double seconds;   // scene time that it shows
};
// What each effect changes in the view that is shown, what it costs, and how to turn it off.
void drawEffects(const EffectParts& parts);
// `drawnScale`: of the viewport's image, as Resolution has it.
void drawStatusBar(const Document& document, const ViewCounts& counts, double drawnScale, const BrushCost& cost,
                   const StrokeTiming& timing, BackgroundWork& work, const std::string& message);
// `adopt` runs after the document holds another project.
void drawFileDialog(FileDialog& files, Document& document, Edits& edits, Messages& messages, BackgroundWork& work,
                    Thumbnails& thumbnails, const std::function<void()>& adopt);
// Asks for as long as unsaved.then is set; the answer runs it with the edits, or drops it.
void drawUnsavedDialog(UnsavedDialog& unsaved, Document& document, const OutsideDialog& outside, Edits& edits,
                       Waiting& waiting);
// Asks for as long as there are files in it: whose counts, or a copy elsewhere.
void drawOutsideDialog(const SaveParts& parts, UnsavedDialog& unsaved, Edits& edits);
// Asks for as long as there is an entity in it; `renamed` runs when it has its new name.
void drawRenameDialog(RenameDialog& dialog, Document& document, Edits& edits,
                      const std::function<void(const std::string& name)>& renamed);
// The commands of the menu Object, at the pointer, once `opening` was set. The one that was chosen in this frame, or
// null.
const Command* drawContextMenu(std::span<const CommandState> states, const std::string& title, bool& opening);
// While it is open: what was chosen in this frame, if anything.
std::optional<PaletteLine> drawPalette(Palette& palette, std::span<const CommandState> states,
                                       const std::vector<std::string>& entities, const FrameInput& in);
// While it is open: all keys, and others for commands. True if a command's keys changed.
bool drawKeysDialog(KeysDialog& dialog, Bindings& bindings, const FrameInput& in);
// While it is open: asks for a screenshot or a film. True where it was asked to start, with the plan as typed.
bool drawFilmDialog(FilmDialog& dialog, const Document& document);
// True while it waits for the editor's first frames, which must then come.
bool drawRecoveryDialog(Autosave& autosave, Document& document, Edits& edits, Messages& messages, Waiting& waiting);
// What the person waits for: how far it is, and a button that cancels it.
void drawWaiting(Waiting& waiting);

// 627 M, 12.3 k
std::string counted(uint64_t n);

// Heights and widths of what does not follow from the layout, at the present font.
float brushBarHeight(int rows);
// One line of text and a margin.
float statusBarHeight();
// One button and a margin.
float toolStripWidth();

}  // namespace sward
