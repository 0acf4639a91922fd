#include "panels/viewport_scene.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/play_control.h"
#include "cost/frame_stats.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

bool sameCamera(const ViewCamera& a, const ViewCamera& b) {
    return a.eye == b.eye && a.target == b.target && a.fovDeg == b.fovDeg && a.exposure == b.exposure;
}

bool sameSettings(const ViewSettings& a, const ViewSettings& b) {
    return a.width == b.width && a.height == b.height && a.mode == b.mode && a.time == b.time &&
           a.measure == b.measure && a.decal.x == b.decal.x && a.decal.z == b.decal.z &&
           a.decal.radius == b.decal.radius && a.decal.falloff == b.decal.falloff && a.overlay == b.overlay;
}

// Headless frames draw coarsely, and in full for a screenshot: the same on every machine.
ResolutionPlan nextPlan(Resolution& r, const FrameClock& clock, bool measure, bool changed) {
    ResolutionPlan plan;
    if (!clock.fixed && !clock.refineNow) {
        plan = planDrawing(r, clock.now, changed);
        if (measure && plan.full) plan.piece = {};  // numbers are of whole pictures
        return plan;
    }
    plan.draw = changed || r.stale || (clock.refineNow && r.drawnScale < 1);
    if (clock.refineNow) return plan;
    plan.scale = kMinScale, plan.msaa = 1, plan.detail = std::min(0.25, r.most), plan.full = false;
    return plan;
}

