#include "app/effect_run.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/accuracy.h"
#include "app/frame_clock.h"
#include "app/messages.h"
#include "maps/map_io.h"
#include "model/document.h"
#include "model/effect_edits.h"

namespace sward {
namespace {

Texture uploaded(Gpu& gpu, const Image& image) {
    std::vector<uint8_t> bytes;
    for (const float v : image.pixels)
        bytes.push_back(static_cast<uint8_t>(std::lround(255 * std::clamp(v, 0.f, 1.f))));
    Texture t = makeTexture2D(gpu, "editor/effects", GL_RGBA8, image.width, image.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(t.id(), 0, 0, 0, image.width, image.height, image.channels == 4 ? GL_RGBA : GL_RGB,
                        GL_UNSIGNED_BYTE, bytes.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return t;
}

void upload(EffectRun& run, Gpu& gpu) {
    run.showDue = false;
    run.picture = {};
    for (const EffectLine& e : run.effects) {
        if (e.feature != run.shown || e.picture.empty()) continue;
        const Result<Image> image = readImage(run.folder / "effects" / e.picture);
        if (image && image->channels >= 3) run.picture = uploaded(gpu, *image);
    }
}

void tellEnd(const EffectRun& run, Messages& messages) {
    const auto wasted =
        std::count_if(run.effects.begin(), run.effects.end(), [](const EffectLine& e) { return e.costsUnseen; });
    say(messages,
        fmt::format("{} effects measured, {} of them unseen though they cost time", run.effects.size(), wasted));
}

void takeIn(EffectRun& run, Messages& messages, int code) {
    if (code != 0) {
        run.error = failureOf(run, "effects", code);
        return;
    }
    const Result<Json> json = readJson(run.folder / "effects" / "effects.json");
    Result<std::vector<EffectLine>> lines =
        json ? effectsFrom(*json, run.camera) : Result<std::vector<EffectLine>>(json.error());
    if (!lines) {
        run.error = lines.error().text();
        return;
    }
    run.effects = std::move(*lines);
    if (!run.effects.empty()) showEffect(run, run.effects.front().feature);
    tellEnd(run, messages);
}

void followPresent(EffectRun& run, const Document& doc) {
    if (run.effects.empty() || run.presentRevision == doc.revision()) return;
    run.presentRevision = doc.revision();
    run.present = sceneFeatures(run.drawn.of(doc.project(), doc.tables().components).registry, doc.tables());
}

}  // namespace

glm::ivec2 effectSize(int width, int height, bool software) {
    glm::ivec2 size(std::max(width, 1), std::max(height, 1));
    while (software && size.x > kSlowEffectWidth) size = glm::max(size / 2, 1);
    return size;
}

void startEffects(EffectRun& run, const MeasureParts& parts, const glm::ivec2& size, double seconds) {
    const bool open = parts.doc.isOpen();
    const std::string out = open ? (sideFolder(parts.doc) / "effects").string() : "";
    const std::string camera = open ? accuracyCamera(parts.doc, parts.camera) : "";
    const Status started =
        launchRun(run, parts, "effects", camera,
                  {"--size", fmt::format("{}x{}", size.x, size.y), "--time", fmt::format("{}", seconds), "--out", out});
    if (!accept(parts.messages, started)) return;
    run.size = size;
    run.effects.clear();
    run.dir = parts.doc.project().dir;
    run.revision = parts.doc.revision();
    showEffect(run, Feature::Count);
}

void followEffects(EffectRun& run, const Document& doc, Gpu& gpu, FrameClock& clock, Messages& messages) {
    if (run.dir.empty()) return;
    if (!doc.isOpen() || doc.project().dir != run.dir) {
        stopRun(run);
        run = EffectRun{};
        return;
    }
    if (followNews(run, "effects", clock.now)) clock.wanted = std::max(clock.wanted, 2);
    if (const auto code = endedRun(run, clock)) takeIn(run, messages, *code);
    if (run.showDue) upload(run, gpu), clock.wanted = std::max(clock.wanted, 2);
    followPresent(run, doc);
}

void showEffect(EffectRun& run, Feature feature) {
    run.shown = feature;
    run.showDue = true;
}

void turnOffNow(Document& doc, Messages& messages, Feature feature) {
    if (accept(messages, turnOff(doc, feature)))
        say(messages, fmt::format("{} is off; undo brings it back", featureName(feature)));
}

}  // namespace sward
