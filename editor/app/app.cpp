#include "app/app.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <chrono>

#include "app/commands.h"
#include "panels/panels.h"
#include "panels/viewport_scene.h"
#include "playtest/playtest.h"
#include "tools/brush_target.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kStrokeMs = 4;        // of a frame, for stamps that wait
constexpr double kIdleSeconds = 0.25;  // how late a line logged by another thread may appear

double clockSeconds() {
    static const auto start = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void advanceTime(EditorApp& app) {
    const double step = app.surface->fixedStep();
    const double now = step > 0 ? app.now + step : clockSeconds();
    app.deltaSeconds = std::clamp(now - app.now, 0.001, 0.25);
    app.now = now;
}

void takeLog(EditorApp& app) {
    std::deque<LogLine> fresh;
    {
        const std::lock_guard lock(app.log.mutex);
        fresh.swap(app.log.fresh);
    }
    for (LogLine& line : fresh) {
        app.status = line.text;
        app.log.lines.push_back(std::move(line));
        if (app.log.lines.size() > 1000) app.log.lines.pop_front();
    }
}

bool hasFreshLog(const EditorApp& app) {
    LogBook& log = const_cast<EditorApp&>(app).log;
    const std::lock_guard lock(log.mutex);
    return !log.fresh.empty();
}

void followProject(EditorApp& app) {
    if (app.doc.isOpen() && app.doc.project().dir != app.shownProject) adoptProject(app);
    keepTargetValid(app);
}

void runConsole(EditorApp& app) {
    while (!app.luaLines.empty() && app.runLua) {
        const std::string line = app.luaLines.front();
        app.luaLines.pop_front();
        if (const Status status = app.runLua(line); !status) logError(status.error().text());
        app.framesWanted = 4;
    }
}

void runDeferred(EditorApp& app) {
    std::vector<std::function<void()>> edits;
    edits.swap(app.deferred);
    for (const auto& edit : edits) edit();
}

// A slider's undo group ends when nothing is held any more, whatever became of the slider.
void releaseGroup(EditorApp& app) {
    if (app.holding.empty() || ImGui::IsAnyItemActive()) return;
    app.holding.clear();
    app.doc.endGroup();
}

void followBake(EditorApp& app) {
    if (!app.occlusion || playing(app)) return;  // it waits for the end of play
    const std::optional<Status> end = finishOcclusion(app.doc, *app.occlusion);
    if (!end) return;
    app.occlusion.reset();
    app.framesWanted = 4;
    if (accept(app, *end)) say(app, "ambient occlusion is baked");
}

// What the renderer makes beside is shown once it is there; strips drawn with its draft are drawn anew.
void followRenderer(EditorApp& app) {
    std::vector<JobNews> jobs = app.renderer->jobs();
    const bool done = std::any_of(jobs.begin(), jobs.end(), [](const JobNews& j) { return j.finished; });
    if (app.doc.isOpen() && (done || jobs.size() < app.making.size())) app.viewport.drawnRevision = ~uint64_t(0);
    app.making = std::move(jobs);
}

void updateTitle(EditorApp& app) {
    std::string title = "Sward";
    if (app.doc.isOpen()) title = (app.doc.dirty() ? "\xE2\x97\x8F " : "") + app.doc.project().name + " - Sward";
    if (title == app.shownTitle) return;
    app.shownTitle = title;
    app.surface->setTitle(title);
}

void showCursor(EditorApp& app) {
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_TextInput:
            return app.surface->setCursor(ui::Cursor::Text);
        case ImGuiMouseCursor_ResizeEW:
            return app.surface->setCursor(ui::Cursor::ResizeEW);
        case ImGuiMouseCursor_ResizeNS:
            return app.surface->setCursor(ui::Cursor::ResizeNS);
        default:
            return app.surface->setCursor(ui::Cursor::Arrow);
    }
}