// The texture on the screen, of the viewport's full size, whatever size is drawn.
void ensurePicture(ViewportPicture& v, int width, int height) {
    if (v.texture != 0 && v.width == width && v.height == height) return;
    freePicture(v);
    glCreateTextures(GL_TEXTURE_2D, 1, &v.texture);
    glTextureStorage2D(v.texture, 1, GL_RGBA8, width, height);
    glTextureParameteri(v.texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(v.texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glObjectLabel(GL_TEXTURE, v.texture, -1, "editor/viewport");
    glCreateFramebuffers(1, &v.target);
    glCreateFramebuffers(1, &v.source);
    glNamedFramebufferTexture(v.target, GL_COLOR_ATTACHMENT0, v.texture, 0);
    v.width = width, v.height = height;
    v.hasImage = false;
}

int pixelAt(int size, double share) { return static_cast<int>(std::lround(size * share)); }

// The pixels of a piece, first row at the bottom.
struct PixelRect {
    int x, y, width, height;
};
PixelRect pixelsOf(const PicturePiece& p, int width, int height) {
    const int left = pixelAt(width, p.left), above = pixelAt(height, p.from), below = pixelAt(height, p.to);
    return {left, height - below, pixelAt(width, p.right) - left, below - above};
}

// Puts the renderer's image where it belongs in the picture, stretched if it is coarser.
void place(ViewportPicture& v, unsigned image, const ViewSettings& drawn, const PixelRect& on) {
    glNamedFramebufferTexture(v.source, GL_COLOR_ATTACHMENT0, image, 0);
    glDisable(GL_SCISSOR_TEST);
    glBlitNamedFramebuffer(v.source, v.target, 0, 0, drawn.width, drawn.height, on.x, on.y, on.x + on.width,
                           on.y + on.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    v.hasImage = true;
}

// The bar stands while drawing fails, unless the person or another error took it; it goes with its cause.
void tellOfDrawing(Messages& m, const Status& status) {
    const bool stands = !m.drawNotice.empty() && m.notice == m.drawNotice;
    if (status) {
        if (stands) m.notice.clear();
        m.drawNotice.clear();
    } else if (m.notice.empty() || (stands && status.error().text() != m.notice)) {
        showError(m, status.error());
        m.drawNotice = m.notice;
    }
}

double drawTimed(const SceneParts& p, const ViewCamera& camera, ViewSettings settings) {
    const auto start = std::chrono::steady_clock::now();
    settings.begin = std::exchange(p.picture.begunRevision, p.doc.revision()) != p.doc.revision();
    const Status status = p.clock.refineNow ? drawSettled(p.renderer, projectShown(p.doc), camera, settings)
                                            : p.renderer.draw(projectShown(p.doc), camera, settings);
    p.renderer.finish();
    tellOfDrawing(p.messages, status);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Pieces meet the same cells twice, so their counts are not those of the picture: the coarse drawing before them gave
// these.
void keepStats(ViewCounts& v, const FrameStats& stats, const ResolutionPlan& plan, double ms) {
    v.lastMs = plan.piece.first() ? ms : v.lastMs + ms;
    if (!plan.piece.whole()) return;
    v.stats = stats;
    v.stats.bladesGeometry = static_cast<uint64_t>(static_cast<double>(stats.bladesGeometry) / plan.detail);
}

void drawPiece(const SceneParts& p, const ViewCamera& camera, const ViewSettings& whole, const ResolutionPlan& plan) {
    ViewSettings s = whole;
    s.msaa = plan.msaa;
    s.detail = static_cast<float>(plan.detail);
    const PixelRect on = pixelsOf(plan.piece, whole.width, whole.height);
    if (!plan.piece.whole()) {
        s.width = on.width, s.height = on.height;
        s.part = {on.x, on.y, whole.width, whole.height};
    } else {
        s.width = std::max(1, static_cast<int>(whole.width * plan.scale));
        s.height = std::max(1, static_cast<int>(whole.height * plan.scale));
    }
    double ms = 0;
    if (on.width > 0 && on.height > 0) {
        ms = drawTimed(p, camera, s);
        place(p.picture, p.renderer.image(), s, on);
        keepStats(p.counts, p.renderer.stats(), plan, ms);
    }
    learnDrawing(p.picture.resolution, plan, ms);
    if (p.counts.measure) p.counts.countedRevision = kNeverDrawn;
}

// What only counting over maps and cells tells: once at rest. A playtest changes no population: that is counted once
// for all of it.
void countAtRest(const SceneParts& p, const ViewCamera& camera) {
    ViewCounts& v = p.counts;
    const ViewSettings& drawn = p.picture.drawnSettings;
    const bool coarse = p.picture.resolution.drawnScale < 1 && !p.clock.fixed;
    if (coarse && !playing(p.doc)) return;
    if (std::exchange(v.populationRevision, p.doc.revision()) != p.doc.revision())
        v.bladesVirtual = virtualBlades(p.renderer.asDrawn(p.doc.project()));
    if (playing(p.doc) || v.countedRevision == p.doc.revision()) return;
    v.countedRevision = p.doc.revision();
    v.bladesVisible = v.measure ? visibleBlades(p.doc.project(), p.doc.tables(), camera, drawn.width, drawn.height) : 0;
}

// The same by species, for who looks at the list; anew where the view or the project changed.
void countSpecies(const SceneParts& p, const ViewCamera& camera) {
    ViewCounts& v = p.counts;
    const bool wanted = std::exchange(v.wantsSpecies, false) && !playing(p.doc);
    const bool coarse = p.picture.resolution.drawnScale < 1 && !p.clock.fixed;
    if (!wanted || coarse) return;
    if (v.speciesRevision == p.doc.revision() && sameCamera(camera, v.speciesCamera)) return;
    v.speciesRevision = p.doc.revision(), v.speciesCamera = camera;
    const ViewSettings& drawn = p.picture.drawnSettings;
    v.species = bladesBySpecies(p.doc.visibleProject(), p.doc.tables(), camera, drawn.width, drawn.height);
}

}  // namespace

BrushDecal decalOf(const Document& document, const ViewportHand& hand, BrushBook& brushes) {
    const bool painting = hand.gesture == Gesture::Paint || hand.gesture == Gesture::None;
    if (!hand.ground || brushes.tool == kViewTool || !painting) return {};
    const glm::dvec3 origin = document.ground().origin;
    const BrushSettings& b = currentBrush(brushes);
    return {hand.ground->x - origin.x, hand.ground->z - origin.z, b.radius, b.falloff};
}

bool drawsDecal(const ViewportPicture& picture, const FrameClock& clock) {
    return picture.resolution.movingScale >= 1 && !clock.fixed;
}

void freePicture(ViewportPicture& v) {
    glDeleteFramebuffers(1, &v.target);
    glDeleteFramebuffers(1, &v.source);
    glDeleteTextures(1, &v.texture);
    v.texture = v.target = v.source = 0;
}

void drawScene(const SceneParts& parts, const ViewCamera& camera, const ViewSettings& wanted, bool inputWaits) {
    if (wanted.width < 1 || wanted.height < 1) return;
    ViewportPicture& v = parts.picture;
    const FrameClock& clock = parts.clock;
    const uint64_t revision = parts.doc.revision();
    const bool changed =
        revision != v.drawnRevision || !sameCamera(camera, v.drawnCamera) || !sameSettings(wanted, v.drawnSettings);
    ResolutionPlan plan = nextPlan(v.resolution, clock, wanted.measure, changed);
    // Input first: pieces wait for it, and what moves is drawn now and then, so that it is seen to move.
    const bool refining = plan.full && !plan.piece.whole();
    const bool panelsFirst = refining && clock.wanted > 0;  // what was just pressed shows before another piece
    if (plan.draw && v.hasImage && !clock.refineNow && (panelsFirst || (inputWaits && (refining || ++v.skipped < 6))))
        return;
    v.skipped = 0;
    v.refined = refining;
    ensurePicture(v, wanted.width, wanted.height);
    v.drawnRevision = revision, v.drawnCamera = camera, v.drawnSettings = wanted;
    const double& last = parts.counts.lastMs;
    for (double spent = 0; plan.draw;) {
        const double before = last;
        drawPiece(parts, camera, wanted, plan);
        const double ms = plan.piece.first() ? last : last - before;
        spent += ms;
        if (plan.piece.whole()) break;
        plan = nextPlan(v.resolution, clock, wanted.measure, false);
        if (spent + std::max(ms, plan.expectedMs) > kPieceMs) break;
    }
    countAtRest(parts, camera);
    countSpecies(parts, camera);
}

}  // namespace sward
