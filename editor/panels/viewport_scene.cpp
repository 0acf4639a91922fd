#include "panels/viewport_scene.h"

#include <epoxy/gl.h>

#include <chrono>

#include "cost/frame_stats.h"
#include "tools/brush_target.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kStripsMs = 35;  // of a frame, for strips of the full picture

bool sameCamera(const ViewCamera& a, const ViewCamera& b) {
    return a.eye == b.eye && a.target == b.target && a.fovDeg == b.fovDeg && a.exposure == b.exposure;
}

bool sameSettings(const ViewSettings& a, const ViewSettings& b) {
    return a.width == b.width && a.height == b.height && a.mode == b.mode && a.time == b.time &&
           a.measure == b.measure && a.decal.x == b.decal.x && a.decal.z == b.decal.z &&
           a.decal.radius == b.decal.radius && a.decal.falloff == b.decal.falloff && a.overlay == b.overlay;
}

BrushDecal decalOf(EditorApp& app) {
    Viewport& v = app.viewport;
    const bool painting = v.gesture == Gesture::Paint || v.gesture == Gesture::None;
    if (!v.ground || app.brushes.tool == kLookTool || !painting || !drawsDecal(app) || app.tierView.hover) return {};
    const glm::dvec3 origin = findGround(app.doc.project()).origin;
    const BrushSettings& b = currentBrush(app.brushes);
    return {v.ground->x - origin.x, v.ground->z - origin.z, b.radius, b.falloff};
}

// Headless frames draw coarsely, and in full for a screenshot: the same on every machine.
ResolutionPlan nextPlan(EditorApp& app, bool changed) {
    Resolution& r = app.viewport.resolution;
    ResolutionPlan plan;
    if (app.surface->fixedStep() == 0 && !app.refineNow) {
        plan = planDrawing(r, app.now, changed);
        if (app.measure && plan.scale >= 1 && plan.detail >= 1)
            plan.from = 0, plan.to = 1;  // numbers are of whole pictures
        return plan;
    }
    plan.draw = changed || r.stale || (app.refineNow && r.drawnScale < 1);
    if (app.refineNow) return plan;
    plan.scale = kMinScale, plan.msaa = 1, plan.detail = 0.25;
    return plan;
}

