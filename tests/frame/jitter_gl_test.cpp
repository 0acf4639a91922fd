// Frames moved by fractions of a pixel sample it at other places, and so add up to a converged one.
#include "fields.h"
#include "scenes.h"
#include "techniques.h"

namespace sward::test {
namespace {

std::vector<float> drawn(Renderer& r, Project& p, glm::vec2 jitter) {
    ViewSettings s = small();
    s.jitter = jitter;
    EXPECT_TRUE(r.draw(p, eyeHeight(), s));
    return r.readLinear();
}
double distance(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(Jitter, OfWholePixelsMovesThePictureRightAndUp) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = lawn();
    p.registry.remove<GrassField>(findEntity(p, "grass"));
    const auto still = drawn(r, p, {0, 0}), moved = drawn(r, p, {3, 2});
    double worst = 0;
    for (int y = 0; y + 2 < 120; ++y)
        for (int x = 0; x + 3 < 160; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto at = [&](int u, int v) { return static_cast<size_t>((v * 160 + u) * 3 + c); };
                worst = std::max(worst, std::abs(static_cast<double>(moved[at(x + 3, y)] - still[at(x, y + 2)])));
            }
    EXPECT_LT(worst, 0.02);
    EXPECT_GT(distance(still, moved), 0.01) << "the check can fail";
}
TEST(Jitter, FramesOfOnePixelAddUpToOneThatManySamplesGive) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = lawn();
    flatField(p, "grass").technique = nameOf(Technique::Geometry);
    std::vector<float> all(160 * 120 * 3, 0), half = all;
    for (int i = 0; i < 16; ++i) {
        const auto frame =
            drawn(r, p, {static_cast<float>(i % 4) / 4 - 0.375f, static_cast<float>(i / 4) / 4 - 0.375f});
        for (size_t k = 0; k < all.size(); ++k) {
            all[k] += frame[k] / 16;
            if ((i + i / 4) % 2 == 0) half[k] += frame[k] / 8;
        }
    }
    EXPECT_LT(2 * distance(half, all), distance(drawn(r, p, {0, 0}), all));
}

}  // namespace
}  // namespace sward::test
