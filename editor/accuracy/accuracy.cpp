#include "accuracy/accuracy.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <cmath>

#include "app/app.h"
#include "metrics/heatmap.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr int kStrips = 12;  // of a technique's picture, one a frame, so that input never waits for all of it

bool isTechnique(Against a) { return a != Against::Off && a != Against::Reference; }

Texture uploaded(Gpu& gpu, const char* owner, int width, int height, const std::vector<uint8_t>& rgb) {
    Texture t = makeTexture2D(gpu, owner, GL_RGBA8, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(t.id(), 0, 0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return t;
}

std::vector<uint8_t> bytesOf(const Picture& p) {
    std::vector<uint8_t> rgb;
    rgb.reserve(p.pixels.size() * 3);
    for (const glm::vec3& c : p.pixels)
        for (int i = 0; i < 3; ++i)
            rgb.push_back(static_cast<uint8_t>(std::lround(255 * (c[i] > 0 ? std::min(c[i], 1.0f) : 0.0f))));
    return rgb;
}

Picture pictureOfBytes(int width, int height, const std::vector<uint8_t>& rgb) {
    Picture p{width, height, false, std::vector<glm::vec3>(static_cast<size_t>(width) * static_cast<size_t>(height))};
    for (size_t i = 0; i < p.pixels.size(); ++i)
        p.pixels[i] = glm::vec3(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]) / 255.0f;
    return p;
}

// All that was made for a key; what serves other views of the same scene stays.
void dropCompared(Comparison& c) {
    c.job.cancel();
    c.job = {};
    c.own = c.other = {};
    c.grass.clear();
    c.sum = {};
    c.truthError = 0;
    c.metrics.reset();
    for (Texture* t : {&c.picture, &c.heat})
        if (t->id() != 0) c.retired.push_back(std::exchange(*t, {}));
    c.strips = 0;
    c.heatDue = false;
}

// What is kept between views, too.
void dropScene(Comparison& c) {
    c.scene.reset();
    c.copy.reset();
    c.renderer.reset();
    c.copyRevision = ~uint64_t(0);
}

ComparisonKey keyOf(EditorApp& app) {
    const Comparison& c = app.accuracy.comparison;
    const Viewport& v = app.viewport;
    return {c.against,      app.doc.revision(), viewOf(v.camera),
            v.pictureWidth, v.pictureHeight,    c.preview ? c.preview->technique + c.preview->text() : ""};
}

ViewSettings settingsFor(EditorApp& app, int width, int height) {
    ViewSettings s;
    s.width = width, s.height = height;
    s.background = app.surface->fixedStep() == 0;
    return s;
}

Status drawn(Renderer& renderer, const Project& project, const ViewCamera& camera, const ViewSettings& s,
             Picture& out) {
    if (Status status = renderer.draw(project, camera, s); !status) return status;
    out = pictureOfBytes(s.width, s.height, renderer.readImage());
    return {};
}

// What is on the screen, at the comparison's size.
bool drawOwn(EditorApp& app) {
    Comparison& c = app.accuracy.comparison;
    if (!c.own.pixels.empty()) return true;
    const glm::ivec2 size = comparisonSize(c.key.width, c.key.height);
    return accept(app, drawn(*app.renderer, app.doc.project(), c.key.camera, settingsFor(app, size.x, size.y), c.own));
}

std::optional<Metrics> scoresOf(const Picture& own, const Picture& other, const std::vector<float>& grass) {
    const Result<PicturePair> pair = pairPictures(own, other, grass);
    return pair ? std::optional(metricsOf(*pair)) : std::nullopt;
}

// --- against the reference: a pass at a time, in the background

struct PassWork {
    std::shared_ptr<const Project> project;
    const Tables* tables;
    std::shared_ptr<const ReferenceScene> scene;
    PassSum sum;
    Picture own;
    ViewCamera camera;
    int width, height;
};

Result<ComparedPass> tracePass(const PassWork& work, JobControl& control) {
    ComparedPass out{work.scene, work.sum, {}, {}, 0, {}};
    if (!out.scene) {
        Result<ReferenceScene> made = ReferenceScene::make(*work.project, *work.tables, 0, control);
        if (!made) return made.error();
        out.scene = std::make_shared<const ReferenceScene>(std::move(*made));
    }
    ReferenceSettings settings;
    settings.width = work.width, settings.height = work.height;
    settings.samples = 1;
    settings.seed = static_cast<uint32_t>(work.sum.passes + 1);
    const Result<Truth> pass = out.scene->trace(work.camera, settings, control);
    if (!pass) return pass.error();
    addPass(out.sum, *pass);
    Truth mean = meanOf(out.sum);
    out.truthError = meanError(mean);
    out.picture = pictureOfLinear(mean.width, mean.height, mean.color);
    out.metrics = scoresOf(work.own, out.picture, mean.grass);
    out.grass = std::move(mean.grass);
    return out;
}

PassWork nextPass(EditorApp& app) {
    Comparison& c = app.accuracy.comparison;
    if (c.copyRevision != c.key.revision) {
        dropScene(c);
        c.copy = std::make_shared<Project>(snapshot(app.doc.project(), app.doc.tables().components));
        c.copyRevision = c.key.revision;
    }
    const glm::ivec2 size = comparisonSize(c.key.width, c.key.height);
    return {c.copy, &app.doc.tables(), c.scene, c.sum, c.own, c.key.camera, size.x, size.y};
}

void takePass(EditorApp& app, Result<ComparedPass> pass) {
    Comparison& c = app.accuracy.comparison;
    app.framesWanted = std::max(app.framesWanted, 2);
    if (!pass) {
        showError(app, pass.error());
        return compareWith(app, Against::Off);
    }
    c.scene = std::move(pass->scene);
    c.sum = std::move(pass->sum);
    c.other = std::move(pass->picture);
    c.grass = std::move(pass->grass);
    c.truthError = pass->truthError;
    c.metrics = pass->metrics;
    c.picture = uploaded(app.gpu, "editor/comparison", c.other.width, c.other.height, bytesOf(c.other));
    c.topFirst = c.heatDue = true;
}

void followReference(EditorApp& app) {
    Comparison& c = app.accuracy.comparison;
    if (!drawOwn(app)) return compareWith(app, Against::Off);
    if (app.surface->fixedStep() > 0) {
        JobControl control;
        while (c.against == Against::Reference && c.sum.passes < kHeadlessPasses)
            takePass(app, tracePass(nextPass(app), control));
        return;
    }
    if (c.job.active()) {
        if (auto pass = c.job.take(c.key.revision)) takePass(app, std::move(*pass));
    } else if (c.sum.passes < kMostPasses) {
        c.job = Job<ComparedPass>("reference", c.key.revision,
                                  [work = nextPass(app)](JobControl& control) { return tracePass(work, control); });
    }
}

// --- against a technique, or settings: another renderer on a copy

Status makeCopy(EditorApp& app) {
    Comparison& c = app.accuracy.comparison;
    if (c.copyRevision == c.key.revision) return {};
    c.copy = std::make_shared<Project>(snapshot(app.doc.project(), app.doc.tables().components));
    c.copyRevision = c.key.revision;
    if (!c.renderer) c.renderer = std::make_unique<Renderer>(app.gpu, app.doc.tables());
    ViewSettings view;  // its fields are not the project's
    const CostSetting setting = c.against == Against::Settings && c.preview
                                    ? *c.preview
                                    : CostSetting{kAgainst[static_cast<size_t>(c.against)], {}};
    return applySetting(*c.copy, app.doc.tables(), setting, view);
}

Status drawStrip(EditorApp& app, int from, int to) {
    Comparison& c = app.accuracy.comparison;
    if (to <= from) return {};
    ViewSettings s = settingsFor(app, c.key.width, to - from);
    s.part = {0, from, c.key.width, c.key.height};
    if (Status status = c.renderer->draw(*c.copy, c.key.camera, s); !status) return status;
    if (c.picture.id() == 0)
        c.picture = makeTexture2D(app.gpu, "editor/comparison", GL_RGBA8, c.key.width, c.key.height);
    glCopyImageSubData(c.renderer->image(), GL_TEXTURE_2D, 0, 0, 0, 0, c.picture.id(), GL_TEXTURE_2D, 0, 0, from, 0,
                       c.key.width, to - from, 1);
    c.topFirst = false;
    return {};
}

Status scoreTechnique(EditorApp& app) {
    Comparison& c = app.accuracy.comparison;
    const glm::ivec2 size = comparisonSize(c.key.width, c.key.height);
    if (Status s = drawn(*c.renderer, *c.copy, c.key.camera, settingsFor(app, size.x, size.y), c.other); !s) return s;
    c.metrics = scoresOf(c.own, c.other, c.grass);
    c.heatDue = true;
    return {};
}

// From the top down, since that is how it is seen to come.
Status stepTechnique(EditorApp& app) {
    Comparison& c = app.accuracy.comparison;
    if (Status s = makeCopy(app); !s) return s;
    const bool whole = app.surface->fixedStep() > 0;
    do {
        const int h = c.key.height, to = h - h * c.strips / kStrips, from = h - h * (c.strips + 1) / kStrips;
        if (Status s = drawStrip(app, from, to); !s) return s;
        ++c.strips;
    } while (whole && c.strips < kStrips);
    return c.strips == kStrips ? scoreTechnique(app) : Status{};
}

void followTechnique(EditorApp& app) {
    Comparison& c = app.accuracy.comparison;
    if (c.strips >= kStrips) {
        // What was drawn with drafts of slices is drawn anew once they are there.
        const std::vector<JobNews> jobs = c.renderer->jobs();
        if (std::any_of(jobs.begin(), jobs.end(), [](const JobNews& j) { return j.finished; })) c.strips = 0;
        return;
    }
    if (!drawOwn(app) || !accept(app, stepTechnique(app))) compareWith(app, Against::Off);
    app.framesWanted = std::max(app.framesWanted, 2);
}

void drawHeat(EditorApp& app) {
    Comparison& c = app.accuracy.comparison;
    if (!c.heatDue || c.show != CompareShow::Error || c.own.pixels.empty() || c.other.pixels.empty()) return;
    c.heatDue = false;
    const Result<PicturePair> pair = pairPictures(c.own, c.other, c.grass);
    if (!pair) return;
    const ErrorMap errors = errorMap(*pair, c.metric);
    std::vector<uint8_t> rgb = heatmap(errors, heatScale(c.metric));
    for (size_t i = 0; i < errors.size();
         ++i)  // what does not count is the picture in grey, so that one finds one's way
        if (!std::isfinite(errors[i]))
            for (size_t k = 0; k < 3; ++k)
                rgb[3 * i + k] = static_cast<uint8_t>(40 + 60 * std::clamp(c.own.pixels[i].y, 0.0f, 1.0f));
    c.heat = uploaded(app.gpu, "editor/comparison", c.own.width, c.own.height, rgb);
}

bool atRest(const EditorApp& app) {
    const Comparison& c = app.accuracy.comparison;
    const Viewport& v = app.viewport;
    if (!v.hasImage || app.doc.stroking() || c.key.width < 1 || c.key.height < 1) return false;
    if (app.surface->fixedStep() > 0) return app.refineNow;
    return v.gesture == Gesture::None && !v.flying && app.now - c.changed >= kCompareRestSeconds &&
           v.resolution.drawnScale >= 1 && app.making.empty();
}

bool sameView(const ViewCamera& a, const ViewCamera& b) {
    return a.eye == b.eye && a.target == b.target && a.fovDeg == b.fovDeg && a.exposure == b.exposure;
}

}  // namespace

