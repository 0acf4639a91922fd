#include "app/app.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/commands.h"
#include "core/log.h"
#include "core/resources.h"
#include "model/assets.h"
#include "panels/panels.h"
#include "panels/viewport_objects.h"
#include "panels/viewport_scene.h"
#include "playtest/playtest.h"
#include "tools/brush_target.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kFilmMs = 20;         // of a frame, for pictures of a film
constexpr double kIdleSeconds = 0.25;  // how late a line logged by another thread may appear

double clockSeconds() {
    static const auto start = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void advanceTime(FrameClock& clock, const ui::Surface& surface) {
    const double step = surface.fixedStep();
    const double now = step > 0 ? clock.now + step : clockSeconds();
    clock.delta = std::clamp(now - clock.now, 0.001, 0.25);
    clock.now = now;
}

void followProject(EditorApp& app) {
    if (app.doc.isOpen() && app.doc.project().dir != app.shownProject) adoptProject(app);
    keepTargetValid(app.doc, app.brushes);
    if (app.doc.isOpen()) dropMissing(app.selection, app.doc.project());
    if (app.brushes.tool != kViewTool) app.objects.placing.clear();
}

void followBake(EditorApp& app) {
    std::optional<OcclusionBake>& bake = app.background.occlusion;
    if (!bake || playing(app.doc)) return;  // it waits for the end of play
    const std::optional<Status> end = finishOcclusion(app.doc, *bake);
    if (!end) return;
    bake.reset();
    app.clock.wanted = 4;
    if (accept(app.messages, *end)) say(app.messages, "ambient occlusion is baked");
}

void followExport(std::optional<SceneExport>& exporting, FileDialog& files, FrameClock& clock, Messages& messages) {
    const std::optional<Result<GlbCounts>> end = exporting ? finishExport(*exporting) : std::nullopt;
    if (!end) return;
    const std::string file = exporting->file.string();
    const bool cancelled = exporting->cancelled;
    exporting.reset();
    clock.wanted = 4;
    if (!*end && !cancelled && askAgain(files, file, end->error())) return logWarning(end->error().text());
    if (!*end) return showError(messages, end->error());
    say(messages, fmt::format("exported {}: {}", file, countsText(**end)));
}

// A strip a frame at least; it ends with a message.
void followFilm(std::unique_ptr<Film>& film, FrameClock& clock, Messages& messages) {
    if (!film) return;
    const std::optional<Status> end = pumpFilm(*film, kFilmMs);
    if (!end) return;
    const std::unique_ptr<Film> over = std::move(film);
    clock.wanted = 4;
    if (!accept(messages, *end)) return;
    const std::string where = over->plan.out.string();
    say(messages, over->plan.film ? fmt::format("filmed {}: {} pictures", where, over->frames) : "picture: " + where);
}

// The scene would look otherwise now, so that nothing of the pictures before may go into the next.
void showAnew(ViewportPicture& picture) { picture.drawnRevision = picture.begunRevision = kNeverDrawn; }

// What the renderer makes beside is shown once it is there; what was drawn with its draft is drawn anew.
void followRenderer(const Renderer& renderer, bool open, std::vector<JobNews>& making, ViewportPicture& picture) {
    std::vector<JobNews> jobs = renderer.jobs();
    const bool done = std::any_of(jobs.begin(), jobs.end(), [](const JobNews& j) { return j.finished; });
    if (open && (done || jobs.size() < making.size())) showAnew(picture);
    // Frames that add up are drawn on while the picture is a full one: a quick one is soon another.
    if (open && renderer.addsUp() && picture.resolution.drawnScale >= 1) picture.drawnRevision = kNeverDrawn;
    making = std::move(jobs);
}

void updateTitle(const Document& doc, ui::Surface& surface, std::string& shown) {
    std::string title = "Sward";
    if (doc.isOpen()) title = (doc.dirty() ? "\xE2\x97\x8F " : "") + doc.project().name + " - Sward";
    if (title == shown) return;
    shown = title;
    surface.setTitle(title);
}

void showCursor(ui::Surface& surface) {
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_TextInput:
            return surface.setCursor(ui::Cursor::Text);
        case ImGuiMouseCursor_ResizeEW:
            return surface.setCursor(ui::Cursor::ResizeEW);
        case ImGuiMouseCursor_ResizeNS:
            return surface.setCursor(ui::Cursor::ResizeNS);
        default:
            return surface.setCursor(ui::Cursor::Arrow);
    }
}

