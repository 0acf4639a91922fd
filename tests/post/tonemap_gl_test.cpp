// The way to the screen: eight bits without bands, and the same each time.
#include <cmath>

#include "core/numerics.h"
#include "scenes.h"

namespace sward::test {
namespace {

// A sky over level ground, seen from where the horizon lies below the picture.
Project skyAlone() {
    Project p;
    Terrain t;
    t.size = {20, 20};
    put(p, "ground", t);
    put<Light>(p, "sun", {.azimuthDeg = 180, .elevationDeg = 35});
    put<Sky>(p, "sky");
    return p;
}
ViewCamera upwards() { return {{10, 2, 10}, {10, 6, 0}, 20, 0}; }

struct Shown {
    std::vector<uint8_t> levels;
    std::vector<float> wanted;  // of 255, before rounding
};
Shown shown(Renderer& r, const Project& p, const ViewSettings& s) {
    EXPECT_TRUE(r.draw(p, upwards(), s));
    Shown out{r.readImage(), r.readLinear()};
    for (size_t i = 0; i < out.wanted.size(); i += 3) {
        float* v = &out.wanted[i];
        const glm::vec3 c = f32::srgbEncode3(f32::toneMapNeutral({v[0], v[1], v[2]}));
        for (int k = 0; k < 3; ++k) v[k] = 255 * c[k];
    }
    return out;
}

// Over squares of pixels the mean of what is shown is the mean of what is wanted, as rounding alone cannot have it.
TEST(Tonemap, SlowChangesEndInNoBands) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    ViewSettings s;
    s.width = 240, s.height = 160;
    const Shown picture = shown(r, skyAlone(), s);
    constexpr int kSide = 10;
    double dithered = 0, rounded = 0;
    int squares = 0;
    for (int y = 0; y < s.height; y += kSide)
        for (int x = 0; x < s.width; x += kSide, ++squares) {
            double is = 0, wanted = 0, banded = 0;
            for (int n = 0; n < kSide * kSide; ++n) {
                const size_t i = static_cast<size_t>((y + n / kSide) * s.width + x + n % kSide) * 3 + 1;
                is += picture.levels[i], wanted += double(picture.wanted[i]),
                    banded += std::round(double(picture.wanted[i]));
            }
            dithered += std::abs(is - wanted) / (kSide * kSide), rounded += std::abs(banded - wanted) / (kSide * kSide);
        }
    EXPECT_LT(dithered / squares, 0.05) << "levels";
    EXPECT_GT(rounded / squares, 2 * dithered / squares) << "else the picture has nothing to band";
}

TEST(Tonemap, DitherMovesNoPixelByMoreThanHalfALevelAndIsTheSameEachTime) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    ViewSettings s;
    s.width = 120, s.height = 80;
    const Shown first = shown(r, skyAlone(), s), second = shown(r, skyAlone(), s);
    EXPECT_EQ(first.levels, second.levels);
    EXPECT_EQ(first.wanted, second.wanted) << "linear light has none";
    for (size_t i = 0; i < first.levels.size(); ++i)
        ASSERT_LE(std::abs(float(first.levels[i]) - first.wanted[i]), 1.01f) << i;
    double sum = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const float d = f32::ditherOf(x + 8000, y + 8000);
            ASSERT_TRUE(d >= -0.5f && d < 0.5f);
            sum += double(d);
        }
    EXPECT_NEAR(sum / 4096, 0, 0.01);
}

TEST(Tonemap, FalseColoursStayExact) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    ViewSettings s = small();
    s.mode = ViewMode::Tiers;
    ASSERT_TRUE(r.draw(lawn(), {{10, 40, 10}, {10, 0, 10.01}, 20, 0}, s));
    const std::vector<uint8_t> levels = r.readImage();
    const std::vector<float> wanted = r.readLinear();
    for (size_t i = 0; i < levels.size(); ++i)
        ASSERT_LE(std::abs(float(levels[i]) - 255 * wanted[i]), 0.51f) << "rounded, not dithered: " << i;
}

}  // namespace
}  // namespace sward::test
