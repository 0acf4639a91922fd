// The geometry technique against the ray-traced truth in the same light: where they differ, one of them is wrong.
#include "reference/reference.h"

#include "core/numerics.h"
#include "fields.h"
#include "maps/map_io.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

constexpr int kTracedWidth = 96, kTracedHeight = 72;
constexpr int kSamples = 256;
constexpr int kTimesFiner =
    8;  // the technique's picture is drawn so much larger each way, and averaged in linear light

// 4 x 4 m of blades wider than two pixels. Their image is one opaque texel: a finer one's mipmaps are a sampling error
// of the technique's own, which goes as its pictures get finer.
Project garden(const TempDir& folder) {
    Project p;
    p.dir = folder.path;
    EXPECT_TRUE(writeImagePng(folder / "plain.png", 1, 1, 4, {188, 188, 188, 255}));
    Terrain t;
    t.size = {4, 4};
    put(p, "ground", t);
    FlatField f;
    f.technique = nameOf(Technique::Geometry);
    f.shadowMask = 0;
    f.groundShadows = false;
    Species& s =
        f.species[0];  // no gloss: the technique's highlight, interpolated between vertices, is off by up to 0.012
    s.bladesPerM2 = 60, s.height = 0.35f, s.width = 0.08f, s.segments = 16, s.translucency = 0.5f, s.gloss = 0,
    s.clumpStrength = 1, s.texture = "plain.png";
    put(p, "grass", f);
    Light sun;
    sun.elevationDeg = 65;
    put(p, "sun", sun);
    put<Sky>(p, "sky");
    put<Fog>(p, "haze");
    return p;
}
ViewCamera beside() { return {{2, 1.5, 0.4}, {2, 0.1, 2}, 50, 0}; }

std::vector<float> drawnFine(Project& p, const ViewCamera& c) {
    Renderer r(gpu(), tables());
    ViewSettings s;
    s.width = kTimesFiner * kTracedWidth, s.height = kTimesFiner * kTracedHeight;
    EXPECT_TRUE(r.draw(p, c, s));
    const std::vector<float> fine = r.readLinear();
    std::vector<float> out(3 * kTracedWidth * kTracedHeight);
    for (size_t y = 0; y < kTimesFiner * kTracedHeight; ++y)
        for (size_t x = 0; x < kTimesFiner * kTracedWidth; ++x)
            for (size_t k = 0; k < 3; ++k)
                out[3 * (y / kTimesFiner * kTracedWidth + x / kTimesFiner) + k] +=
                    fine[3 * (y * kTimesFiner * kTracedWidth + x) + k] / (kTimesFiner * kTimesFiner);
    return out;
}
Truth traced(const Project& p, const ViewCamera& c, int samples) {
    JobControl control;
    auto scene = ReferenceScene::make(p, tables(), 0, control);
    ReferenceSettings s;
    s.width = kTracedWidth, s.height = kTracedHeight, s.samples = samples, s.lighting = ReferenceLighting::Direct;
    auto t = scene->trace(c, s, control);
    EXPECT_TRUE(t);
    return *t;
}

struct Agreement {
    double rmse = 0;        // sRGB
    double worstBlock = 0;  // |difference of 8 x 8 means| in standard errors
    double grass = 0;       // share of pixels
};
Agreement compare(const std::vector<float>& drawn, const Truth& t) {
    Agreement a;
    const auto shown = [](const float* v) { return f32::srgbEncode3(f32::toneMapNeutral({v[0], v[1], v[2]})); };
    for (size_t i = 0; i < t.grass.size(); ++i) {
        const glm::vec3 d = shown(&drawn[3 * i]) - shown(&t.color[3 * i]);
        a.rmse += static_cast<double>(glm::dot(d, d)) / (3 * static_cast<double>(t.grass.size()));
        a.grass += static_cast<double>(t.grass[i]) / static_cast<double>(t.grass.size());
    }
    a.rmse = std::sqrt(a.rmse);
    for (size_t y = 0; y + 8 <= kTracedHeight; y += 8)
        for (size_t x = 0; x + 8 <= kTracedWidth; x += 8)
            for (size_t k = 0; k < 3; ++k) {
                double difference = 0, variance = 0, mean = 0;
                for (size_t j = 0; j < 64; ++j) {
                    const size_t i = 3 * ((y + j / 8) * kTracedWidth + x + j % 8) + k;
                    difference += static_cast<double>(drawn[i] - t.color[i]) / 64;
                    mean += static_cast<double>(t.color[i]) / 64;
                    // The drawn picture has sixteen times four samples of its own a pixel: an error of its own of that
                    // many.
                    variance += static_cast<double>(t.error[i] * t.error[i]) * 2 / (64 * 64);
                }
                // Light's halves of 11 bits, and colours interpolated between a blade's vertices: 1% of the mean.
                a.worstBlock = std::max(
                    a.worstBlock, std::max(std::abs(difference) - 0.01 * mean, 0.0) / std::sqrt(variance + 1e-12));
            }
    return a;
}

