#include "accuracy/accuracy.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/frame_clock.h"
#include "app/messages.h"
#include "app/viewport.h"
#include "metrics/heatmap.h"
#include "model/document.h"
#include "scene/forest_technique.h"
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

ComparisonKey keyOf(const Comparison& c, const Document& doc, const ComparedView& view) {
    return {c.against,  doc.revision(), view.camera,
            view.width, view.height,    c.technique + (c.preview ? c.preview->technique + c.preview->text() : "")};
}

ViewSettings settingsFor(const FrameClock& clock, int width, int height) {
    ViewSettings s;
    s.width = width, s.height = height;
    s.background = !clock.fixed;
    return s;
}

Status drawn(Renderer& renderer, const Project& project, const ViewCamera& camera, const ViewSettings& s,
             Picture& out) {
    if (Status status = drawSettled(renderer, project, camera, s); !status) return status;
    out = pictureOfBytes(s.width, s.height, renderer.readImage());
    return {};
}

// What is on the screen, at the comparison's size.
bool drawOwn(Comparison& c, const CompareParts& p) {
    if (!c.own.pixels.empty()) return true;
    const glm::ivec2 size = comparisonSize(c.key.width, c.key.height);
    return accept(p.messages,
                  drawn(p.renderer, p.doc.visibleProject(), c.key.camera, settingsFor(p.clock, size.x, size.y), c.own));
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
    out.picture = tracedPicture(mean.width, mean.height, mean.color, mean.error);
    out.metrics = scoresOf(work.own, out.picture, mean.grass);
    out.grass = std::move(mean.grass);
    return out;
}

PassWork nextPass(Comparison& c, const Document& doc) {
    if (c.copyRevision != c.key.revision) {
        dropScene(c);
        c.copy = std::make_shared<Project>(snapshot(doc.visibleProject(), doc.tables().components));
        c.copyRevision = c.key.revision;
    }
    const glm::ivec2 size = comparisonSize(c.key.width, c.key.height);
    return {c.copy, &doc.tables(), c.scene, c.sum, c.own, c.key.camera, size.x, size.y};
}

void takePass(Comparison& c, const CompareParts& p, Result<ComparedPass> pass) {
    p.clock.wanted = std::max(p.clock.wanted, 2);
    if (!pass) {
        showError(p.messages, pass.error());
        return compareWith(c, p.clock.now, Against::Off);
    }
    c.scene = std::move(pass->scene);
    c.sum = std::move(pass->sum);
    c.other = std::move(pass->picture);
    c.grass = std::move(pass->grass);
    c.truthError = pass->truthError;
    c.metrics = pass->metrics;
    c.picture = uploaded(p.gpu, "editor/comparison", c.other.width, c.other.height, bytesOf(c.other));
    c.topFirst = c.heatDue = true;
}

void followReference(Comparison& c, const CompareParts& p) {
    if (!drawOwn(c, p)) return compareWith(c, p.clock.now, Against::Off);
    if (p.clock.fixed) {
        JobControl control;
        while (c.against == Against::Reference && c.sum.passes < kHeadlessPasses)
            takePass(c, p, tracePass(nextPass(c, p.doc), control));
        return;
    }
    if (c.job.active()) {
        if (auto pass = c.job.take(c.key.revision)) takePass(c, p, std::move(*pass));
    } else if (c.sum.passes < kMostPasses) {
        c.job = Job<ComparedPass>("reference", c.key.revision, [work = nextPass(c, p.doc)](JobControl& control) {
            return tracePass(work, control);
        });
    }
}

// --- against a technique, or settings: another renderer on a copy

Status makeCopy(Comparison& c, const CompareParts& p) {
    if (c.copyRevision == c.key.revision) return {};
    c.copy = std::make_shared<Project>(snapshot(p.doc.visibleProject(), p.doc.tables().components));
    c.copyRevision = c.key.revision;
    if (!c.renderer) c.renderer = std::make_unique<Renderer>(p.gpu, p.doc.tables());
    ViewSettings view;  // its fields are not the project's
    const CostSetting setting = c.against == Against::Settings && c.preview ? *c.preview : CostSetting{c.technique, {}};
    return applySetting(*c.copy, p.doc.tables(), setting, view);
}

Status drawStrip(Comparison& c, const CompareParts& p, int from, int to) {
    if (to <= from) return {};
    ViewSettings s = settingsFor(p.clock, c.key.width, to - from);
    s.part = {0, from, c.key.width, c.key.height};
    if (Status status = c.renderer->draw(*c.copy, c.key.camera, s); !status) return status;
    if (c.picture.id() == 0) c.picture = makeTexture2D(p.gpu, "editor/comparison", GL_RGBA8, c.key.width, c.key.height);
    glCopyImageSubData(c.renderer->image(), GL_TEXTURE_2D, 0, 0, 0, 0, c.picture.id(), GL_TEXTURE_2D, 0, 0, from, 0,
                       c.key.width, to - from, 1);
    c.topFirst = false;
    return {};
}

Status scoreTechnique(Comparison& c, const CompareParts& p) {
    const glm::ivec2 size = comparisonSize(c.key.width, c.key.height);
    if (Status s = drawn(*c.renderer, *c.copy, c.key.camera, settingsFor(p.clock, size.x, size.y), c.other); !s)
        return s;
    c.metrics = scoresOf(c.own, c.other, c.grass);
    c.heatDue = true;
    return {};
}

