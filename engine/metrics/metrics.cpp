#include "metrics/metrics.h"

#include <algorithm>

#include "metrics/ssim.h"

namespace sward {
namespace {

double squaredError(const PicturePair& p, size_t i) {
    const glm::dvec3 e = glm::dvec3(p.image.pixels[i]) - glm::dvec3(p.truth.pixels[i]);
    return glm::dot(e, e) / 3;
}
double rmseOf(const PicturePair& p) {
    double sum = 0;
    for (size_t i = 0; i < p.weight.size(); ++i)
        if (p.weight[i] > 0) sum += static_cast<double>(p.weight[i]) * squaredError(p, i);
    return std::sqrt(sum / p.weightSum);
}
// Root of the mean variance of a picture's values by its rays; not-a-number where none is known.
double noiseOf(const Picture& p, const std::vector<float>& weight) {
    double sum = 0, weights = 0;
    for (size_t i = 0; i < p.noise.size(); ++i)
        if (weight[i] > 0)
            sum += static_cast<double>(weight[i] * (p.noise[i].x + p.noise[i].y + p.noise[i].z) / 3),
                weights += static_cast<double>(weight[i]);
    return weights > 0 ? std::sqrt(sum / weights) : std::numeric_limits<double>::quiet_NaN();
}
Json number(double v) { return std::isnan(v) ? Json() : Json(v); }
std::string text(double v, const char* format) {
    return std::isnan(v) ? "none" : std::isinf(v) ? "inf" : fmt::format(fmt::runtime(format), v);
}

}  // namespace

Metrics metricsOf(const PicturePair& pair, double pixelsPerDegree) {
    Metrics m;
    m.appearance = appearance(pair);
    m.flip = weightedMean(flipMap(pair, pixelsPerDegree), pair.weight);
    m.ssim = weightedMean(ssimMap(pair), pair.weight);
    m.rmse = rmseOf(pair);
    m.psnr = m.rmse > 0 ? -20 * std::log10(m.rmse) : std::numeric_limits<double>::infinity();
    return m;
}

ErrorMap errorMap(const PicturePair& pair, ErrorMetric metric, double pixelsPerDegree) {
    if (metric == ErrorMetric::Appearance) return appearanceMap(pair);
    if (metric == ErrorMetric::Flip) return flipMap(pair, pixelsPerDegree);
    ErrorMap map = metric == ErrorMetric::Ssim ? ssimMap(pair) : ErrorMap(pair.weight.size());
    for (size_t i = 0; i < map.size(); ++i)
        map[i] = metric == ErrorMetric::Ssim ? 1 - map[i] : static_cast<float>(std::sqrt(squaredError(pair, i)));
    return map;
}

double heatScale(ErrorMetric metric) {
    return metric == ErrorMetric::Appearance ? 0.2 : metric == ErrorMetric::Rmse ? 0.5 : 1.0;
}

Json metricsJson(const Metrics& m, const PicturePair& pair, double pixelsPerDegree) {
    Json j;
    j["appearance"] = number(m.appearance.distance);
    j["appearance_sigma"] = number(m.appearance.sigma);
    j["bias"] = number(m.appearance.bias);
    j["contrast"] = number(m.appearance.contrast);
    j["flip"] = number(m.flip);
    j["ppd"] = pixelsPerDegree;
    j["ssim"] = number(m.ssim);
    j["rmse"] = number(m.rmse);
    j["psnr"] = number(m.psnr);
    j["image_noise"] = number(noiseOf(pair.image, pair.weight)),
    j["truth_noise"] = number(noiseOf(pair.truth, pair.weight));
    j["pixels"] =
        static_cast<uint64_t>(std::count_if(pair.weight.begin(), pair.weight.end(), [](float w) { return w > 0; }));
    j["non_finite"] = pair.nonFinite;
    if (pair.nonFinite > 0) j["first_non_finite"] = Json(Json::Array{pair.nonFiniteX, pair.nonFiniteY});
    return j;
}

std::string metricsText(const Metrics& m, const PicturePair& pair, double pixelsPerDegree) {
    std::string out = fmt::format("appearance  {} +- {}   (bias {}, contrast {})\n",
                                  text(m.appearance.distance, "{:.5f}"), text(m.appearance.sigma, "{:.5f}"),
                                  text(m.appearance.bias, "{:.5f}"), text(m.appearance.contrast, "{:.5f}"));
    out += fmt::format("flip        {}   (at {} pixels per degree)\n", text(m.flip, "{:.6f}"),
                       shortestText(pixelsPerDegree));
    out += fmt::format("ssim        {}\nrmse        {}\npsnr        {}\n", text(m.ssim, "{:.6f}"),
                       text(m.rmse, "{:.6f}"), text(m.psnr, "{:.2f} dB"));
    for (const auto& [name, picture] : {std::pair{"image", &pair.image}, std::pair{"truth", &pair.truth}})
        if (const double noise = noiseOf(*picture, pair.weight); std::isfinite(noise))
            out +=
                fmt::format("noise       {:.5f}   of the {}'s rays, no part of appearance's contrast\n", noise, name);
    if (pair.nonFinite > 0)
        out += fmt::format("not finite  {} pixels, left out; the first at {},{}\n", pair.nonFinite, pair.nonFiniteX,
                           pair.nonFiniteY);
    return out;
}

}  // namespace sward