void present(ui::Surface& surface, std::function<void(ui::Surface&)>& beforePresent) {
    ImGui::Render();
    surface.bind();
    glViewport(0, 0, surface.pixelWidth(), surface.pixelHeight());
    glDisable(GL_SCISSOR_TEST);
    const ImVec4 behind = ImGui::GetStyle().Colors[ImGuiCol_Separator];  // seen between panels
    glClearColor(behind.x, behind.y, behind.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (const auto before = std::exchange(beforePresent, nullptr)) before(surface);
    surface.present();
}

// Something was pressed while a piece of the picture was drawn: showing panels that were laid out before it would only
// keep the frame that answers waiting.
bool overtaken(EditorApp& app) {
    if (!app.picture.refined || app.clock.fixed || app.beforePresent) return false;
    app.surface->poll(app.queue, 0);
    return app.queue.pending();
}

// Something is made beside that will show.
bool waitsForWork(const EditorApp& app) {
    return waits(app.background.waiting) || app.background.occlusion || app.background.exporting ||
           !app.background.making.empty() || makingThumbnails(app.thumbnails) ||
           comparing(app.accuracy.comparison, app.doc, app.clock) || measuring(app.accuracy) ||
           checking(app.pictureRun) || app.pictureRun.showDue || walking(app.transitions) || app.effects.running() ||
           app.effects.showDue;
}

bool moves(const Document& doc) { return playing(doc) && doc.play()->runs(); }

bool wantsFrame(const EditorApp& app) {
    return app.clock.wanted > 0 || app.queue.pending() || app.hand.flying || app.doc.stroking() || moves(app.doc) ||
           !app.edits.deferred.empty() || !app.console.luaLines.empty() || app.background.film ||
           app.picture.drawnRevision != app.doc.revision() || hasFreshLog(app.console.log);
}

// What the last stroke costs, a frame of it at a time.
void timeStroke(EditorApp& app) {
    const Resolution& r = app.picture.resolution;
    TimingState state{viewShown(app.doc, app.view.camera), app.picture.drawnSettings, r.fullMs};
    state.restless = app.clock.wanted > 0 || app.queue.pending() || app.hand.flying ||
                     app.hand.gesture != Gesture::None || !app.edits.holding.empty();
    const bool whole = app.clock.fixed || (r.drawnScale >= 1 && !r.stale);
    state.free = whole && app.picture.drawnRevision == app.doc.revision() && !app.background.film && !waitsForWork(app);
    followStroke(app.strokeTiming, {app.doc, *app.renderer, app.clock}, state);
}

// What the last frame's widgets and the hand asked for, and what follows from it.
void settleEdits(EditorApp& app) {
    runDeferred(app.edits);
    releaseGroup(app.edits, app.doc, ImGui::IsAnyItemActive());
    const Rect& view = app.areas.viewport;
    if (app.doc.stroking() && (view.w < 1 || view.h < 1)) app.doc.pumpStroke(0);  // no picture is made that would
    const FrameStats* measured = app.picture.drawnSettings.measure ? &app.counts.stats : nullptr;
    followBrushCost(app.brushCost, app.doc, app.brushes, app.hand.ground, measured);
    followRenderer(*app.renderer, app.doc.isOpen(), app.background.making, app.picture);
    timeStroke(app);
}

// Files dropped onto the window come into the project as objects; the last one is in the hand then.
void takeDropped(EditorApp& app) {
    for (const std::string& file : app.in.dropped) {
        if (!app.doc.isOpen() || playing(app.doc)) {
            showError(app.messages, failed(file + " cannot come in now", "open a project, or stop playing"));
            continue;
        }
        const Result<std::string> asset = importAsset(app.doc.project().dir, file);
        if (!asset) {
            showError(app.messages, asset.error());
            continue;
        }
        selectTool(app.doc, app.brushes, app.messages, kViewTool);
        app.objects.placing = *asset;
        app.layout.tab = "Objects";
        say(app.messages, *asset + " is in the hand: click on the ground");
    }
}

// What the world did since the last frame.
void followWorld(EditorApp& app) {
    advanceTime(app.clock, *app.surface);
    if (takeLog(app.console.log)) app.messages.status = app.console.log.lines.back().text;
    followProject(app);
    if (followWaiting(app.background.waiting)) app.clock.wanted = 4;
    app.doc.followStanding();
    followBake(app);
    followExport(app.background.exporting, app.files, app.clock, app.messages);
    followFilm(app.background.film, app.clock, app.messages);
    followRuns(app.accuracy, app.clock, app.messages);
    followPictures(app.pictureRun, app.doc, app.gpu, app.clock, app.messages);
    followHardCases(app.hardCases, &app.gpu, app.clock);
    followTransitions(app.transitions, app.doc, app.gpu, app.clock, app.messages, app.clock.fixed);
    followEffects(app.effects, app.doc, app.gpu, app.clock, app.messages);
    followPlay(playParts(app), app.in);
    takeDropped(app);
    if (followThumbnails(app.thumbnails, app.gpu, app.clock.fixed)) app.clock.wanted = 2;
}

}  // namespace