// From the top down, since that is how it is seen to come.
Status stepTechnique(Comparison& c, const CompareParts& p) {
    if (Status s = makeCopy(c, p); !s) return s;
    const bool whole = p.clock.fixed;
    do {
        const int h = c.key.height, to = h - h * c.strips / kStrips, from = h - h * (c.strips + 1) / kStrips;
        if (Status s = drawStrip(c, p, from, to); !s) return s;
        ++c.strips;
    } while (whole && c.strips < kStrips);
    return c.strips == kStrips ? scoreTechnique(c, p) : Status{};
}

void followTechnique(Comparison& c, const CompareParts& p) {
    if (c.strips >= kStrips) {
        // What was drawn with drafts of slices is drawn anew once they are there.
        const std::vector<JobNews> jobs = c.renderer->jobs();
        if (std::any_of(jobs.begin(), jobs.end(), [](const JobNews& j) { return j.finished; })) c.strips = 0;
        return;
    }
    if (!drawOwn(c, p) || !accept(p.messages, stepTechnique(c, p))) compareWith(c, p.clock.now, Against::Off);
    p.clock.wanted = std::max(p.clock.wanted, 2);
}

void drawHeat(Comparison& c, const CompareParts& p) {
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
    c.heat = uploaded(p.gpu, "editor/comparison", c.own.width, c.own.height, rgb);
}

bool atRest(const Comparison& c, const CompareParts& p, const ComparedView& view) {
    if (!view.rests || p.doc.stroking() || c.key.width < 1 || c.key.height < 1) return false;
    return p.clock.fixed || p.clock.now - c.changed >= kCompareRestSeconds;
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

void compareWith(Comparison& c, double now, Against against, const std::string& technique) {
    if (c.against == against && c.technique == technique) return;
    dropCompared(c);
    dropScene(c);
    c.against = against;
    c.technique = technique;
    c.gripHovered = false;
    c.changed = now;
    c.key = {};
}

std::vector<std::string> comparedTechniques(const Project& project, const Tables& tables) {
    std::vector<std::string> names;
    for (const TechniqueRow& row : tables.techniques) names.push_back(row.name);
    if (growingForests(project).empty()) return names;
    for (const ForestTechniqueRow& row : forestTechniques()) names.push_back(row.name);
    return names;
}

std::vector<std::string> comparisonNames(const Comparison& c, std::span<const std::string> techniques) {
    std::vector<std::string> names{"off", "reference"};
    names.insert(names.end(), techniques.begin(), techniques.end());
    if (c.preview) names.push_back("preview");
    return names;
}

int comparisonChosen(const Comparison& c, std::span<const std::string> techniques) {
    if (c.against == Against::Off || c.against == Against::Reference) return static_cast<int>(c.against);
    const std::vector<std::string> names = comparisonNames(c, techniques);
    const std::string& shown = c.against == Against::Settings ? names.back() : c.technique;
    return static_cast<int>(std::find(names.begin(), names.end(), shown) - names.begin());
}

void chooseComparison(Comparison& c, double now, std::span<const std::string> techniques, int chosen) {
    if (chosen < 2) return compareWith(c, now, chosen == 0 ? Against::Off : Against::Reference);
    const auto row = static_cast<size_t>(chosen - 2);
    if (row < techniques.size()) return compareWith(c, now, Against::Technique, techniques[row]);
    compareWith(c, now, Against::Settings);
}

void endComparison(Comparison& c) {
    compareWith(c, c.changed, Against::Off);
    c.retired.clear();
}

void previewSettings(Comparison& c, double now, const CostSetting& setting) {
    compareWith(c, now, Against::Off);
    c.preview = setting;
    compareWith(c, now, Against::Settings);
}

void chooseMetric(Comparison& c, ErrorMetric metric) {
    c.metric = metric;
    c.heatDue = true;
}

ComparedView comparedView(const FlyCamera& camera, const ViewportPicture& picture, const ViewportHand& hand,
                          const FrameClock& clock, bool making) {
    const bool still = hand.gesture == Gesture::None && !hand.flying && picture.resolution.drawnScale >= 1 && !making;
    return {viewOf(camera), picture.width, picture.height, picture.hasImage && (clock.fixed ? clock.refineNow : still)};
}

void followComparison(Comparison& c, const CompareParts& parts, const ComparedView& view) {
    c.retired.clear();
    if (c.against == Against::Off) return;
    if (const ComparisonKey key = keyOf(c, parts.doc, view); !(key == c.key)) {
        dropCompared(c);
        if (key.revision != c.key.revision) c.scene.reset();
        c.key = key;
        c.changed = parts.clock.now;
    }
    if (atRest(c, parts, view)) c.against == Against::Reference ? followReference(c, parts) : followTechnique(c, parts);
    drawHeat(c, parts);
}

bool comparing(const Comparison& c, const Document& document, const FrameClock& clock) {
    if (c.against == Against::Off || !document.isOpen() || clock.fixed) return false;
    return isTechnique(c.against) ? c.strips < kStrips || (c.renderer && !c.renderer->jobs().empty())
                                  : c.sum.passes < kMostPasses;
}

std::string techniqueShown(const Document& document) {
    const auto* field = firstOf<GrassField>(document.project());
    return field ? field->technique : "";
}

std::string comparisonLabel(const Comparison& c, const Document& document, const FrameClock& clock) {
    const std::string name = c.against == Against::Settings && c.preview ? "preview: " + c.preview->technique
                             : c.against == Against::Reference           ? "reference"
                                                                         : c.technique;
    if (c.picture.id() == 0)
        return name + (comparing(c, document, clock) && clock.now - c.changed >= kCompareRestSeconds
                           ? ", coming"
                           : ", once the view rests");
    if (c.against == Against::Reference)
        return fmt::format("{}, {} sample{}", name, c.sum.passes, c.sum.passes == 1 ? "" : "s");
    return name;
}

}  // namespace sward
