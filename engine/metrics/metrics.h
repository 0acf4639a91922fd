// All metrics of a pair of pictures, and each one's map: what `sward compare` prints and `sward cost` tabulates.
// Definitions and sources: appearance.h, flip.h, ssim.h; which one to trust for what: docs/accuracy.md.
// Does not: read files (the caller does).
#pragma once
#include <string>

#include "core/enum_names.h"
#include "core/json.h"
#include "metrics/appearance.h"
#include "metrics/flip.h"
#include "metrics/picture.h"

namespace sward {

// Means by the pixels' weights. Not-a-number where a metric has no value: no window fits or all hold a bad pixel.
struct Metrics {
    Appearance appearance;
    double flip = 0;
    double ssim = 0;
    double rmse = 0;  // over all channels
    double psnr = 0;  // dB of a peak of 1; infinite for equal pictures
};
// All metrics of a pair; pixelsPerDegree, above 0, is FLIP's.
Metrics metricsOf(const PicturePair& pair, double pixelsPerDegree = kPixelsPerDegree);

enum class ErrorMetric { Appearance, Flip, Rmse, Ssim };
inline constexpr auto kErrorMetrics = enumNames<ErrorMetric>("appearance", "flip", "rmse", "ssim");
// The metric at each pixel, as an error: of SSIM 1 - ssim, of RMSE over the channels of one pixel.
ErrorMap errorMap(const PicturePair& pair, ErrorMetric metric, double pixelsPerDegree = kPixelsPerDegree);
// The error that a heat map shows in its brightest colour: 0.2 of appearance, 1 of FLIP and SSIM, 0.5 of RMSE.
double heatScale(ErrorMetric metric);

// {"appearance", "appearance_sigma", "bias", "contrast", "flip", "ppd", "ssim", "rmse", "psnr", "image_noise",
// "truth_noise", "pixels", "non_finite", "first_non_finite": [x, y]}. Infinite psnr is "inf", what has no value null:
// so the noise of a picture of which none is known (Picture::noise; root of the mean variance).
Json metricsJson(const Metrics& metrics, const PicturePair& pair, double pixelsPerDegree);
// The same as lines for people.
std::string metricsText(const Metrics& metrics, const PicturePair& pair, double pixelsPerDegree);

}  // namespace sward
