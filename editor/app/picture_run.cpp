#include "app/picture_run.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/frame_clock.h"

namespace sward {
namespace {

Texture uploaded(Gpu& gpu, int width, int height, const std::vector<uint8_t>& rgb) {
    if (rgb.empty()) return {};
    Texture t = makeTexture2D(gpu, "editor/pictures", GL_RGBA8, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(t.id(), 0, 0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return t;
}
Texture uploaded(Gpu& gpu, const Picture& p) {
    std::vector<uint8_t> rgb;
    for (const glm::vec3& c : p.pixels)
        for (int k = 0; k < 3; ++k) rgb.push_back(static_cast<uint8_t>(std::lround(255 * std::clamp(c[k], 0.f, 1.f))));
    return uploaded(gpu, p.width, p.height, rgb);
}

template <class F>
std::vector<PictureResult>::iterator resultThat(PictureRun& run, const F& test) {
    return std::find_if(run.results.begin(), run.results.end(), test);
}
std::vector<PictureResult>::iterator resultOf(PictureRun& run, const std::string& camera) {
    return resultThat(run, [&](const PictureResult& r) { return r.camera == camera; });
}

void tellEnd(const PictureRun& run, Messages& messages) {
    const auto passed = std::count_if(run.results.begin(), run.results.end(), [](const auto& r) { return r.pass(); });
    say(messages, fmt::format("{} of {} pictures as accepted", passed, run.results.size()));
}

}  // namespace

void startPictures(PictureRun& run, const Document& doc, Messages& messages) {
    if (!doc.isOpen()) return showError(messages, failed("no project is open", "open or create one first"));
    run.waiting = picturesOf(doc.project());
    if (run.waiting.empty())
        return showError(messages, failed("no camera has an accepted picture",
                                          "choose a camera, then Accept Picture of This Camera in the menu Test"));
    run.asked = run.waiting.size();
    std::reverse(run.waiting.begin(), run.waiting.end());
    run.results.clear();
    run.shown.clear();
    run.revision = doc.revision();
    run.dir = doc.project().dir;
    run.project = std::make_unique<Project>(snapshot(doc.project(), doc.tables().components));
}

namespace {

void drawNext(PictureRun& run, const Tables& tables, Gpu& gpu, Messages& messages) {
    if (!run.renderer) run.renderer = std::make_unique<Renderer>(gpu, tables);
    const std::string camera = run.waiting.back();
    run.waiting.pop_back();
    run.results.push_back(checkPicture(*run.renderer, gpu, *run.project, camera));
    if (run.shown.empty()) showResult(run, camera);
    if (checking(run)) return;
    stopPictures(run);
    if (const auto worst = resultThat(run, [](const PictureResult& r) { return !r.pass(); });
        worst != run.results.end())
        showResult(run, worst->camera);
    tellEnd(run, messages);
}

void upload(PictureRun& run, Gpu& gpu) {
    run.showDue = false;
    const auto r = resultOf(run, run.shown);
    if (r == run.results.end()) return;
    run.accepted = uploaded(gpu, r->accepted);
    run.now = uploaded(gpu, r->now);
    run.difference = uploaded(gpu, r->now.width, r->now.height, differencePicture(*r));
}

}  // namespace

void followPictures(PictureRun& run, const Document& doc, Gpu& gpu, FrameClock& clock, Messages& messages) {
    if (run.dir.empty()) return;
    if (!doc.isOpen() || doc.project().dir != run.dir) {
        run = {};
        return;
    }
    if (!checking(run) && !run.showDue) return;
    if (checking(run)) drawNext(run, doc.tables(), gpu, messages);
    if (run.showDue) upload(run, gpu);
    clock.wanted = 4;
}

void stopPictures(PictureRun& run) {
    run.waiting.clear();
    run.renderer.reset();
    run.project.reset();
}

bool checking(const PictureRun& run) { return !run.waiting.empty(); }

void showResult(PictureRun& run, const std::string& camera) {
    run.shown = camera;
    run.showDue = true;
}

void acceptNow(PictureRun& run, Document& doc, Gpu& gpu, Messages& messages, const std::string& camera) {
    Renderer renderer(gpu, doc.tables());
    const Result<std::string> file = acceptPicture(doc, renderer, gpu, camera);
    if (!file) return showError(messages, file.error());
    say(messages, fmt::format("accepted the picture of {}: {}", camera, *file));
    const auto r = resultOf(run, camera);
    if (r == run.results.end()) return;
    *r = checkPicture(renderer, gpu, doc.project(), camera);
    showResult(run, camera);
}

}  // namespace sward
