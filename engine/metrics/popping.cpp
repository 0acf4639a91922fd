#include "metrics/popping.h"

#include "core/jobs.h"
#include "metrics/appearance.h"

namespace sward {
namespace {

struct Sum {
    double weight = 0, error = 0;
};

// The distance of one block's changes times its weight.
Sum blockChange(const PicturePair& before, const PicturePair& after, const std::vector<float>& weight, int x, int y,
                int side) {
    const BlockMoments truth = blockMoments(after.truth, weight, x, y, side);
    if (truth.weight <= 0) return {};
    const BlockMoments image = blockMoments(after.image, weight, x, y, side);
    const BlockMoments imageBefore = blockMoments(before.image, weight, x, y, side),
                       truthBefore = blockMoments(before.truth, weight, x, y, side);
    const glm::dvec3 mean = (image.mean - imageBefore.mean) - (truth.mean - truthBefore.mean);
    const glm::dvec3 deviation = (image.deviation - imageBefore.deviation) - (truth.deviation - truthBefore.deviation);
    const glm::dvec3 distance = glm::sqrt(mean * mean + deviation * deviation);
    return {truth.weight, truth.weight * (distance.x + distance.y + distance.z) / 3};
}

double stepPopping(const PicturePair& before, const PicturePair& after) {
    std::vector<float> weight(after.weight.size());
    for (size_t i = 0; i < weight.size(); ++i) weight[i] = std::min(before.weight[i], after.weight[i]);
    double sum = 0;
    for (const int side : kAppearanceBlocks) {
        const int across = (after.truth.width + side - 1) / side, down = (after.truth.height + side - 1) / side;
        std::vector<Sum> blocks(static_cast<size_t>(across) * static_cast<size_t>(down));
        parallelFor(blocks.size(), [&](size_t i) {
            blocks[i] = blockChange(before, after, weight, static_cast<int>(i) % across * side,
                                    static_cast<int>(i) / across * side, side);
        });
        Sum all;
        for (const Sum& b : blocks) all.weight += b.weight, all.error += b.error;
        if (all.weight > 0) sum += all.error / all.weight;
    }
    return sum / static_cast<double>(std::size(kAppearanceBlocks));
}

}  // namespace

Result<Popping> popping(size_t pictures, const std::function<Result<PicturePair>(size_t)>& picture) {
    if (pictures < 2) return failed("popping takes at least two pictures of a path", "take more");
    Popping out;
    auto before = picture(0);
    if (!before) return before.error();
    for (size_t i = 1; i < pictures; ++i) {
        auto after = picture(i);
        if (!after) return after.error();
        if (after->truth.width != before->truth.width || after->truth.height != before->truth.height)
            return failed(fmt::format("picture {} of the path differs in size from the first", i),
                          "render all at one --size");
        const double step = out.steps.emplace_back(stepPopping(*before, *after));
        out.mean += step / static_cast<double>(pictures - 1);
        if (out.worstStep < 0 || step > out.worst) out.worst = step, out.worstStep = static_cast<int>(i) - 1;
        before = std::move(after);
    }
    return out;
}

}  // namespace sward