void addPass(PassSum& s, const Truth& pass) {
    if (s.passes == 0) {
        s.width = pass.width, s.height = pass.height;
        s.sum.assign(pass.color.size(), 0);
        s.squares.assign(pass.color.size(), 0);
        s.grass.assign(pass.grass.size(), 0);
    }
    CHECK(pass.width == s.width && pass.height == s.height);
    for (size_t i = 0; i < pass.color.size(); ++i) {
        const double v = static_cast<double>(pass.color[i]);
        s.sum[i] += v;
        s.squares[i] += v * v;
    }
    for (size_t i = 0; i < pass.grass.size(); ++i) s.grass[i] += static_cast<double>(pass.grass[i]);
    ++s.passes;
}

Truth meanOf(const PassSum& s) {
    Truth t{s.width, s.height, {}, {}, {}};
    const double n = s.passes;
    for (size_t i = 0; i < s.sum.size(); ++i) {
        const double mean = s.sum[i] / n, variance = std::max(0.0, s.squares[i] / n - mean * mean) * n / (n - 1);
        t.color.push_back(static_cast<float>(mean));
        t.error.push_back(s.passes > 1 ? static_cast<float>(std::sqrt(variance / n))
                                       : std::numeric_limits<float>::infinity());
    }
    for (const double g : s.grass) t.grass.push_back(static_cast<float>(g / n));
    return t;
}