EditorApp::EditorApp(Document& d, Gpu& g, std::unique_ptr<ui::Surface> s, bool keep) : doc(d), gpu(g) {
    surface = std::move(s);
    keepLayout = keep;
    imgui = ImGui::CreateContext();
    ImGui::SetCurrentContext(imgui);
    ui::setUpContext();
    ui::applyTheme(std::max(1.f, ui::densityOf(*surface)));
    ImGui_ImplOpenGL3_Init("#version 450");
    renderer = std::make_unique<Renderer>(gpu, doc.tables());
    clock.fixed = surface->fixedStep() > 0;
    background.waiting.patient = images.patient = clock.fixed;
    if (!clock.fixed) doc.standBeside();
    thumbnails.tables = &doc.tables();
    if (gpu.software)
        picture.resolution.movingScale = kMinScale,
        picture.resolution.movingDetail = kMinDetail;  // it knows better soon
    if (keepLayout)
        if (const auto file = layoutFile()) layout = loadLayout(*file), bindings = loadBindings(*bindingsFile());
    start = loadStart(keepLayout ? recentFile() : std::filesystem::path(), resource("projects"));
    start.keep = keepLayout;
    brushes.shiftErases = layout.shiftErases;
    strokeTiming.on = layout.timesStrokes && !clock.fixed;  // headless frames are drawn for what they show alone
    frameTimes.budgetMs = std::round(layout.budgetMs * 10) / 10;
    openLog(console.log);
}

EditorApp::~EditorApp() {
    closeLog(console.log);
    if (!edits.holding.empty()) doc.endGroup();
    layout.shiftErases = brushes.shiftErases;
    if (!clock.fixed) layout.timesStrokes = strokeTiming.on;
    layout.budgetMs = frameTimes.budgetMs;
    if (keepLayout)
        if (const auto file = layoutFile()) saveLayout(*file, layout);
    ImGui::SetCurrentContext(imgui);
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(imgui);
    cancelWaiting(background.waiting);
    stopRuns(accuracy);
    stopRun(effects);
    effects.picture = {};
    pictureRun = {};
    transitions = {};
    endComparison(accuracy.comparison);
    freePicture(picture);
    background.film.reset();
    renderer.reset();
}

PlayParts playParts(EditorApp& app) { return {app.doc, app.play, *app.surface, app.picture, app.clock, app.messages}; }

ObjectParts objectParts(EditorApp& a) {
    const bool active = a.doc.isOpen() && a.brushes.tool == kViewTool;
    return {a.doc,         a.selection, a.objects,        a.edits, a.messages,
            a.view.camera, a.hand.rect, timeShown(a.doc), active,  a.clock.fixed};
}

