#include "metrics/popping.h"

#include "core/jobs.h"
#include "metrics/appearance.h"

namespace sward {
namespace {

using Channels = std::array<glm::dvec3, 2>;  // of a block's mean, and of its deviation

// What changes in the blocks of one cell of one picture.
struct CellChange {
    double weight = 0;
    Channels mean{}, deviation{};
    Channels meanNoise{}, deviationNoise{};  // their variances by the scatter of rays
    double squares = 0;                      // mean square over both changes and channels
};

// One block's changes, and their variances by the scatter of rays.
struct BlockChange {
    double weight = 0;
    Channels by{}, noise{};
};
BlockChange changeOf(const Picture& before, const Picture& after, const std::vector<float>& weight, int x, int y) {
    const BlockMoments a = blockMoments(before, weight, x, y, kPoppingBlock);
    if (a.weight <= 0) return {};
    const BlockMoments b = blockMoments(after, weight, x, y, kPoppingBlock);
    return {a.weight,
            {b.mean - a.mean, b.deviation - a.deviation},
            {a.meanNoise + b.meanNoise, a.deviationNoise + b.deviationNoise}};
}

CellChange cellChange(const Picture& before, const Picture& after, const std::vector<float>& weight, int x0, int y0) {
    std::array<BlockChange, (kPoppingCell / kPoppingBlock) * (kPoppingCell / kPoppingBlock)> blocks;
    size_t n = 0;
    CellChange cell;
    for (int y = y0; y < std::min(y0 + kPoppingCell, after.height); y += kPoppingBlock)
        for (int x = x0; x < std::min(x0 + kPoppingCell, after.width); x += kPoppingBlock) {
            const BlockChange& b = blocks[n++] = changeOf(before, after, weight, x, y);
            cell.weight += b.weight;
            for (size_t k = 0; k < 2; ++k) cell.mean[k] += b.weight * b.by[k];
        }
    if (cell.weight <= 0) return cell;
    for (size_t k = 0; k < 2; ++k) {
        cell.mean[k] /= cell.weight;
        glm::dvec3 squares(0), scatter(0);
        for (size_t i = 0; i < n; ++i) {
            const double share = blocks[i].weight / cell.weight;
            const glm::dvec3 off = blocks[i].by[k] - cell.mean[k];
            squares += share * off * off, scatter += share * blocks[i].noise[k];
            cell.meanNoise[k] += share * share * blocks[i].noise[k];
        }
        const Deviation d = deviationBeside(squares, scatter, cell.meanNoise[k]);
        cell.deviation[k] = d.deviation, cell.deviationNoise[k] = d.noise;
        cell.squares += glm::dot(cell.mean[k] * cell.mean[k] - cell.meanNoise[k] + d.variance, glm::dvec3(1)) / 3;
    }
    return cell;
}

double distanceOf(const CellChange& image, const CellChange& truth) {
    glm::dvec3 squares(0);
    for (size_t k = 0; k < 2; ++k) {
        const glm::dvec3 mean = apart(image.mean[k] - truth.mean[k], image.meanNoise[k] + truth.meanNoise[k]),
                         deviation = apart(image.deviation[k] - truth.deviation[k],
                                           image.deviationNoise[k] + truth.deviationNoise[k]);
        squares += mean * mean + deviation * deviation;
    }
    return glm::dot(glm::sqrt(squares), glm::dvec3(1)) / 3;
}

struct StepChange {
    double weight = 0, distance = 0, image = 0, truth = 0;  // all but the weight times it; the last two are squares
};
StepChange stepChange(const PicturePair& before, const PicturePair& after) {
    std::vector<float> weight(after.weight.size());
    for (size_t i = 0; i < weight.size(); ++i) weight[i] = std::min(before.weight[i], after.weight[i]);
    const int across = (after.truth.width + kPoppingCell - 1) / kPoppingCell,
              down = (after.truth.height + kPoppingCell - 1) / kPoppingCell;
    std::vector<StepChange> cells(static_cast<size_t>(across) * static_cast<size_t>(down));
    parallelFor(cells.size(), [&](size_t i) {
        const int x = static_cast<int>(i) % across * kPoppingCell, y = static_cast<int>(i) / across * kPoppingCell;
        const CellChange image = cellChange(before.image, after.image, weight, x, y),
                         truth = cellChange(before.truth, after.truth, weight, x, y);
        const double w = truth.weight;
        cells[i] = {w, w * distanceOf(image, truth), w * image.squares, w * truth.squares};
    });
    StepChange all;
    for (const StepChange& c : cells)
        all.weight += c.weight, all.distance += c.distance, all.image += c.image, all.truth += c.truth;
    return all;
}

double poppingOf(const StepChange& c) {
    if (c.weight <= 0) return 0;
    const auto inAll = [&](double squares) { return std::sqrt(std::max(squares, 0.0) / c.weight); };
    return std::max(c.distance / c.weight, std::abs(inAll(c.image) - inAll(c.truth)));
}

}  // namespace

Result<Popping> popping(size_t pictures, const std::function<Result<PicturePair>(size_t)>& picture) {
    if (pictures < 2) return failed("popping takes at least two pictures of a path", "take more");
    Popping out;
    double image = 0, truth = 0;
    auto before = picture(0);
    if (!before) return before.error();
    for (size_t i = 1; i < pictures; ++i) {
        auto after = picture(i);
        if (!after) return after.error();
        if (after->truth.width != before->truth.width || after->truth.height != before->truth.height)
            return failed(fmt::format("picture {} of the path differs in size from the first", i),
                          "render all at one --size");
        const StepChange change = stepChange(*before, *after);
        const double step = out.steps.emplace_back(poppingOf(change));
        image += change.image, truth += change.truth;
        out.mean += step / static_cast<double>(pictures - 1);
        if (out.worstStep < 0 || step > out.worst) out.worst = step, out.worstStep = static_cast<int>(i) - 1;
        before = std::move(after);
    }
    out.change = truth > 0 ? std::sqrt(std::max(image, 0.0) / truth) : std::numeric_limits<double>::quiet_NaN();
    return out;
}

}  // namespace sward