void present(EditorApp& app) {
    ImGui::Render();
    app.surface->bind();
    glViewport(0, 0, app.surface->pixelWidth(), app.surface->pixelHeight());
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.08f, 0.08f, 0.08f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (const auto before = std::exchange(app.beforePresent, nullptr)) before(*app.surface);
    app.surface->present();
}

// Something is made beside that will show.
bool waitsForWork(const EditorApp& app) {
    return app.occlusion || !app.making.empty() || comparing(app) || measuring(app);
}

bool moves(const EditorApp& app) { return playing(app) && app.doc.play()->runs(); }

bool wantsFrame(const EditorApp& app) {
    return app.framesWanted > 0 || app.queue.pending() || app.viewport.flying || app.doc.stroking() || moves(app) ||
           !app.deferred.empty() || !app.luaLines.empty() || app.viewport.drawnRevision != app.doc.revision() ||
           hasFreshLog(app);
}

}  // namespace

EditorApp::EditorApp(Document& document, Gpu& g, std::unique_ptr<ui::Surface> s, bool keep)
    : doc(document), gpu(g), surface(std::move(s)), keepLayout(keep) {
    imgui = ImGui::CreateContext();
    ImGui::SetCurrentContext(imgui);
    ui::setUpContext();
    ui::applyTheme(surface->contentScale());
    ImGui_ImplOpenGL3_Init("#version 450");
    renderer = std::make_unique<Renderer>(gpu, doc.tables());
    if (gpu.software)
        viewport.resolution.movingScale = viewport.resolution.movingDetail = 0.25;  // a guess; drawings teach better
    if (keepLayout)
        if (const auto file = layoutFile()) layout = loadLayout(*file);
    brushes.shiftErases = layout.shiftErases;
    log.sink = addLogSink([this](LogLevel level, const std::string& text) {
        const std::lock_guard lock(log.mutex);
        log.fresh.push_back({level, text});
    });
}

EditorApp::~EditorApp() {
    removeLogSink(log.sink);
    if (!holding.empty()) doc.endGroup();
    layout.shiftErases = brushes.shiftErases;
    if (keepLayout)
        if (const auto file = layoutFile()) saveLayout(*file, layout);
    ImGui::SetCurrentContext(imgui);
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(imgui);
    stopRuns(*this);
    endComparison(*this);
    freePicture(viewport);
    renderer.reset();
}

void runFrame(EditorApp& app, double waitSeconds) {
    ImGui::SetCurrentContext(app.imgui);
    runConsole(app);
    app.surface->poll(app.queue, waitSeconds);
    const bool closing = !app.queue.pending() && app.surface->takeCloseRequest();  // what was typed before comes first
    if (closing) requestQuit(app);
    if (closing || app.queue.pending()) app.framesWanted = 4;  // a dialog is seen from its second frame on
    --app.framesWanted;
    app.in = app.queue.next();
    advanceTime(app);
    takeLog(app);
    followProject(app);
    followBake(app);
    followRuns(app);
    followPlay(app);
    ui::feedInput(widgetInput(app), static_cast<float>(app.deltaSeconds), app.surface->width(), app.surface->height(),
                  app.surface->pixelWidth(), app.surface->pixelHeight());
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    ui::beginBook(app.book);
    runShortcuts(app);
    drawPanels(app);
    ui::endBook(app.book);
    runDeferred(app);
    releaseGroup(app);
    if (app.doc.stroking()) app.doc.pumpStroke(kStrokeMs);
    followBrushCost(app);
    followRenderer(app);
    updateTitle(app);
    showCursor(app);
    present(app);
}

double idleSeconds(const EditorApp& app) {
    if (wantsFrame(app)) return 0;
    const double refine = app.surface->fixedStep() > 0 || !app.doc.isOpen()
                              ? -1
                              : secondsToRefine(app.viewport.resolution, clockSeconds());
    const double idle = app.book.tooltipDue || waitsForWork(app) ? 0.1 : kIdleSeconds;
    return refine >= 0 ? std::min(refine, idle) : idle;
}

