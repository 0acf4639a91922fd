// sward check --pictures: the accepted pictures of a project's cameras as its tests.
#include "cli/cli.h"
#include "cli/interrupt.h"
#include "core/file.h"
#include "core/json.h"
#include "maps/map_io.h"
#include "model/picture_tests.h"
#include "project/project_files.h"
#include "techniques.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

Result<std::vector<std::string>> camerasToCheck(const Project& p, const std::string& wanted) {
    const std::vector<std::string> all = picturesOf(p);
    const char* remedy = "sward check PROJECT --pictures --accept makes them";
    if (wanted.empty() && all.empty()) return failed("no camera has an accepted picture", remedy).at(p.dir.string());
    if (wanted.empty()) return all;
    if (const auto known = cameraNames(p, wanted); !known) return known;
    if (std::find(all.begin(), all.end(), wanted) == all.end())
        return failed(wanted + " has no accepted picture", remedy).at(p.dir.string());
    return std::vector<std::string>{wanted};
}

std::vector<uint8_t> bytesOf(const Picture& p) {
    std::vector<uint8_t> bytes;
    for (const glm::vec3& c : p.pixels)
        for (int k = 0; k < 3; ++k)
            bytes.push_back(static_cast<uint8_t>(std::lround(255 * std::clamp(c[k], 0.f, 1.f))));
    return bytes;
}

// What a person looks at: the picture now, the accepted one, and where they differ.
Status writeEvidence(const PictureResult& r, const fs::path& folder) {
    const auto write = [&](const char* kind, int width, int height, const std::vector<uint8_t>& pixels) -> Status {
        if (pixels.empty()) return {};
        const fs::path file = folder / (r.camera + kind + ".png");
        if (Status s = makeFolderOf(file); !s) return s;
        return writeImagePng(file, width, height, 3, pixels);
    };
    if (Status s = write("", r.now.width, r.now.height, bytesOf(r.now)); !s) return s;
    if (Status s = write(".accepted", r.accepted.width, r.accepted.height, bytesOf(r.accepted)); !s) return s;
    return write(".difference", r.now.width, r.now.height, differencePicture(r));
}

Json resultJson(const PictureResult& r) {
    Json j;
    j["camera"] = r.camera, j["pass"] = r.pass(), j["said"] = resultText(r);
    if (!r.error)
        j["mean_off"] = r.verdict.meanOff, j["pixels_off"] = r.verdict.pixelsOff,
        j["appearance"] = r.verdict.appearance;
    j["size"].push(r.asked.width), j["size"].push(r.asked.height);
    return j;
}

Result<std::vector<PictureResult>> judgeAll(const PictureOptions& o, const Project& p, Gpu& gpu) {
    const auto cameras = camerasToCheck(p, o.camera);
    if (!cameras) return cameras.error();
    const Interruptible here;
    Renderer renderer(gpu, tables());
    std::vector<PictureResult> results;
    const auto tell = progressLine("pictures");
    for (const std::string& camera : *cameras) {
        if (!tell(static_cast<double>(results.size()) / static_cast<double>(cameras->size())))
            return interruption("interrupted; nothing was written");
        results.push_back(checkPicture(renderer, gpu, p, camera));
    }
    tell(1);
    for (const PictureResult& r : results)
        if (!o.out.empty() && !r.pass())
            if (Status s = writeEvidence(r, o.out); !s) return s.error();
    return results;
}

int check(const PictureOptions& o, Gpu& gpu) {
    const auto project = loadProject(o.project, tables().components);
    if (!project) return report(project.error());
    const auto results = judgeAll(o, *project, gpu);
    if (!results) return report(results.error());
    Json all;
    size_t passed = 0;
    for (const PictureResult& r : *results) {
        all["pictures"].push(resultJson(r));
        if (!o.json) std::printf("%s: %s\n", r.camera.c_str(), resultText(r).c_str());
        passed += r.pass();
    }
    if (o.json)
        std::printf("%s", writeJson(all).c_str());
    else
        std::printf("%s: %zu of %zu pictures as accepted\n", o.project.c_str(), passed, results->size());
    return static_cast<int>(passed == results->size() ? ExitCode::Done : ExitCode::Failed);
}

Result<PictureWish> wishOf(const PictureOptions& o) {
    PictureWish wish;
    if (!o.size.empty()) {
        const auto size = parseSize(o.size);
        if (!size) return size.error();
        wish.size = *size;
    }
    if (o.time) wish.seconds = static_cast<float>(*o.time);
    return wish;
}

int accept(const PictureOptions& o, Gpu& gpu) {
    const auto wish = wishOf(o);
    if (!wish) return report(wish.error());
    Document doc(tables());
    if (Status s = doc.open(o.project); !s) return report(s.error());
    const auto cameras = cameraNames(doc.project(), o.camera);
    if (!cameras) return report(cameras.error());
    Renderer renderer(gpu, tables());
    for (const std::string& camera : *cameras) {
        const auto file = acceptPicture(doc, renderer, gpu, camera, *wish);
        if (!file) return report(file.error());
        std::printf("%s: %s\n", camera.c_str(), file->c_str());
    }
    if (const auto written = doc.save(); !written) return report(written.error());
    for (const std::string& file : dropOldPictures(doc.project())) std::printf("removed %s\n", file.c_str());
    return 0;
}

}  // namespace

int pictureVerb(const PictureOptions& o) {
    if (o.accept && (o.json || !o.out.empty()))
        return report(usage("--accept makes pictures and judges none", "leave out --out and --json"));
    if (!o.accept && (!o.size.empty() || o.time))
        return report(usage("--size and --time are of pictures that are made", "add --accept; those made keep theirs"));
    if (o.accept && !wishOf(o)) return report(wishOf(o).error());
    auto gpu = makeHeadlessGpu();
    if (!gpu) return report(gpu.error());
    return o.accept ? accept(o, **gpu) : check(o, **gpu);
}

}  // namespace sward
