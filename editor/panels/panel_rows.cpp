// The table of panels: which there are, where they lie, and which parts of the editor each of them gets.
#include <imgui.h>

#include <algorithm>
#include <chrono>

#include "app/app.h"
#include "app/commands.h"
#include "panels/brush_shape.h"
#include "panels/field_edit.h"
#include "panels/hardcase_gallery.h"
#include "panels/image_dialog.h"
#include "panels/long_frame.h"
#include "panels/map_windows.h"
#include "panels/overlay_legend.h"
#include "panels/panels.h"
#include "panels/play_bar.h"
#include "panels/start.h"
#include "panels/transitions.h"
#include "panels/viewport.h"
#include "panels/viewport_compare.h"
#include "panels/viewport_gizmo.h"
#include "panels/viewport_input.h"
#include "panels/viewport_path.h"
#include "panels/viewport_place.h"
#include "panels/viewport_rings.h"
#include "panels/viewport_scene.h"
#include "panels/viewport_shape.h"
#include "playtest/playtest.h"
#include "tools/brush_target.h"
#include "ui/imgui_compat.h"

namespace sward {
namespace {

FieldParts fieldParts(EditorApp& a) {
    return {a.doc,    a.edits,   a.book.errors, a.messages,           &a.thumbnails,
            &a.files, &a.images, &a.brushes,    &a.background.waiting};
}
MeasureParts measureParts(EditorApp& a) { return {a.doc, a.accuracy.program, a.view.camera, a.clock, a.messages}; }
int shownHeight(const EditorApp& a) { return static_cast<int>(a.hand.rect.h * ui::densityOf(*a.surface)); }
// Of the picture in the viewport, one metre away.
float shownPixelsPerMetre(const EditorApp& a) { return pixelsPerMetre(viewOf(a.view.camera), shownHeight(a)); }
RingParts ringParts(EditorApp& a) {
    const std::string entity = tierEntity(a.doc, a.tierView.field, shownEntity(a.selection));
    const bool shown = a.tierView.rings && openTab(a.layout) == "Tiers" && tierField(a.doc, entity);
    return {a.doc, a.tierView, a.view.camera, a.hand.rect, shownPixelsPerMetre(a), entity, shown};
}

void menuBar(EditorApp& a) {
    if (const Command* c = drawMenuBar(a.doc, commandStates(a), a.view.mode, a.layout))
        a.edits.deferred.push_back([&a, c] { c->run(a); });
}

void playBar(EditorApp& a) {
    switch (drawPlayBar(a.doc)) {
        case PlayAction::Toggle:
            return a.edits.deferred.push_back(
                [&a] { togglePlay(playParts(a), a.view.camera, a.hand, a.edits, ui::typing(a.book)); });
        case PlayAction::Pause:
            return a.edits.deferred.push_back([&a] { togglePause(playParts(a)); });
        case PlayAction::Step:
            return a.edits.deferred.push_back([&a] { stepOnce(playParts(a)); });
        case PlayAction::None:
            return;
    }
}

void brushBar(EditorApp& a) {
    const int rows = drawBrushBar(a.areas.brushBar, a.view.camera.yaw, a.doc, a.brushes, a.objects, a.edits, a.messages,
                                  a.images, a.background.waiting);
    if (a.hand.gesture != Gesture::Paint) a.brushBarRows = rows;  // the ground must not shift under the hand
}

// --- the viewport: input, then the picture, then what lies over it

void letGo(FrameInput& in) {
    in.buttons.reset(), in.pressed.reset(), in.keys.reset();
    in.pressedKeys.clear();
    in.wheelX = in.wheelY = 0;
}

// Under a dialog or a menu the hand lets go of the picture, whatever is still held.
void takeInput(EditorApp& a, const RingParts& rings, bool over) {
    FrameInput in = a.in;
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) letGo(in);
    const HandInput input{in, a.clock.delta, over};
    if (playing(a.doc)) {
        if (playInput(input, a.hand) && a.doc.play()->runs()) captureMouse(a.play, a.doc, *a.surface, true);
        return;
    }
    const ObjectParts objects = objectParts(a);
    viewportInput(input, a.view.camera, a.hand,
                  {{a.doc, a.brushes, a.edits, a.messages}, rings, objects, a.accuracy.comparison});
}

// What the next picture is to show.
ViewSettings wantedSettings(EditorApp& a) {
    ViewSettings s;
    const float dense = ui::densityOf(*a.surface);
    s.width = static_cast<int>(a.hand.rect.w * dense), s.height = shownHeight(a);
    s.mode = a.view.mode;
    s.time = timeShown(a.doc);
    s.measure = a.counts.measure;
    s.background = !a.clock.fixed && !a.clock.refineNow;  // scripts and screenshots wait: the same picture each time
    if (drawsDecal(a.picture, a.clock) && !a.tierView.hover) s.decal = decalOf(a.doc, a.hand, a.brushes);
    s.overlay = overlayOf(a.doc, a.brushes);
    return s;
}

// Where all blades would take too long, the picture gets few of them. Scripts and screenshots wait.
void foreseeLongFrames(EditorApp& a) {
    if (a.clock.fixed || a.clock.refineNow) return;
    const ViewSettings wanted = wantedSettings(a);
    const ViewCamera camera = viewShown(a.doc, a.view.camera);
    Resolution& r = a.picture.resolution;
    const bool atRest = a.clock.now - r.lastChange > kRestSeconds && !a.doc.stroking();
    followLongFrame(a.picture.longFrame,
                    {projectShown(a.doc), a.doc.tables(), a.doc.revision(), camera, wanted.width, wanted.height},
                    atRest);
    limitDetail(r, shareOfBlades(a.picture.longFrame));
}

// A stamp is in the picture of the frame in which the hand made it.
void makePicture(EditorApp& a) {
    constexpr double kStrokeMs = 4;  // of a frame, for stamps that wait
    if (a.doc.stroking()) a.doc.pumpStroke(kStrokeMs);
    if (a.gpu.software) foreseeLongFrames(a);
    drawScene({a.doc, *a.renderer, a.picture, a.counts, a.clock, a.messages}, viewShown(a.doc, a.view.camera),
              wantedSettings(a), a.queue.pending());
    if (playing(a.doc)) return;
    followComparison(a.accuracy.comparison, {a.doc, a.gpu, *a.renderer, a.clock, a.messages},
                     comparedView(a.view.camera, a.picture, a.hand, a.clock, !a.background.making.empty()));
    releaseSplit(a.accuracy.comparison, a.hand);
}

// What helps the hand that edits, over the picture.
void drawAids(EditorApp& a, const RingParts& rings) {
    const Comparison& c = a.accuracy.comparison;
    drawComparison(c, a.hand,
                   {techniqueShown(a.doc), comparisonLabel(c, a.doc, a.clock), a.messages.notice.empty() ? 6.f : 60.f});
    if (!a.tierView.hover && !c.gripHovered && !drawsDecal(a.picture, a.clock))
        drawBrushRing(a.doc, a.view.camera, a.hand, a.brushes);
    if (!a.tierView.hover && !c.gripHovered) drawBrushShape(a.doc, a.view.camera, a.hand, a.brushes);
    drawMirror(a.doc, a.view.camera, a.hand, a.brushes);
    if (!a.placing.file.empty())
        drawPlacedHeights(a.doc, a.view.camera, a.hand.rect, a.placing.source, a.placing.place);
    drawRings(rings);
    const ObjectParts objects = objectParts(a);
    drawObjects(objects);
    drawPaths(objects);
    drawGizmo(objects);
    drawPlacing(objects, a.hand.ground);
}

void viewport(EditorApp& a) {
    {
        const ui::Disabled noProject(!a.doc.isOpen());
        drawViewportHeader(a.doc, a.view, a.hand.gesture);
    }
    const Rect& r = a.hand.rect = layImage(a.areas.viewport);
    const RingParts rings = ringParts(a);
    takeInput(a, rings, ImGui::IsItemHovered() && a.doc.isOpen());
    const auto before = std::chrono::steady_clock::now();
    if (a.doc.isOpen()) makePicture(a);
    a.pictureMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect({r.x, r.y}, {r.x + r.w, r.y + r.h}, true);
    if (a.doc.isOpen() && a.picture.hasImage) {
        list.AddImage(ui::textureId(a.picture.texture), {r.x, r.y}, {r.x + r.w, r.y + r.h}, {0, 1}, {1, 0});
        if (!playing(a.doc)) drawAids(a, rings);
        drawOverlayLegend(a.doc, a.brushes, a.view.camera.yaw, r);
        drawPlayFrame(a.doc, a.play.captured, r);
    } else {
        drawStart({a.start, a.thumbnails, a.doc, a.files, a.unsaved, a.edits, a.messages, a.background.waiting,
                   [&a] { adoptProject(a); }},
                  r);
    }
    list.PopClipRect();
    if (a.doc.isOpen() && !playing(a.doc)) drawLongFrame({a.picture.longFrame, a.doc, a.edits, a.messages}, r);
    drawErrorBar(a.messages.notice, r);
}

// --- the rest

void profiler(EditorApp& a) { drawProfiler(a.counts, a.frameTimes, a.picture.drawnSettings.measure, a.gpu.renderer); }
void tiers(EditorApp& a) {
    const FieldParts edit = fieldParts(a);
    drawTiers({edit, shownPixelsPerMetre(a)}, a.tierView, shownEntity(a.selection), a.view, a.counts,
              a.picture.drawnSettings.measure);
}
void effects(EditorApp& a) {
    const MeasureParts measure{a.doc, a.effects.program, a.view.camera, a.clock, a.messages};
    const ViewSettings shown = wantedSettings(a);
    drawEffects({a.effects, measure, a.edits, effectSize(shown.width, shown.height, a.gpu.software), shown.time});
}
void statusBar(EditorApp& a) {
    drawStatusBar(a.doc, a.counts, a.picture.resolution.drawnScale, a.brushCost, a.strokeTiming, a.background,
                  a.messages.status);
}
void fileDialog(EditorApp& a) {
    drawFileDialog(a.files, a.doc, a.edits, a.messages, a.background, a.thumbnails, [&a] { adoptProject(a); });
}
// What is done with an image that was chosen.
void takeImage(EditorApp& a, const ImageDialog& d, const WaitedEnd& then) {
    Waiting& waiting = a.background.waiting;
    if (d.task == ImageTask::Shape) return takeShape(waiting, a.brushes, d.path, then);
    if (d.task == ImageTask::Heights) return beginPlacing(a.placing, a.doc, waiting, d.path, d.flipX, d.flipZ, then);
    const auto range = rangeOf(d.low, d.high);
    if (!range) return then(range.error());
    const ImportOptions options{.flip = d.flipZ, .range = *range};
    editBeside(
        waiting, a.doc, "Importing " + std::filesystem::path(d.path).filename().string(),
        [map = d.map, file = d.path, options, flipX = d.flipX](Document& doc, JobControl&) {
            return importIntoMap(doc, map, file, options, flipX);
        },
        [&messages = a.messages, then, file = d.path](const Status& done) {
            if (done) say(messages, "imported " + file);
            then(done);
        });
}
void imageDialog(EditorApp& a) {
    drawImageDialog(a.images, a.edits, [&a](const ImageDialog& d, const WaitedEnd& then) { takeImage(a, d, then); });
}
void renameDialog(EditorApp& a) {
    drawRenameDialog(a.rename, a.doc, a.edits, [&a, from = a.rename.entity](const std::string& name) {
        followName(from, name, a.selection, a.brushes, a.tierView);
    });
}
void contextMenu(EditorApp& a) {
    if (const Command* c = drawContextMenu(commandStates(a), shownEntity(a.selection), a.objects.menu))
        a.edits.deferred.push_back([&a, c] { c->run(a); });
}
void palette(EditorApp& a) {
    if (!a.palette.open) return;
    std::vector<std::string> entities;
    if (a.doc.isOpen())
        for (const auto& [name, e] : a.doc.project().entities) entities.push_back(name);
    const std::optional<PaletteLine> line = drawPalette(a.palette, commandStates(a), entities, a.in);
    if (!line) return;
    const Command* command = line->state ? line->state->command : nullptr;
    a.edits.deferred.push_back([&a, command, entity = line->label] {
        if (command) return command->run(a);
        choose(a.selection, entity);
        focusChosen(a);
    });
}
void keysDialog(EditorApp& a) {
    if (!drawKeysDialog(a.keys, a.bindings, a.in) || !a.keepLayout) return;
    if (const auto file = bindingsFile()) saveBindings(*file, a.bindings);
}
void filmDialog(EditorApp& a) {
    if (!drawFilmDialog(a.film, a.doc)) return;
    a.edits.deferred.push_back([&a] {
        auto film = startFilm(a.doc, a.gpu, a.film.plan, viewShown(a.doc, a.view.camera), a.view.mode);
        a.film.error = film ? "" : film.error().text();
        if (!film) return;
        a.background.film = std::move(*film);
        a.film.open = false;
        say(a.messages, a.film.plan.film ? "filming" : "taking a picture");
    });
}
void recoveryDialog(EditorApp& a) {
    if (drawRecoveryDialog(a.autosave, a.doc, a.edits, a.messages, a.background.waiting)) a.clock.wanted = 4;
}

using App = EditorApp;
constexpr PanelRow kPanels[] = {
    {"Menu", Dock::Menu, menuBar, false},
    {"Play", Dock::Menu, playBar, false},
    {"Brush", Dock::BrushBar, brushBar, false, nullptr, true},
    {"Tools", Dock::Tools, [](App& a) { drawToolStrip(a.doc, a.brushes, a.objects.mode, a.messages); }, false, nullptr,
     true},
    {"Viewport", Dock::Viewport, viewport, false},
    {"Outliner", Dock::Outliner, [](App& a) { drawOutliner(fieldParts(a), a.selection, a.objects.menu); }, true,
     nullptr, true},
    {"Inspector", Dock::Inspector, [](App& a) { drawInspector(fieldParts(a), shownEntity(a.selection), a.view); }, true,
     nullptr, true},
    {"Console", Dock::Bottom, [](App& a) { drawConsole(a.console, a.queue.pending()); }, true},
    {"Profiler", Dock::Bottom, profiler, true},
    {"Tiers", Dock::Bottom, tiers, true, "Tiers Panel", true},
    {"Accuracy", Dock::Bottom, [](App& a) { drawAccuracy(a.accuracy, measureParts(a), a.edits, a.counts.lastMs); },
     true, nullptr, true},
    {"History", Dock::Bottom, [](App& a) { drawHistory(a.doc, a.selection, a.edits, a.messages, a.historyShown); },
     true, nullptr, true},
    {"Objects", Dock::Bottom, [](App& a) { drawAssets(a.doc, a.brushes, a.objects, a.thumbnails, a.messages); }, true,
     "Objects Panel", true},
    {"Layers", Dock::Bottom,
     [](App& a) { drawLayers(fieldParts(a), a.brushes, a.layerView, a.renderer->layerNotes()); }, true, "Layers Panel",
     true},
    {"Species", Dock::Bottom,
     [](App& a) { drawSpecies(fieldParts(a), a.speciesPalette, a.brushes, shownEntity(a.selection)); }, true,
     "Species Panel", true},
    {"Pictures", Dock::Bottom,
     [](App& a) {
         drawPictures({a.pictureRun, a.doc, a.gpu, a.edits, a.messages});
     },
     true, "Pictures Panel", true},
    {"Transitions", Dock::Bottom,
     [](App& a) {
         drawTransitions({a.transitions, a.doc, a.view, a.edits});
     },
     true, "Transitions Panel", true},
    {"Hard Cases", Dock::Bottom, [](App& a) { drawHardCases(a.hardCases, a.edits); }, true, "Hard Cases Panel"},
    {"Effects", Dock::Bottom, effects, true, "Effects Panel", true},
    {"Status", Dock::StatusBar, statusBar, false},
    {"Files", Dock::Dialog, fileDialog, false},
    {"Image", Dock::Dialog, imageDialog, false},
    {"Map health", Dock::Dialog,
     [](App& a) { drawMapHealth(a.mapHealth, a.doc, a.view.camera, a.edits, a.background.waiting); }, false},
    {"Place heights", Dock::Dialog,
     [](App& a) { drawHeightPlacing(a.placing, a.doc, a.edits, a.messages, a.background.waiting); }, false},
    {"Unsaved", Dock::Dialog,
     [](App& a) { drawUnsavedDialog(a.unsaved, a.doc, a.outside, a.edits, a.background.waiting); }, false},
    {"Recovery", Dock::Dialog, recoveryDialog, false},
    {"Outside", Dock::Dialog,
     [](App& a) {
         drawOutsideDialog({a.doc, a.files, a.outside, a.messages, a.background.waiting}, a.unsaved, a.edits);
     },
     false},
    {"Rename", Dock::Dialog, renameDialog, false},
    {"Context", Dock::Dialog, contextMenu, false},
    {"Palette", Dock::Dialog, palette, false},
    {"Keys", Dock::Dialog, keysDialog, false},
    {"Film", Dock::Dialog, filmDialog, false},
    {"Waiting", Dock::Dialog, [](App& a) { drawWaiting(a.background.waiting); }, false},
};

}  // namespace

std::span<const PanelRow> panelRows() { return kPanels; }

}  // namespace sward
