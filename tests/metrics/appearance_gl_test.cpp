// Which metric ranks pictures of grass as one sees them? Converged pictures of all blades, without noise of sampling: a
// field, the same blades moved by 2.5 cm, other blades of the same field, 0.7 of them, the picture blurred by a pixel,
// and each of its rows at its mean colour.
#include "core/numerics.h"
#include "fields.h"
#include "grass/comparison.h"
#include "metrics/metrics.h"
#include "metrics/pictures.h"
#include "scenes.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

constexpr int kPictureWidth = 112, kPictureHeight = 56,
              kFiner = 4;  // pixels; samples a pixel along each axis, with 4 in each

// Around what a person looks at, as many pixels a degree as 1024x768 at 55 degrees has.
ViewCamera crop(double distance) {
    ViewCamera c = lookingAt(distance, 3);
    c.fovDeg = 4.3f;
    return c;
}

using Linear = std::vector<glm::vec3>;

// The mean over the samples of each pixel, in linear light.
Linear converged(Renderer& r, Project& p, const ViewCamera& c) {
    const Status drawn = r.draw(p, c, sized(kPictureWidth * kFiner, kPictureHeight * kFiner));
    EXPECT_TRUE(drawn) << drawn.error().text();
    const std::vector<float> fine = r.readLinear();
    Linear out(static_cast<size_t>(kPictureWidth * kPictureHeight), glm::vec3(0));
    for (size_t i = 0; i < fine.size() / 3; ++i) {
        const size_t x = i % (kPictureWidth * kFiner) / kFiner, y = i / (kPictureWidth * kFiner) / kFiner;
        out[y * kPictureWidth + x] +=
            glm::vec3(fine[3 * i], fine[3 * i + 1], fine[3 * i + 2]) / static_cast<float>(kFiner * kFiner);
    }
    return out;
}
Picture shown(const Linear& linear) {
    std::vector<float> rgb;
    for (const glm::vec3& c : linear) rgb.insert(rgb.end(), {c.x, c.y, c.z});
    return pictureOfLinear(kPictureWidth, kPictureHeight, rgb);
}

// A Gaussian of one pixel.
Linear blurred(const Linear& in) {
    Linear out = in;
    for (int pass = 0; pass < 2; ++pass) {
        const Linear from = out;
        for (int y = 0; y < kPictureHeight; ++y)
            for (int x = 0; x < kPictureWidth; ++x) {
                glm::vec3 sum(0);
                float weights = 0;
                for (int k = -3; k <= 3; ++k) {
                    const float w = std::exp(-static_cast<float>(k * k) / 2);
                    const int u = pass == 0 ? std::clamp(x + k, 0, kPictureWidth - 1) : x,
                              v = pass == 1 ? std::clamp(y + k, 0, kPictureHeight - 1) : y;
                    sum += w * from[static_cast<size_t>(v * kPictureWidth + u)], weights += w;
                }
                out[static_cast<size_t>(y * kPictureWidth + x)] = sum / weights;
            }
    }
    return out;
}
Linear flatRows(const Linear& in) {
    Linear out = in;
    for (int y = 0; y < kPictureHeight; ++y) {
        glm::vec3 mean(0);
        for (int x = 0; x < kPictureWidth; ++x)
            mean += in[static_cast<size_t>(y * kPictureWidth + x)] / static_cast<float>(kPictureWidth);
        for (int x = 0; x < kPictureWidth; ++x) out[static_cast<size_t>(y * kPictureWidth + x)] = mean;
    }
    return out;
}

// Blades of a leaf area index of about 3.5, as dense meadows and lawns have, whichever their number: they hide the soil
// at these distances. Where soil shows, fewer blades change the mean colour more than a blur changes anything; where
// blades are denser still, or farther away, fewer of them look the same.
constexpr Design kTallMeadow{"1,000 blades/m2 of 50 cm by 10 mm", 1000, 0.5f, 0.01f, 24, 0, 0, 0, 0};
constexpr Design kDenseLawn{"10,000 blades/m2 of 11 cm by 4.5 mm", 10000, 0.11f, 0.0045f, 24, 0, 0, 0, 0};

