#include "metrics/picture_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/appearance.h"

namespace sward {
namespace {

void hold(PictureVerdict& v, const char* what, double is, double may, const char* unit) {
    if (is <= may) return;
    v.why += fmt::format("{}{} {:.4g}{}, more than {:.4g}", v.why.empty() ? "" : "; ", what, is, unit, may);
}

}  // namespace

PictureVerdict judgePicture(const PicturePair& pair, const AcceptedPicture& t) {
    PictureVerdict v;
    const double limit = static_cast<double>(t.pixelOff) + 1e-3;  // of whole steps, as files have them
    double sum = 0;
    size_t off = 0, finite = 0;
    for (size_t i = 0; i < pair.image.pixels.size(); ++i) {
        if (pair.weight[i] <= 0) {
            ++off;
            continue;
        }
        const glm::vec3 d = 255.f * glm::abs(pair.image.pixels[i] - pair.truth.pixels[i]);
        sum += static_cast<double>(d.x) + static_cast<double>(d.y) + static_cast<double>(d.z);
        off += static_cast<double>(std::max({d.x, d.y, d.z})) > limit;
        ++finite;
    }
    v.meanOff = sum / static_cast<double>(3 * std::max<size_t>(finite, 1));
    v.pixelsOff = 100 * static_cast<double>(off) / static_cast<double>(std::max<size_t>(pair.image.pixels.size(), 1));
    v.appearance = appearance(pair).distance;
    if (pair.nonFinite > 0) v.why = fmt::format("{} pixels are not finite", pair.nonFinite);
    hold(v, "mean off", v.meanOff, static_cast<double>(t.meanOff), " of 255");
    hold(v, "pixels off", v.pixelsOff, static_cast<double>(t.pixelsOff), " %");
    hold(v, "appearance", v.appearance, static_cast<double>(t.appearance), "");
    v.pass = v.why.empty();
    return v;
}

std::string verdictText(const PictureVerdict& v) {
    return fmt::format("mean {:.3g} of 255, {:.3g} % of pixels off, appearance {:.2g}", v.meanOff, v.pixelsOff,
                       v.appearance);
}

}  // namespace sward
