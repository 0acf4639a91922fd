#include "tools/tiers.h"

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

constexpr double kMost = 1e6;  // hard range of the fields

// What must lie between tier i and the next: the middle pair may meet.
double gapAfter(size_t i) { return i == 1 ? 0 : kTierGap; }

// The least that may follow `value` as tier i + 1, and the most that may come before it as tier i.
double leastAfter(size_t i, double value) { return value + gapAfter(i); }
double mostBefore(size_t i, double value) { return std::max(0.0, value - gapAfter(i)); }

// True if tier i may be a where tier i + 1 is b: at 0 and at infinity both may be the same (the tier is left out).
bool inOrder(size_t i, double a, double b) {
    if (a == b && (a == 0 || std::isinf(a))) return true;
    return i == 1 ? a <= b : a < b;
}

double fourDigits(double v) {
    const double step = std::pow(10, std::floor(std::log10(v)) - 3);
    return std::round(v / step) * step;
}

}  // namespace

TierDistances tiersOf(const HybridTiers& f) { return {f.minGeom, f.maxGeom, f.minBTF, f.maxBTF}; }

std::vector<TierEdit> tierEdits(const TierDistances& wanted, TiersBy by, const BladeSize& blades,
                                float pixelsPerMetre) {
    std::vector<TierEdit> edits;
    for (size_t i = 0; i < kTierCount; ++i) edits.push_back({kTierFields[i], wanted[i]});
    const auto seen = [&](const char* field, float metres, double distance) {
        const double pixels = static_cast<double>(metres * pixelsPerMetre) / distance;
        if (by == TiersBy::Pixels && std::isfinite(pixels) && pixels > 0)
            edits.push_back({field, fourDigits(std::clamp(pixels, 0.01, 1e3))});
    };
    seen("bladePixels", blades.width, wanted[1]);
    seen("slicePixels", blades.height, wanted[3]);
    return edits;
}

bool tiersInOrder(const TierDistances& t) {
    for (size_t i = 0; i + 1 < kTierCount; ++i)
        if (!inOrder(i, t[i], t[i + 1])) return false;
    return true;
}

double stoppedTier(const TierDistances& t, size_t i, double wanted) {
    const double low = i > 0 ? leastAfter(i - 1, t[i - 1]) : 0;
    const double high = i + 1 < kTierCount ? mostBefore(i, t[i + 1]) : kMost;
    if (!(wanted >= 0)) wanted = 0;
    if (low > high && (i == 0 || i + 1 == kTierCount)) return t[i];
    if (low > high) return t[i - 1] > t[i + 1] ? std::min(wanted, kMost) : t[i];
    return std::clamp(wanted, low, std::min(high, kMost));
}

TierDistances pushedTiers(TierDistances t, size_t i, double value) {
    t[i] = std::max(value, 0.0);
    for (size_t k = i; k + 1 < kTierCount; ++k)
        if (!inOrder(k, t[k], t[k + 1])) t[k + 1] = leastAfter(k, t[k]);
    for (size_t k = i; k-- > 0;)
        if (!inOrder(k, t[k], t[k + 1])) t[k] = mostBefore(k, t[k + 1]);
    return t;
}

TierDistances orderedTiers(TierDistances t) {
    std::sort(t.begin(), t.end());
    return pushedTiers(t, 0, t[0]);
}

double roundedTier(double metres) {
    if (!(metres > 0) || std::isinf(metres)) return std::max(metres, 0.0);
    const double step = 0.05 * std::pow(10, std::max(std::floor(std::log10(metres)) - 1, 0.0));
    return std::round(metres / step) * step;
}

}  // namespace sward