// In the order from what looks like the truth to what does not.
constexpr const char* kKinds[] = {"moved", "re-seeded", "0.7", "blur", "rows"};
enum Kind { kMoved, kReseeded, kThinner, kBlur, kRows };
using Ranking = std::array<Metrics, 5>;

// The mean over other blades of several seeds: what they are off by differs from seed to seed by more than a tenth.
template <class Measure>
Metrics meanOverSeeds(Project& p, const Measure& measure) {
    constexpr int kSeeds = 4;
    Metrics sum;
    for (int k = 0; k < kSeeds; ++k) {
        grassIn(p).seed = 2 + k;
        const Metrics one = measure();
        sum.appearance.distance += one.appearance.distance / kSeeds;
        sum.appearance.sigma += one.appearance.sigma / (kSeeds * std::sqrt(double{kSeeds}));
        sum.appearance.bias += one.appearance.bias / kSeeds,
            sum.appearance.contrast += one.appearance.contrast / kSeeds;
        sum.rmse += one.rmse / kSeeds, sum.flip += one.flip / kSeeds, sum.ssim += one.ssim / kSeeds;
    }
    return sum;
}

Ranking rankingAt(Renderer& r, const Design& d, double distance) {
    Project p = designed(d, d.side);
    grassIn(p).species[0].clumpSize = 0;  // another seed would move clumps, too: decimetres that are not of the blades
    grassIn(p).technique = nameOf(Technique::Geometry);
    grassIn(p).maxGeom = std::numeric_limits<float>::infinity();
    const ViewCamera c = crop(distance);
    const Linear truth = converged(r, p, c);
    put<Transform>(p, "ground", {glm::dvec3(0.025, 0, 0)});
    const Linear moved = converged(r, p, c);
    put<Transform>(p, "ground");
    Ranking out;
    const auto measured = [&](const Linear& image) { return metricsOf(pairOf(shown(image), shown(truth))); };
    out[kReseeded] = meanOverSeeds(p, [&] { return measured(converged(r, p, c)); });
    grassIn(p).species[0].bladesPerM2 *= 0.7f;
    out[kThinner] = meanOverSeeds(p, [&] { return measured(converged(r, p, c)); });
    out[kMoved] = measured(moved), out[kBlur] = measured(blurred(truth)), out[kRows] = measured(flatRows(truth));
    return out;
}
void print(const Ranking& k) {
    for (size_t i = 0; i < k.size(); ++i)
        std::printf("    %-9s appearance %.4f +- %.4f bias %.4f contrast %.4f rmse %.4f flip %.4f ssim %.4f\n",
                    kKinds[i], k[i].appearance.distance, k[i].appearance.sigma, k[i].appearance.bias,
                    k[i].appearance.contrast, k[i].rmse, k[i].flip, k[i].ssim);
}

void expectOrder(const Ranking& k) {
    EXPECT_LT(k[kReseeded].appearance.distance, k[kThinner].appearance.distance);
    for (size_t i = kThinner; i + 1 < k.size(); ++i)
        EXPECT_LT(k[i].appearance.distance, k[i + 1].appearance.distance) << kKinds[i];
    EXPECT_LT(k[kMoved].appearance.distance, k[kThinner].appearance.distance);
    // Why Sward does not rank by RMSE: no blade stands where it stood, so it calls flat green nearer than other blades.
    EXPECT_LT(k[kRows].rmse, k[kReseeded].rmse);
    EXPECT_LT(k[kBlur].rmse, k[kReseeded].rmse);
}

TEST(AppearanceRanking, OtherBladesAreNearerThanFewerAndFewerThanBlurredAndFlat) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const Design& d : {kTallMeadow, kDenseLawn})
        for (const double distance : {11.0, 13.0, 15.0}) {
            const std::string which = fmt::format("{} at {} m", d.name, distance);
            SCOPED_TRACE(which);
            const Ranking k = rankingAt(r, d, distance);
            std::printf("  %s\n", which.c_str());
            print(k);
            expectOrder(k);
        }
}

}  // namespace
}  // namespace sward::test
