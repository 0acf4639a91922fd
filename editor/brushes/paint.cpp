#include "brushes/paint.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace sward {

StampWeights::StampWeights(const MapInfo& info, const Stamp& stamp, const BrushSettings& brush, int tx, int ty)
    : shape_(stamp, brush, tx, ty) {
    const double rx = std::max(stamp.radiusX, 1.0), ry = std::max(stamp.radiusY, 1.0);
    const double edge = std::clamp(std::max<double>(brush.falloff, 1.0 / std::min(rx, ry)), 0.0, 1.0);
    const double core = 1.0 - edge;
    const double cover = std::min(stamp.radiusX, 1.0) * std::min(stamp.radiusY, 1.0);
    centreX_ = static_cast<float>(stamp.x - tx * kTileSize - 0.5);
    centreY_ = static_cast<float>(stamp.y - ty * kTileSize - 0.5);
    invX_ = static_cast<float>(1.0 / rx);
    invY_ = static_cast<float>(1.0 / ry);
    farthest_ = static_cast<float>(std::pow((shape_.any() ? stamp.reach : 1) + stamp.spread / ry, 2));
    spreads_ = stamp.spread > 0;
    invRange_ = static_cast<float>(1.0 / (1.0 - core * core));
    strength_ = static_cast<float>(std::clamp<double>(brush.strength, 0.0, 1.0) * cover);
    acrossX_ = static_cast<float>(stamp.acrossX / rx);
    acrossY_ = static_cast<float>(stamp.acrossY / ry);
    columns_ = std::min(kTileSize, info.width - tx * kTileSize);
    rows_ = std::min(kTileSize, info.height - ty * kTileSize);
}

bool StampWeights::row(int y, float* weight) const {
    const float dy = (static_cast<float>(y) - centreY_) * invY_;
    const float beyond = dy - std::clamp(dy, std::min(acrossY_, 0.0f), std::max(acrossY_, 0.0f));
    if (y >= rows_ || !(beyond * beyond < farthest_)) return false;
    alignas(64) float w[kTileSize];
    if (acrossX_ != 0 || acrossY_ != 0) {
        along(dy, w);
        std::fill(w + columns_, w + kTileSize, 0.0f);
        std::memcpy(weight, w, sizeof w);
        return true;
    }
    if (shape_.any()) {
        if (!shape_.row(y, w) && !spreads_) return false;
        for (float& at : w) at *= strength_;
        std::fill(w + columns_, w + kTileSize, 0.0f);
        std::memcpy(weight, w, sizeof w);
        return true;
    }
    const float dy2 = dy * dy;
    for (int from = 0; from < kTileSize; from += kPaintBlock) {
        const float first = static_cast<float>(from), last = first + kPaintBlock - 1,
                    nearest = (std::clamp(centreX_, first, last) - centreX_) * invX_;
        if (nearest * nearest + dy2 >= 1) {  // a block beside the ring
            std::fill_n(w + from, kPaintBlock, 0.0f);
            continue;
        }
        for (int i = from; i < from + kPaintBlock; ++i) {
            const float dx = (static_cast<float>(i) - centreX_) * invX_;
            const float t = unitPart((1.0f - (dx * dx + dy2)) * invRange_);
            w[i] = strength_ * (t * t * (3.0f - 2.0f * t));
        }
    }
    std::fill(w + columns_, w + kTileSize, 0.0f);
    std::memcpy(weight, w, sizeof w);
    return true;
}

// By the distance to the nearest point of the way.
void StampWeights::along(float dy, float* weight) const {
    const float length2 = acrossX_ * acrossX_ + acrossY_ * acrossY_;
    for (int i = 0; i < kTileSize; ++i) {
        const float dx = (static_cast<float>(i) - centreX_) * invX_;
        const float share = unitPart((dx * acrossX_ + dy * acrossY_) / length2);
        const float x = dx - share * acrossX_, y = dy - share * acrossY_;
        const float t = unitPart((1.0f - (x * x + y * y)) * invRange_);
        weight[i] = strength_ * (t * t * (3.0f - 2.0f * t));
    }
}

PaintedForce forceOfTexel(const double* texel) {
    const auto part = [&](double v) { return std::abs(v - 0.5) < 0.75 / 255 ? 0.0 : 2 * v - 1; };
    return {part(texel[0]) * texel[3], part(texel[1]) * texel[3], texel[2] * texel[3], texel[3]};
}

void texelOfForce(const PaintedForce& force, double* texel) {
    const double share = std::clamp(force.share, 0.0, 1.0);
    texel[3] = share;
    if (share < 1e-6) {
        texel[0] = texel[1] = 0.5, texel[2] = 0;
        return;
    }
    texel[0] = std::clamp(0.5 + 0.5 * force.x / share, 0.0, 1.0);
    texel[1] = std::clamp(0.5 + 0.5 * force.z / share, 0.0, 1.0);
    texel[2] = std::clamp(force.press / share, 0.0, 1.0);
}

bool usableBrush(const Stamp& stamp, const BrushSettings& b) {
    const bool finite = std::isfinite(stamp.x) && std::isfinite(stamp.y) && std::isfinite(stamp.radiusX) &&
                        std::isfinite(stamp.radiusY) && std::isfinite(b.strength) && std::isfinite(b.value) &&
                        std::isfinite(b.falloff) && std::isfinite(b.color.x + b.color.y + b.color.z) &&
                        std::isfinite(b.low) && std::isfinite(b.high) && std::isfinite(b.metres.x) &&
                        std::isfinite(b.metres.y) && b.metres.y != 0;
    return finite && stamp.radiusX > 0 && stamp.radiusY > 0 && b.strength > 0 && b.low <= b.high;
}

}  // namespace sward