double meanError(const Truth& t) {
    double sum = 0;
    for (const float e : t.error) sum += static_cast<double>(e);
    return t.error.empty() ? 0 : sum / static_cast<double>(t.error.size());
}

glm::ivec2 comparisonSize(int width, int height) {
    while (width > kCompareWidth) width /= 2, height /= 2;
    return {std::max(width, 1), std::max(height, 1)};
}

bool ComparisonKey::operator==(const ComparisonKey& o) const {
    return against == o.against && revision == o.revision && sameView(camera, o.camera) && width == o.width &&
           height == o.height && settings == o.settings;
}

void compareWith(EditorApp& app, Against against) {
    Comparison& c = app.accuracy.comparison;
    if (c.against == against) return;
    dropCompared(c);
    dropScene(c);
    c.against = against;
    c.gripHovered = false;
    c.changed = app.now;
    c.key = {};
    if (against == Against::Off && app.viewport.gesture == Gesture::Split) app.viewport.gesture = Gesture::None;
}

void endComparison(EditorApp& app) {
    compareWith(app, Against::Off);
    app.accuracy.comparison.retired.clear();
}

void previewSettings(EditorApp& app, const CostSetting& setting) {
    compareWith(app, Against::Off);
    app.accuracy.comparison.preview = setting;
    compareWith(app, Against::Settings);
}