void runFrame(EditorApp& app, double waitSeconds) {
    ImGui::SetCurrentContext(app.imgui);
    const double entered = clockSeconds();
    if (runEntered(app.console) > 0) app.clock.wanted = 4;
    const double asked = clockSeconds();
    app.surface->poll(app.queue, waitSeconds);
    const double begun = clockSeconds() - (asked - entered);                 // without the wait for input
    const bool held = app.queue.pending() || waits(app.background.waiting);  // what was asked for before comes first
    const bool closing = !held && app.surface->takeCloseRequest();
    if (closing) requestQuit(app);
    if (closing || app.queue.pending()) app.clock.wanted = 4;  // a dialog is seen from its second frame on
    --app.clock.wanted;
    app.in = app.queue.next();
    followWorld(app);
    ui::feedInput(widgetInput(app.in, app.play), static_cast<float>(app.clock.delta), app.surface->width(),
                  app.surface->height(), app.surface->pixelWidth(), app.surface->pixelHeight());
    ui::setTheme(app.layout.lightTheme ? ui::Theme::Light : ui::Theme::Dark);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    ui::beginBook(app.book);
    runShortcuts(app);
    app.pictureMs = 0, app.picture.refined = false;
    const double widgets = clockSeconds();
    const glm::vec2 size(app.surface->width(), app.surface->height());
    drawPanels(app, app.layout, app.areas, size, app.brushBarRows, playing(app.doc));
    ui::endBook(app.book);
    const double built = clockSeconds();
    settleEdits(app);
    updateTitle(app.doc, *app.surface, app.shownTitle);
    showCursor(*app.surface);
    if (overtaken(app))
        ImGui::EndFrame();
    else
        present(*app.surface, app.beforePresent);
    addFrame(app.frameTimes, {static_cast<float>(1000 * (clockSeconds() - begun)),
                              static_cast<float>(1000 * (built - widgets) - app.pictureMs)});
    if (app.afterFrame) app.afterFrame(app.book);
}

double idleSeconds(const EditorApp& app) {
    if (wantsFrame(app)) return 0;
    const double refine =
        app.clock.fixed || !app.doc.isOpen() ? -1 : secondsToRefine(app.picture.resolution, clockSeconds());
    const double timing = secondsToTiming(app.strokeTiming, clockSeconds());
    double idle = app.book.tooltipDue || waitsForWork(app) ? 0.1 : kIdleSeconds;
    for (const double due : {refine, timing})
        if (due >= 0) idle = std::min(idle, due);
    return idle;
}

namespace {

// Shaders that were edited are compiled and seen; one that fails is told and the last good one stays.
void followShaders(Renderer& renderer, Messages& messages, ViewportPicture& picture) {
    const Reload done = renderer.reloadPrograms();
    if (!done.failed.empty()) messages.notice = done.failed.front();
    if (!done.nothing()) showAnew(picture);
}

}  // namespace

void runUntilQuit(EditorApp& app) {
    double lastLook = clockSeconds();
    while (!app.quit) {
        if (clockSeconds() - lastLook > 1) {
            lastLook = clockSeconds();
            followShaders(*app.renderer, app.messages, app.picture);
            if (!playing(app.doc) && !app.doc.stroking() && app.edits.holding.empty() &&
                !waits(app.background.waiting) && askOutside(app.outside, app.doc, false))
                app.clock.wanted = 4;
        }
        if (tickAutosave(app.autosave, app.doc, !app.edits.holding.empty(), clockSeconds())) app.clock.wanted = 4;
        app.surface->poll(app.queue, idleSeconds(app));
        const bool refine = app.doc.isOpen() && secondsToRefine(app.picture.resolution, clockSeconds()) == 0;
        const bool timing = secondsToTiming(app.strokeTiming, clockSeconds()) == 0;
        if (wantsFrame(app) || refine || timing || app.book.tooltipDue || waitsForWork(app) ||
            app.surface->closeRequested())
            runFrame(app);
    }
    endAutosave(app.autosave);
}

void requestQuit(EditorApp& app) {
    stopPlay(playParts(app));
    askFirst(app.unsaved, app.doc, [&app] { app.quit = true; });
}

void adoptProject(EditorApp& app) {
    const Project& project = app.doc.project();
    app.shownProject = project.dir;
    rememberProject(app.start, project.dir, recentFile());
    showAnew(app.picture);
    app.picture.resolution.stale = true;
    app.picture.resolution.fullMs = 0;
    app.counts.populationRevision = kNeverDrawn;
    app.selection.entities.clear();
    app.objects.drag.reset();
    app.objects.box.reset();
    app.hand.strokeBegin.reset();
    app.hand.strokeEnd.reset();
    stopRuns(app.accuracy);
    app.accuracy.sweep = {};
    app.accuracy.fit = {};
    compareWith(app.accuracy.comparison, app.clock.now, Against::Off);
    app.book.errors.clear();
    if (const Camera* camera = findCamera(project, "")) app.view.camera = flyFrom(viewOf(*camera));
    for (const auto& [name, entity] : project.entities)
        if (project.registry.get<GrassField>(entity)) choose(app.selection, name);
    keepTargetValid(app.doc, app.brushes);
}

}  // namespace sward
