#include "cli/cli.h"
#include "core/log.h"
#include "maps/map_io.h"
#include "metrics/heatmap.h"
#include "metrics/metrics.h"
#include "metrics/popping.h"

namespace sward {
namespace fs = std::filesystem;
namespace {

Result<ErrorMetric> parseMetric(const std::string& text) {
    for (size_t i = 0; i < std::size(kErrorMetrics); ++i)
        if (text == kErrorMetrics[i]) return static_cast<ErrorMetric>(i);
    return usage("there is no metric \"" + text + "\"", "appearance, flip, rmse or ssim");
}

Status checkOptions(const CompareOptions& o) {
    if (!(o.ppd > 0 && o.ppd <= 10000)) return usage("--ppd takes a number above 0, at most 10000");
    if (!o.heatmap.empty() && std::filesystem::path(o.heatmap).extension() != ".png")
        return usage("a heat map is written as .png", "name --heatmap so").at(o.heatmap);
    return {};
}

// A picture that is not there is no unsound file: the work fails.
Status checkThere(const CompareOptions& o) {
    std::error_code fault;
    for (const std::string& file : {o.a, o.b, o.mask})
        if (!file.empty() && !fs::exists(file, fault)) return failed("does not exist", "check the name").at(file);
    return {};
}

// Alpha is ignored: gray and gray with alpha are one kind, RGB and RGBA the other.
bool gray(const Image& i) { return i.channels < 3; }

Result<std::vector<float>> readMask(const std::string& file, const Image& like) {
    if (file.empty()) return std::vector<float>{};
    auto image = readImage(file, true);
    if (!image) return image.error();
    if (image->width != like.width || image->height != like.height)
        return failed(fmt::format("the mask is {}x{}, the images are {}x{}", image->width, image->height, like.width,
                                  like.height))
            .at(file);
    std::vector<float> mask(static_cast<size_t>(image->width) * static_cast<size_t>(image->height));
    for (size_t i = 0; i < mask.size(); ++i) mask[i] = image->pixels[i * static_cast<size_t>(image->channels)];
    return mask;
}

// A picture of a file, with the scatter of its rays where `reference` has written that beside it.
Result<Picture> pictureBeside(const std::string& file, const Image& image, bool linear) {
    const fs::path beside = fs::path(file).replace_extension(".error.exr");
    std::error_code fault;
    if (!image.linear || !fs::exists(beside, fault)) return pictureOf(image, linear);
    const auto error = readImage(beside, true);
    if (!error) return error.error();
    if (error->width != image.width || error->height != image.height)
        return unsound(fmt::format("has {}x{} standard errors of {}x{} pixels", error->width, error->height,
                                   image.width, image.height),
                       "trace the picture again, or remove it")
            .at(beside);
    return tracedPicture(image, *error, linear);
}

Result<PicturePair> readPair(const CompareOptions& o) {
    if (Status s = checkThere(o); !s) return s.error();
    auto a = readImage(o.a, true), b = readImage(o.b, true);
    if (!a) return a.error();
    if (!b) return b.error();
    if (gray(*a) != gray(*b))
        return unsound(fmt::format("the images differ in kind: {} and {} channels", a->channels, b->channels),
                       "compare colour with colour")
            .at(o.a + ", " + o.b);
    auto mask = readMask(o.mask, *b);
    if (!mask) return mask.error();
    auto image = pictureBeside(o.a, *a, o.linear), truth = pictureBeside(o.b, *b, o.linear);
    if (!image) return image.error();
    if (!truth) return truth.error();
    auto pair = pairPictures(std::move(*image), std::move(*truth), *mask);
    if (!pair) return pair.error().at(o.a + ", " + o.b);
    return pair;
}

// --- films: two folders with pictures of the same names
// In the order of their names; the standard errors that `reference` writes beside its pictures are none.
std::vector<std::string> picturesIn(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code fault;
    for (const fs::directory_entry& e : fs::directory_iterator(folder, fault)) {
        const std::string name = e.path().filename().string();
        if (name.ends_with(".png") || (name.ends_with(".exr") && !name.ends_with(".error.exr"))) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

Result<std::vector<std::string>> filmNames(const CompareOptions& o) {
    const std::vector<std::string> a = picturesIn(o.a), b = picturesIn(o.b);
    std::vector<std::string> alone;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(alone));
    if (!alone.empty())
        return failed(alone.front() + " is in one of both folders alone", "film both with the same --frames")
            .at(o.a + ", " + o.b);
    return a;
}

struct FilmPair {
    std::vector<std::string> names;
    Popping popping;
    double appearance = 0;  // mean over the pictures
    uint64_t nonFinite = 0;
};
Result<FilmPair> compareFilms(const CompareOptions& o) {
    auto names = filmNames(o);
    if (!names) return names.error();
    FilmPair film{std::move(*names), {}, 0, 0};
    auto popped = popping(film.names.size(), [&](size_t i) -> Result<PicturePair> {
        CompareOptions one = o;
        one.a = (fs::path(o.a) / film.names[i]).string(), one.b = (fs::path(o.b) / film.names[i]).string();
        auto pair = readPair(one);
        if (!pair) return pair;
        film.appearance += appearance(*pair).distance / static_cast<double>(film.names.size());
        film.nonFinite += pair->nonFinite;
        return pair;
    });
    if (!popped) return popped.error().at(popped.error().file.empty() ? o.a + ", " + o.b : popped.error().file);
    film.popping = std::move(*popped);
    return film;
}

Json filmJson(const FilmPair& f) {
    const auto worst = static_cast<size_t>(f.popping.worstStep);
    Json j;
    j["pictures"] = static_cast<int>(f.names.size()), j["appearance"] = f.appearance, j["popping"] = f.popping.mean,
    j["popping_worst"] = f.popping.worst;
    j["change"] = std::isfinite(f.popping.change) ? Json(f.popping.change) : Json();
    j["worst_step"].push(f.names[worst]), j["worst_step"].push(f.names[worst + 1]);
    j["steps"] = Json::makeArray();
    for (const double step : f.popping.steps) j["steps"].push(step);
    j["non_finite"] = f.nonFinite;
    return j;
}

std::string filmText(const FilmPair& f) {
    const auto worst = static_cast<size_t>(f.popping.worstStep);
    return fmt::format(
        "popping      {:.5f}  mean of {} steps; at worst {:.5f}, from {} to {}\nchange       {:.2f}     times as much "
        "as "
        "in the truth\nappearance   {:.5f}  mean of {} pictures\n",
        f.popping.mean, f.popping.steps.size(), f.popping.worst, f.names[worst], f.names[worst + 1], f.popping.change,
        f.appearance, f.names.size());
}

int compareFilmsVerb(const CompareOptions& o) {
    if (!o.heatmap.empty())
        return report(usage("a heat map is of two images, not of films", "leave --heatmap out").at(o.heatmap));
    const auto film = compareFilms(o);
    if (!film) return report(film.error());
    if (film->nonFinite > 0) logWarning(fmt::format("{} pixels are not finite and were left out", film->nonFinite));
    std::printf("%s", (o.json ? writeJson(filmJson(*film)) : filmText(*film)).c_str());
    return 0;
}

}  // namespace

int compareVerb(const CompareOptions& o) {
    auto metric = parseMetric(o.metric);
    if (!metric) return report(metric.error());
    if (Status s = checkOptions(o); !s) return report(s.error());
    std::error_code fault;
    if (fs::is_directory(o.a, fault) && fs::is_directory(o.b, fault)) return compareFilmsVerb(o);
    auto pair = readPair(o);
    if (!pair) return report(pair.error());
    if (pair->nonFinite > 0)
        logWarning(fmt::format("{} pixels are not finite and were left out; the first at {},{}", pair->nonFinite,
                               pair->nonFiniteX, pair->nonFiniteY));
    const Metrics m = metricsOf(*pair, o.ppd);
    if (!o.heatmap.empty()) {
        const std::vector<uint8_t> pixels = heatmap(errorMap(*pair, *metric, o.ppd), heatScale(*metric));
        if (Status s = writeImagePng(o.heatmap, pair->truth.width, pair->truth.height, 3, pixels); !s)
            return report(s.error());
    }
    std::printf("%s", (o.json ? writeJson(metricsJson(m, *pair, o.ppd)) : metricsText(m, *pair, o.ppd)).c_str());
    return 0;
}

}  // namespace sward
