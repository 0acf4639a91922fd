#include "cost/paired_frames.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace sward {
namespace {

constexpr double kWanted = 0.95;

// That the median lies between the k-th and the k-th last of n ordered values, k from 1: all but the chance that fewer
// than k of n lie on one side of it.
double confidenceOf(int n, int k) {
    double chance = 0, choose = std::exp2(-n);
    for (int i = 0; i < k; ++i) {
        chance += choose;
        choose *= static_cast<double>(n - i) / (i + 1);
    }
    return std::max(0.0, 1 - 2 * chance);
}

// Two digits, but no less than hundredths and no exponents.
std::string msText(double ms) {
    if (std::abs(ms) < 0.005) return "0";
    return fmt::format("{:.{}f}", ms, std::abs(ms) < 0.995 ? 2 : std::abs(ms) < 9.95 ? 1 : 0);
}

int framesAPair(const PairedFrames& f) { return f.settles ? 4 : 2; }

struct NextFrame {
    size_t side;
    bool counts;
};
NextFrame nextOf(const PairedFrames& f) {
    const int pair = f.drawn / framesAPair(f), within = f.drawn % framesAPair(f);
    const int half = f.settles ? within / 2 : within;
    return {static_cast<size_t>((pair + half) % 2), !f.settles || within % 2 == 1};
}

}  // namespace

PairedDifference pairedDifference(std::span<const double> a, std::span<const double> b) {
    std::vector<double> d;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) d.push_back(a[i] - b[i]);
    PairedDifference out;
    if (d.empty()) return out;
    std::sort(d.begin(), d.end());
    const size_t n = d.size();
    out.pairs = static_cast<int>(n);
    out.median = (d[(n - 1) / 2] + d[n / 2]) / 2;
    int k = 1;
    while (2 * (k + 1) <= out.pairs && confidenceOf(out.pairs, k + 1) >= kWanted) ++k;
    out.low = d[static_cast<size_t>(k) - 1], out.high = d[n - static_cast<size_t>(k)];
    out.confidence = confidenceOf(out.pairs, k);
    return out;
}

std::string differenceText(const PairedDifference& ms, bool sign) {
    const char* plus = sign && ms.median > 0 ? "+" : "";
    return fmt::format("{}{} ms ({} to {})", plus, msText(ms.median), msText(ms.low), msText(ms.high));
}

int framesOf(const PairedFrames& f) { return f.pairs * framesAPair(f); }
bool allDrawn(const PairedFrames& f) { return f.drawn >= framesOf(f); }

Status drawNext(PairedFrames& f, const std::array<FrameSide, 2>& sides, const ViewCamera& camera,
                const ViewSettings& settings) {
    const NextFrame next = nextOf(f);
    const FrameSide& side = sides[next.side];
    ViewSettings view = settings;
    view.counted = true;
    side.renderer.finish();
    const auto start = std::chrono::steady_clock::now();
    if (Status s = side.renderer.draw(side.project, camera, view); !s) return s;
    side.renderer.finish();
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    ++f.drawn;
    if (!next.counts) return {};
    f.ms[next.side].push_back(ms);
    f.blades[next.side].push_back(static_cast<double>(side.renderer.stats().bladesGeometry));
    return {};
}

void interrupt(PairedFrames& f) {
    if (f.settles && !allDrawn(f) && nextOf(f).counts) --f.drawn;
}

PairedDifference msBetween(const PairedFrames& f) { return pairedDifference(f.ms[0], f.ms[1]); }
PairedDifference bladesBetween(const PairedFrames& f) { return pairedDifference(f.blades[0], f.blades[1]); }

}  // namespace sward