// The texture on the screen, of the viewport's full size, whatever size is drawn.
void ensurePicture(Viewport& v, int width, int height) {
    if (v.picture != 0 && v.pictureWidth == width && v.pictureHeight == height) return;
    freePicture(v);
    glCreateTextures(GL_TEXTURE_2D, 1, &v.picture);
    glTextureStorage2D(v.picture, 1, GL_RGBA8, width, height);
    glTextureParameteri(v.picture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(v.picture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glObjectLabel(GL_TEXTURE, v.picture, -1, "editor/viewport");
    glCreateFramebuffers(1, &v.pictureTarget);
    glCreateFramebuffers(1, &v.pictureSource);
    glNamedFramebufferTexture(v.pictureTarget, GL_COLOR_ATTACHMENT0, v.picture, 0);
    v.pictureWidth = width, v.pictureHeight = height;
    v.hasImage = false;
}

// Puts the renderer's image into its rows of the picture, stretched if it is coarser.
void place(EditorApp& app, const ViewSettings& drawn, int y, int height) {
    Viewport& v = app.viewport;
    glNamedFramebufferTexture(v.pictureSource, GL_COLOR_ATTACHMENT0, app.renderer->image(), 0);
    glDisable(GL_SCISSOR_TEST);
    glBlitNamedFramebuffer(v.pictureSource, v.pictureTarget, 0, 0, drawn.width, drawn.height, 0, y, v.pictureWidth,
                           y + height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    v.hasImage = true;
}

// The bar stands while drawing fails, unless the person or another error took it; it goes with its cause.
void tellOfDrawing(EditorApp& app, const Status& status) {
    const bool stands = !app.drawNotice.empty() && app.notice == app.drawNotice;
    if (status) {
        if (stands) app.notice.clear();
        app.drawNotice.clear();
    } else if (app.notice.empty() || (stands && status.error().text() != app.notice)) {
        showError(app, status.error());
        app.drawNotice = app.notice;
    }
}

double drawTimed(EditorApp& app, const ViewCamera& camera, const ViewSettings& settings) {
    const auto start = std::chrono::steady_clock::now();
    const Status status = app.renderer->draw(projectShown(app), camera, settings);
    app.renderer->finish();
    tellOfDrawing(app, status);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Strips meet the same cells twice, so their counts are not those of the picture: the coarse drawing before them gave
// these.
void keepStats(Viewport& v, const FrameStats& stats, const ResolutionPlan& plan, double ms) {
    v.lastMs = plan.from <= 0 ? ms : v.lastMs + ms;
    if (!plan.whole()) return;
    v.stats = stats;
    v.stats.bladesGeometry = static_cast<uint64_t>(static_cast<double>(stats.bladesGeometry) / plan.detail);
}

void drawStrip(EditorApp& app, const ViewCamera& camera, const ViewSettings& whole, const ResolutionPlan& plan) {
    ViewSettings s = whole;
    s.msaa = plan.msaa;
    s.detail = static_cast<float>(plan.detail);
    int y = 0, height = whole.height;
    if (!plan.whole()) {
        const int above = static_cast<int>(std::lround(whole.height * plan.from)),
                  below = static_cast<int>(std::lround(whole.height * plan.to));
        s.height = height = below - above;
        y = whole.height - below;
        s.part = {0, y, whole.width, whole.height};
    } else {
        s.width = std::max(1, static_cast<int>(whole.width * plan.scale));
        s.height = std::max(1, static_cast<int>(whole.height * plan.scale));
    }
    double ms = 0;
    if (height > 0) {
        ms = drawTimed(app, camera, s);
        place(app, s, y, height);
        keepStats(app.viewport, app.renderer->stats(), plan, ms);
    }
    learnDrawing(app.viewport.resolution, plan, ms);
    if (app.measure) app.viewport.countedRevision = ~uint64_t(0);
}

// What only counting over maps and cells tells: once at rest. A playtest changes no population: that is counted once
// for all of it.
void countAtRest(EditorApp& app, const ViewCamera& camera) {
    Viewport& v = app.viewport;
    const bool coarse = v.resolution.drawnScale < 1 && app.surface->fixedStep() == 0;
    if (coarse && !playing(app)) return;
    if (std::exchange(v.populationRevision, app.doc.revision()) != app.doc.revision())
        v.bladesVirtual = virtualBlades(app.doc.project());
    if (playing(app) || v.countedRevision == app.doc.revision()) return;
    v.countedRevision = app.doc.revision();
    v.bladesVisible =
        app.measure ? visibleBlades(app.doc.project(), camera, v.drawnSettings.width, v.drawnSettings.height) : 0;
}

}  // namespace

bool drawsDecal(const EditorApp& app) {
    return app.viewport.resolution.movingScale >= 1 && app.surface->fixedStep() == 0;
}

void freePicture(Viewport& v) {
    glDeleteFramebuffers(1, &v.pictureTarget);
    glDeleteFramebuffers(1, &v.pictureSource);
    glDeleteTextures(1, &v.picture);
    v.picture = v.pictureTarget = v.pictureSource = 0;
}

void drawScene(EditorApp& app) {
    Viewport& v = app.viewport;
    ViewSettings settings;
    const float dense =
        static_cast<float>(app.surface->pixelWidth()) / static_cast<float>(std::max(1, app.surface->width()));
    settings.width = static_cast<int>(v.rect.w * dense), settings.height = static_cast<int>(v.rect.h * dense);
    settings.mode = v.mode;
    settings.time = timeShown(app);
    settings.measure = app.measure;
    settings.background =
        app.surface->fixedStep() == 0 && !app.refineNow;  // scripts and screenshots wait: the same picture each time
    settings.decal = decalOf(app);
    settings.overlay = overlayOf(app);
    if (settings.width < 1 || settings.height < 1) return;
    const ViewCamera camera = viewShown(app);
    const uint64_t revision = app.doc.revision();
    const bool changed =
        revision != v.drawnRevision || !sameCamera(camera, v.drawnCamera) || !sameSettings(settings, v.drawnSettings);
    ResolutionPlan plan = nextPlan(app, changed);
    // Input first: strips wait for it, and what moves is drawn now and then, so that it is seen to move.
    const bool refining = plan.scale >= 1 && plan.detail >= 1 && !plan.whole();
    if (plan.draw && app.queue.pending() && v.hasImage && !app.refineNow && (refining || ++v.skipped < 6)) return;
    v.skipped = 0;
    ensurePicture(v, settings.width, settings.height);
    v.drawnRevision = revision, v.drawnCamera = camera, v.drawnSettings = settings;
    double spent = 0;
    while (plan.draw) {
        const double before = v.lastMs;
        drawStrip(app, camera, settings, plan);
        spent += plan.from <= 0 ? v.lastMs : v.lastMs - before;
        if (plan.whole() || spent > kStripsMs) break;
        plan = nextPlan(app, false);
    }
    countAtRest(app, camera);
}

}  // namespace sward
