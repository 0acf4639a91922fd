#include "model/picture_tests.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/file.h"
#include "core/hash.h"
#include "core/save_folder.h"
#include "metrics/heatmap.h"
#include "metrics/metrics.h"
#include "model/one_step.h"
#include "world/view_camera.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

Status drawPicture(Renderer& renderer, const Project& p, const std::string& camera, const AcceptedPicture& asked) {
    const Entity e = findEntity(p, camera);
    const Camera* eye = e == kNoEntity ? nullptr : p.registry.get<Camera>(e);
    if (!eye) return usage(fmt::format("there is no camera \"{}\"", camera), "choose an entity with a Camera");
    ViewSettings s;
    s.width = asked.width, s.height = asked.height, s.msaa = asked.samplesPerPixel;
    s.time = static_cast<double>(asked.seconds);
    return drawSettled(renderer, p, viewOf(*eye), s);
}

Picture pictureOfBytes(int width, int height, const std::vector<uint8_t>& rgb) {
    Picture p{width, height, false, {}};
    for (size_t i = 0; i + 2 < rgb.size(); i += 3)
        p.pixels.push_back(glm::vec3(rgb[i], rgb[i + 1], rgb[i + 2]) / 255.f);
    return p;
}

Status readAccepted(PictureResult& r, const Project& p) {
    const Result<fs::path> file = currentFile(p.dir, r.asked.file);
    if (!file) return file.error();
    const Result<Image> image = readImage(*file);
    if (!image) return image.error();
    r.accepted = pictureOf(*image, false);
    if (image->width == r.asked.width && image->height == r.asked.height) return {};
    return failed(fmt::format("the accepted picture is {}x{}, the camera asks for {}x{}", image->width, image->height,
                              r.asked.width, r.asked.height),
                  "accept it anew, or set the size back")
        .at(r.asked.file);
}

Status judge(PictureResult& r, Renderer& renderer, const Project& p) {
    if (Status s = drawPicture(renderer, p, r.camera, r.asked); !s) return s;
    r.now = pictureOfBytes(r.asked.width, r.asked.height, renderer.readImage());
    if (Status s = readAccepted(r, p); !s) return s;
    const Result<PicturePair> pair = pairPictures(r.now, r.accepted);
    if (!pair) return pair.error();
    r.verdict = judgePicture(*pair, r.asked);
    return {};
}

// As acceptPicture names files: camera, dot, 8 hexadecimal digits.
bool isMadeName(const std::string& name) {
    constexpr size_t kTail = 13;  // ".1a2b3c4d.png"
    if (name.size() <= kTail || !name.ends_with(".png") || name[name.size() - kTail] != '.') return false;
    const std::string digits = name.substr(name.size() - kTail + 1, 8);
    return digits.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

std::string resultText(const PictureResult& r) {
    if (r.error) return r.error->text();
    if (r.pass()) return "as accepted: " + verdictText(r.verdict);
    const bool other = !r.asked.madeBy.empty() && r.asked.madeBy != r.drawnBy;
    return "differs: " + r.verdict.why +
           (other ? fmt::format(" (accepted on {}, drawn on {})", r.asked.madeBy, r.drawnBy) : "");
}

std::vector<uint8_t> differencePicture(const PictureResult& r) {
    const Result<PicturePair> pair = pairPictures(r.now, r.accepted);
    if (!pair || r.now.pixels.empty()) return {};
    return heatmap(errorMap(*pair, ErrorMetric::Rmse), heatScale(ErrorMetric::Rmse));
}

std::vector<std::string> picturesOf(const Project& p) {
    std::vector<std::string> names;
    for (const auto& [name, e] : p.entities) {
        const AcceptedPicture* a = p.registry.get<AcceptedPicture>(e);
        if (a && !a->file.empty() && p.registry.get<Camera>(e)) names.push_back(name);
    }
    return names;
}

PictureResult checkPicture(Renderer& renderer, const Gpu& gpu, const Project& p, const std::string& camera) {
    PictureResult r;
    r.camera = camera, r.drawnBy = gpu.renderer;
    r.asked = *acceptedPicture(p, camera);
    if (Status s = judge(r, renderer, p); !s) r.error = s.error();
    return r;
}

Result<std::string> acceptPicture(Document& doc, Renderer& renderer, const Gpu& gpu, const std::string& camera,
                                  const PictureWish& wish) {
    if (!doc.isOpen()) return failed("no project is open", "open or create one first");
    const AcceptedPicture* had = acceptedPicture(doc.project(), camera);
    AcceptedPicture now = had ? *had : AcceptedPicture{};
    if (wish.size) now.width = wish.size->first, now.height = wish.size->second;
    if (wish.seconds) now.seconds = *wish.seconds;
    if (Status s = drawPicture(renderer, doc.project(), camera, now); !s) return s.error();
    const std::vector<uint8_t> pixels = renderer.readImage();
    now.file = fmt::format("{}/{}.{}.png", kPictureFolder, camera,
                           hashHex(hashBytes(pixels.data(), pixels.size())).substr(0, 8));
    now.madeBy = gpu.renderer;
    const fs::path file = doc.project().dir / now.file;
    if (Status s = makeFolderOf(file); !s) return s.error();
    if (Status s = writeImagePng(file, now.width, now.height, 3, pixels); !s) return s.error();
    const Status done = inOneStep(doc, "accept the picture of " + camera,
                                  [&] { return doc.assignComponent(camera, acceptedPictureRow(), &now); });
    if (!done) return done.error();
    return now.file;
}

std::vector<std::string> dropOldPictures(const Project& p) {
    std::set<std::string> named;
    for (const auto& [name, e] : p.entities)
        if (const AcceptedPicture* a = p.registry.get<AcceptedPicture>(e)) named.insert(a->file);
    std::vector<std::string> dropped;
    std::error_code fault;
    for (const fs::directory_entry& e : fs::directory_iterator(p.dir / kPictureFolder, fault)) {
        const std::string name = e.path().filename().string(), file = std::string(kPictureFolder) + "/" + name;
        if (isMadeName(name) && !named.contains(file)) dropped.push_back(file);
    }
    std::sort(dropped.begin(), dropped.end());
    for (const std::string& file : dropped) fs::remove(p.dir / file, fault);
    return dropped;
}

}  // namespace sward