namespace {

// Once a second: shaders that were edited are compiled and seen; one that fails is told and the last good one stays.
void followShaders(EditorApp& app, double& last) {
    if (clockSeconds() - last < 1) return;
    last = clockSeconds();
    const Reload done = app.renderer->reloadPrograms();
    if (!done.failed.empty()) app.notice = done.failed.front();
    if (!done.nothing()) app.viewport.drawnRevision = ~uint64_t(0);
}

}  // namespace

void runUntilQuit(EditorApp& app) {
    double lastLook = clockSeconds();
    while (!app.quit) {
        followShaders(app, lastLook);
        tickAutosave(app, clockSeconds());
        app.surface->poll(app.queue, idleSeconds(app));
        const bool refine = app.doc.isOpen() && secondsToRefine(app.viewport.resolution, clockSeconds()) == 0;
        if (wantsFrame(app) || refine || app.book.tooltipDue || waitsForWork(app) || app.surface->closeRequested())
            runFrame(app);
    }
    endAutosave(app);
}

void showError(EditorApp& app, const Error& error) {
    app.notice = error.text();
    logError(app.notice);
}

bool accept(EditorApp& app, const Status& status) {
    if (!status) showError(app, status.error());
    return static_cast<bool>(status);
}

void say(EditorApp& app, const std::string& message) {
    app.status = message;
    logInfo(message);
}

namespace {

// Runs `then` at once, or after the person has answered what to do with unsaved work.
void askFirst(EditorApp& app, std::function<void()> then) {
    if (!app.doc.isOpen() || !app.doc.dirty()) return then();
    app.unsaved.then = std::move(then);
    app.unsaved.opening = true;
}

void openDialog(EditorApp& app, FileTask task) {
    FileDialog& d = app.files;
    d.task = task;
    d.opening = true;
    d.error.clear();
    if (app.doc.isOpen() && !app.doc.project().dir.empty()) d.folder = app.doc.project().dir.parent_path();
    d.path = task == FileTask::SaveAs ? app.doc.project().dir.string() : "";
}

}  // namespace

void requestQuit(EditorApp& app) {
    stopPlay(app);
    askFirst(app, [&app] { app.quit = true; });
}

void requestTask(EditorApp& app, FileTask task) {
    if (task == FileTask::SaveAs) return openDialog(app, task);
    askFirst(app, [&app, task] { openDialog(app, task); });
}

bool saveNow(EditorApp& app) {
    if (app.doc.project().dir.empty()) {
        requestTask(app, FileTask::SaveAs);
        return false;
    }
    const auto written = app.doc.save();
    if (!written) {
        showError(app, written.error());
        return false;
    }
    app.notice.clear();
    say(app, written->empty()
                 ? "saved: nothing had changed"
                 : fmt::format("saved: {} file{} written", written->size(), written->size() == 1 ? "" : "s"));
    return true;
}

void adoptProject(EditorApp& app) {
    app.shownProject = app.doc.project().dir;
    app.viewport.drawnRevision = ~uint64_t(0);
    app.viewport.resolution.stale = true;
    app.viewport.resolution.fullMs = 0;
    app.selected.clear();
    stopRuns(app);
    app.accuracy.sweep = {};
    app.accuracy.fit = {};
    compareWith(app, Against::Off);
    app.book.errors.clear();
    if (const Camera* camera = findCamera(app.doc.project(), "")) app.viewport.camera = flyFrom(viewOf(*camera));
    for (const auto& [name, entity] : app.doc.project().entities)
        if (app.doc.project().registry.get<GrassField>(entity)) app.selected = name;
    keepTargetValid(app);
}

bool goToCamera(EditorApp& app, const std::string& name) {
    const Entity e = findEntity(app.doc.project(), name);
    const Camera* camera = e == kNoEntity ? nullptr : app.doc.project().registry.get<Camera>(e);
    if (camera) app.viewport.camera = flyFrom(viewOf(*camera));
    return camera != nullptr;
}

}  // namespace sward
