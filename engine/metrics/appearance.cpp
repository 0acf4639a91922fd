#include "metrics/appearance.h"

#include "core/jobs.h"

namespace sward {
namespace {

constexpr int kLargest = 16;

double mean3(const glm::dvec3& v) { return (v.x + v.y + v.z) / 3; }

struct BlockError {
    double weight = 0, distance = 0, bias = 0, contrast = 0;
};
BlockError blockError(const PicturePair& p, int x0, int y0, int side) {
    const BlockMoments a = blockMoments(p.image, p.weight, x0, y0, side),
                       b = blockMoments(p.truth, p.weight, x0, y0, side);
    const glm::dvec3 mean = apart(a.mean - b.mean, a.meanNoise + b.meanNoise),
                     deviation = apart(a.deviation - b.deviation, a.deviationNoise + b.deviationNoise);
    return {b.weight, mean3(glm::sqrt(mean * mean + deviation * deviation)), mean3(mean), mean3(deviation)};
}

// One of the largest blocks with all the smaller ones in it: their errors times their weights, a third for each size.
BlockError sumOver(const PicturePair& p, int x0, int y0) {
    BlockError sum;
    for (const int side : kAppearanceBlocks)
        for (int y = y0; y < std::min(y0 + kLargest, p.truth.height); y += side)
            for (int x = x0; x < std::min(x0 + kLargest, p.truth.width); x += side) {
                const BlockError e = blockError(p, x, y, side);
                const double w = e.weight / static_cast<double>(std::size(kAppearanceBlocks));
                sum.weight += w, sum.distance += w * e.distance, sum.bias += w * e.bias, sum.contrast += w * e.contrast;
            }
    return sum;
}

std::vector<BlockError> largestBlocks(const PicturePair& p) {
    const int across = (p.truth.width + kLargest - 1) / kLargest, down = (p.truth.height + kLargest - 1) / kLargest;
    std::vector<BlockError> blocks(static_cast<size_t>(across) * static_cast<size_t>(down));
    parallelFor(blocks.size(), [&](size_t i) {
        blocks[i] = sumOver(p, static_cast<int>(i) % across * kLargest, static_cast<int>(i) / across * kLargest);
    });
    std::erase_if(blocks, [](const BlockError& b) { return b.weight <= 0; });
    return blocks;
}

// Standard error of sum(distance) / sum(weight) by leaving out one block at a time (Quenouille 1956, Tukey 1958).
double jackknife(const std::vector<BlockError>& blocks, const BlockError& all) {
    const double n = static_cast<double>(blocks.size());
    if (n < 2) return std::numeric_limits<double>::quiet_NaN();
    double sum = 0, squares = 0;
    for (const BlockError& b : blocks) {
        const double without = (all.distance - b.distance) / (all.weight - b.weight) - all.distance / all.weight;
        sum += without, squares += without * without;
    }
    return std::sqrt(std::max(0.0, (n - 1) / n * (squares - sum * sum / n)));
}

}  // namespace

Deviation deviationBeside(const glm::dvec3& squares, const glm::dvec3& scatter, const glm::dvec3& meanNoise) {
    const glm::dvec3 added = scatter - meanNoise;
    Deviation d;
    d.variance = glm::max(squares - added, 0.0);
    d.noise = meanNoise * (d.variance + added / 2.0) / glm::max(d.variance + added, 1e-30);
    d.deviation = glm::sqrt(d.variance + d.noise);
    return d;
}

glm::dvec3 apart(const glm::dvec3& difference, const glm::dvec3& noise) {
    return glm::sqrt(glm::max(difference * difference - noise, 0.0));
}

BlockMoments blockMoments(const Picture& picture, const std::vector<float>& weight, int x0, int y0, int side) {
    BlockMoments b;
    const int x1 = std::min(x0 + side, picture.width), y1 = std::min(y0 + side, picture.height);
    const auto each = [&](auto&& body) {
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const size_t i = static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x);
                if (weight[i] > 0) body(static_cast<double>(weight[i]), glm::dvec3(picture.pixels[i]), i);
            }
    };
    each([&](double w, const glm::dvec3& v, size_t) { b.weight += w, b.mean += w * v; });
    if (b.weight <= 0) return b;
    b.mean /= b.weight;
    glm::dvec3 squares(0), scatter(0);
    each([&](double w, const glm::dvec3& v, size_t i) {
        squares += w * (v - b.mean) * (v - b.mean);
        if (picture.noise.empty()) return;
        const glm::dvec3 noise(picture.noise[i]);
        scatter += w * noise, b.meanNoise += w * w / (b.weight * b.weight) * noise;
    });
    const Deviation d = deviationBeside(squares / b.weight, scatter / b.weight, b.meanNoise);
    b.deviation = d.deviation, b.deviationNoise = d.noise;
    return b;
}

Appearance appearance(const PicturePair& pair) {
    const std::vector<BlockError> blocks = largestBlocks(pair);
    BlockError all;
    for (const BlockError& b : blocks)
        all.weight += b.weight, all.distance += b.distance, all.bias += b.bias, all.contrast += b.contrast;
    return {all.distance / all.weight, all.bias / all.weight, all.contrast / all.weight, jackknife(blocks, all)};
}

ErrorMap appearanceMap(const PicturePair& pair) {
    ErrorMap map(pair.weight.size(), 0);
    for (const int side : kAppearanceBlocks)
        parallelFor(static_cast<size_t>((pair.truth.height + side - 1) / side), [&](size_t row) {
            const int y0 = static_cast<int>(row) * side;
            for (int x0 = 0; x0 < pair.truth.width; x0 += side) {
                const float e = static_cast<float>(blockError(pair, x0, y0, side).distance /
                                                   static_cast<double>(std::size(kAppearanceBlocks)));
                for (int y = y0; y < std::min(y0 + side, pair.truth.height); ++y)
                    for (int x = x0; x < std::min(x0 + side, pair.truth.width); ++x)
                        map[static_cast<size_t>(y) * static_cast<size_t>(pair.truth.width) + static_cast<size_t>(x)] +=
                            e;
            }
        });
    for (size_t i = 0; i < map.size(); ++i)
        if (pair.weight[i] <= 0) map[i] = kNoValue;
    return map;
}

}  // namespace sward