void chooseMetric(EditorApp& app, ErrorMetric metric) {
    app.accuracy.comparison.metric = metric;
    app.accuracy.comparison.heatDue = true;
}

void followComparison(EditorApp& app) {
    Comparison& c = app.accuracy.comparison;
    c.retired.clear();
    if (c.against == Against::Off) return;
    if (const ComparisonKey key = keyOf(app); !(key == c.key)) {
        dropCompared(c);
        if (key.revision != c.key.revision) c.scene.reset();
        c.key = key;
        c.changed = app.now;
    }
    if (atRest(app)) c.against == Against::Reference ? followReference(app) : followTechnique(app);
    drawHeat(app);
}

bool comparing(const EditorApp& app) {
    const Comparison& c = app.accuracy.comparison;
    if (c.against == Against::Off || !app.doc.isOpen() || app.surface->fixedStep() > 0) return false;
    return isTechnique(c.against) ? c.strips < kStrips || (c.renderer && !c.renderer->jobs().empty())
                                  : c.sum.passes < kMostPasses;
}

std::string techniqueShown(Document& document) {
    const auto* field = firstOf<GrassField>(document.project());
    return field ? kTechniques[field->technique] : "";
}

std::string comparisonLabel(const EditorApp& app) {
    const Comparison& c = app.accuracy.comparison;
    const std::string name = c.against == Against::Settings && c.preview ? "preview: " + c.preview->technique
                                                                         : kAgainst[static_cast<size_t>(c.against)];
    if (c.picture.id() == 0)
        return name +
               (comparing(app) && app.now - c.changed >= kCompareRestSeconds ? ", coming" : ", once the view rests");
    if (c.against == Against::Reference)
        return fmt::format("{}, {} sample{}", name, c.sum.passes, c.sum.passes == 1 ? "" : "s");
    return name;
}

}  // namespace sward
