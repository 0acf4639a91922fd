// What a technique is from the truth follows from the scene, not from how many rays the truth was given.
#include "metrics/picture.h"

#include "metrics/appearance.h"
#include "metrics/pictures.h"
#include "reference/reference.h"
#include "scenes.h"

namespace sward::test {
namespace {

Truth truthOf(const Project& p, int samples) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    ReferenceSettings s;
    s.width = small().width, s.height = small().height, s.samples = samples, s.seed = static_cast<uint32_t>(samples);
    auto truth = scene->trace(eyeHeight(), s, control);
    EXPECT_TRUE(truth);
    return std::move(*truth);
}

TEST(TracedPictures, TheErrorOfATechniqueIsTheSameAgainst16And64And256Rays) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = lawn();
    ASSERT_TRUE(r.draw(p, eyeHeight(), small()));
    const Picture drawn = pictureOfLinear(small().width, small().height, r.readLinear());
    std::vector<Appearance> known, unknown;
    // By the grass of one truth: of which pixels count, few rays know little, too.
    const std::vector<float> grass = truthOf(p, 256).grass;
    for (const int samples : {16, 64, 256}) {
        const Truth t = truthOf(p, samples);
        known.push_back(appearance(pairOf(drawn, tracedPicture(t.width, t.height, t.color, t.error), grass)));
        unknown.push_back(appearance(pairOf(drawn, pictureOfLinear(t.width, t.height, t.color), grass)));
        std::printf("  %3d rays: %.5f +- %.5f, with the rays' scatter as contrast %.5f\n", samples,
                    known.back().distance, known.back().sigma, unknown.back().distance);
    }
    const double sigma = known[2].sigma;
    EXPECT_NEAR(known[0].distance, known[2].distance, sigma);
    EXPECT_NEAR(known[1].distance, known[2].distance, sigma);
    EXPECT_GT(std::abs(unknown[0].distance - unknown[2].distance), sigma);
}

}  // namespace
}  // namespace sward::test
