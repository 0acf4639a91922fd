#include "cli/cli.h"
#include "core/log.h"
#include "measure/heatmap.h"
#include "measure/metrics.h"
#include "scene/map_io.h"

namespace sward {
namespace {

Result<ErrorMetric> parseMetric(const std::string& text) {
    for (size_t i = 0; i < std::size(kErrorMetrics); ++i)
        if (text == kErrorMetrics[i]) return static_cast<ErrorMetric>(i);
    return Error{ExitCode::Usage, "there is no metric \"" + text + "\"", "", 0, 0, "appearance, flip, rmse or ssim"};
}

Status checkOptions(const CompareOptions& o) {
    if (!(o.ppd > 0 && o.ppd <= 10000)) return Error{ExitCode::Usage, "--ppd takes a number above 0, at most 10000", "", 0, 0, ""};
    if (!o.heatmap.empty() && std::filesystem::path(o.heatmap).extension() != ".png")
        return Error{ExitCode::Usage, "a heat map is written as .png", o.heatmap, 0, 0, "name --heatmap so"};
    return {};
}

// Alpha is ignored: gray and gray with alpha are one kind, RGB and RGBA the other.
bool gray(const Image& i) { return i.channels < 3; }

Result<std::vector<float>> readMask(const std::string& file, const Image& like) {
    if (file.empty()) return std::vector<float>{};
    auto image = readImage(file, true);
    if (!image) return image.error();
    if (image->width != like.width || image->height != like.height)
        return Error{ExitCode::Failed, fmt::format("the mask is {}x{}, the images are {}x{}", image->width, image->height, like.width, like.height), file, 0, 0, ""};
    std::vector<float> mask(static_cast<size_t>(image->width) * static_cast<size_t>(image->height));
    for (size_t i = 0; i < mask.size(); ++i) mask[i] = image->pixels[i * static_cast<size_t>(image->channels)];
    return mask;
}

Result<PicturePair> readPair(const CompareOptions& o) {
    auto a = readImage(o.a, true), b = readImage(o.b, true);
    if (!a) return a.error();
    if (!b) return b.error();
    if (gray(*a) != gray(*b))
        return Error{ExitCode::Unsound, fmt::format("the images differ in kind: {} and {} channels", a->channels, b->channels), o.a + ", " + o.b, 0, 0, "compare colour with colour"};
    auto mask = readMask(o.mask, *b);
    if (!mask) return mask.error();
    auto pair = pairPictures(pictureOf(*a, o.linear), pictureOf(*b, o.linear), *mask);
    if (!pair) return Error{pair.error().code, pair.error().message, o.a + ", " + o.b, 0, 0, pair.error().remedy};
    return pair;
}

}  // namespace

int compareVerb(const CompareOptions& o) {
    auto metric = parseMetric(o.metric);
    if (!metric) return report(metric.error());
    if (Status s = checkOptions(o); !s) return report(s.error());
    auto pair = readPair(o);
    if (!pair) return report(pair.error());
    if (pair->nonFinite > 0)
        logWarning(fmt::format("{} pixels are not finite and were left out; the first at {},{}", pair->nonFinite, pair->nonFiniteX, pair->nonFiniteY));
    const Metrics m = metricsOf(*pair, o.ppd);
    if (!o.heatmap.empty()) {
        const std::vector<uint8_t> pixels = heatmap(errorMap(*pair, *metric, o.ppd), heatScale(*metric));
        if (Status s = writeImagePng(o.heatmap, pair->truth.width, pair->truth.height, 3, pixels); !s) return report(s.error());
    }
    std::printf("%s", (o.json ? writeJson(metricsJson(m, *pair, o.ppd)) : metricsText(m, *pair, o.ppd)).c_str());
    return 0;
}

}  // namespace sward