TEST(ReferenceAgreement, GeometryIsTheTruthInDirectLight) {
    const NoGlErrors check;
    const TempDir folder;
    Project p = garden(folder);
    const std::vector<float> drawn = drawnFine(p, beside());
    if (const char* out = std::getenv("SWARD_WRITE_PICTURES")) {
        const Truth t = traced(p, beside(), kSamples);
        EXPECT_TRUE(writeImageExr(std::string(out) + "/drawn.exr", kTracedWidth, kTracedHeight, 3, drawn) &&
                    writeImageExr(std::string(out) + "/truth.exr", kTracedWidth, kTracedHeight, 3, t.color));
    }
    const Agreement a = compare(drawn, traced(p, beside(), kSamples));
    std::printf("rmse %.5f, worst block %.2f standard errors, %.0f%% grass\n", a.rmse, a.worstBlock, 100 * a.grass);
    EXPECT_GT(a.grass, 0.3);
    EXPECT_LE(a.rmse, 0.01);
    EXPECT_LE(a.worstBlock, 4);
    // What must not agree: the same field with its blades a tenth wider.
    flatField(p, "grass").species[0].width *= 1.1f;
    const Agreement wider = compare(drawn, traced(p, beside(), 64));
    EXPECT_GT(wider.rmse, 0.01);
    EXPECT_GT(wider.worstBlock, 4);
}

// Mean light of a lawn whose blades shade each other and lean along x, all as far, as a share of the same in the truth.
double leaningShare(Technique technique, float lean) {
    Project p;
    Terrain t;
    t.size = {4, 4};
    t.groundColor = glm::vec3(0);  // blades alone
    put(p, "ground", t);
    FlatField f;
    f.technique = nameOf(technique);
    f.minGeom = 8, f.maxGeom = 9, f.thinning = 0, f.maxDistance = 100;
    Species& s = f.species[0];
    s.bladesPerM2 = 6000, s.height = 0.1f, s.width = 0.005f, s.leanDeg = 35, s.clumpStrength = 0;
    if (lean != 0) {
        Map way({2, 2, 2, PixelType::U8});
        for (int i = 0; i < 4; ++i) way.set(i % 2, i / 2, 0, 0.5f + 0.5f * lean), way.set(i % 2, i / 2, 1, 0.5f);
        f.orientation = {"maps/way.png", way};
    }
    put(p, "grass", f);
    Light sun;
    sun.elevationDeg = 40, sun.azimuthDeg = 90;  // along x
    put(p, "sun", sun);
    put<Sky>(p, "sky");
    const ViewCamera above{{2, 2.2, 0.6}, {2, 0, 2.2}, 30, 0};
    const auto mean = [](const std::vector<float>& c) {
        double sum = 0;
        for (size_t i = 1; i < c.size(); i += 3) sum += static_cast<double>(c[i]) * 3 / static_cast<double>(c.size());
        return sum;
    };
    return mean(drawnFine(p, above)) / mean(traced(p, above, 16).color);
}

// Neighbours lean as a blade does. A mask that took them for upright had blades 23% too light that lean the one way,
// and 22% too dark that lean the other: what stripes are made of.
TEST(ReferenceAgreement, LeaningBladesShadeEachOtherAsTheyDoInTruth) {
    const NoGlErrors check;
    for (const Technique technique : {Technique::Geometry, Technique::Tessellated}) {
        const double one = leaningShare(technique, -1), upright = leaningShare(technique, 0),
                     other = leaningShare(technique, 1);
        std::printf("%s: %.3f, upright %.3f, %.3f of the truth\n", nameOf(technique), one, upright, other);
        EXPECT_NEAR(upright, 1, 0.1);
        EXPECT_NEAR(one / other, 1, 0.2);
    }
}

}  // namespace
}  // namespace sward::test
