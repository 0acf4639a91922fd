// Layers over the heights in the pictures: those of ground that was sculpted so, by the renderer and by the truth, and
// the one against the other.
#include "world/height_layers.h"

#include "reference/reference.h"
#include "tests/rows.h"
#include "tests/world/layered.h"

namespace sward {
namespace {

using namespace test;

// Flat ground with a bank of 3 m across the view, of an imported picture.
Project banked() {
    Project p = rampLawn(0);
    Map picture({64, 64, 1, PixelType::F32});
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 64; ++x) picture.set(x, z, 0, std::max(0.f, 1 - std::abs(static_cast<float>(z) - 20) / 10));
    MapLayer bank;
    bank.name = "bank", bank.map = "Terrain.height", bank.kind = LayerKind::Image, bank.operation = LayerOperation::Add;
    bank.high = 3;
    bank.amounts = field(std::move(picture), "maps/bank.exr");
    put(p, "ground", MapLayers{{bank}});
    return p;
}
// The same without layers, its heights sculpted as they leave them.
Project sculptedSo() {
    Project p = snapshot(*withLayers(banked(), rows()), rows());
    p.registry.remove<MapLayers>(findEntity(p, "ground"));
    return p;
}
std::vector<float> picture(Renderer& r, const Project& p) {
    const Status drawn = r.draw(p, eyeHeight(), small());
    EXPECT_TRUE(drawn) << drawn.error().text();
    return r.readLinear();
}
std::vector<float> traced(const Project& p) {
    ReferenceSettings s;
    s.width = small().width, s.height = small().height, s.samples = 4;
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene);
    const auto truth = scene->trace(eyeHeight(), s, control);
    EXPECT_TRUE(truth);
    return truth->color;
}
// Mean over pixels and channels; `picture` has as many channels as it has, of which the first three count, and its
// first row at the bottom if `turned`.
double apart(const std::vector<float>& picture, const std::vector<float>& truth, bool turned) {
    const size_t width = static_cast<size_t>(small().width), height = static_cast<size_t>(small().height);
    const size_t of = picture.size() / (width * height), in = truth.size() / (width * height);
    double sum = 0;
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0; x < width; ++x)
            for (size_t c = 0; c < 3; ++c) {
                const size_t row = turned ? height - 1 - y : y;
                const float a = picture[(row * width + x) * of + c], b = truth[(y * width + x) * in + c];
                sum += static_cast<double>(std::abs(std::min(a, 1.f) - std::min(b, 1.f)));
            }
    return sum / static_cast<double>(3 * width * height);
}

TEST(HeightLayerPictures, AreThoseOfGroundThatWasSculptedSo) {
    const NoGlErrors none;
    Renderer a(gpu(), tables()), b(gpu(), tables());
    const std::vector<float> shown = picture(a, banked());
    EXPECT_EQ(shown, picture(b, sculptedSo()));
    EXPECT_NE(shown, picture(b, rampLawn(0))) << "the bank is seen";
    Project muted = banked();
    muted.registry.get<MapLayers>(findEntity(muted, "ground"))->layers[0].muted = true;
    EXPECT_EQ(picture(a, muted), picture(b, rampLawn(0))) << "and goes";
}

TEST(HeightLayerPictures, TheTruthIsThatOfGroundThatWasSculptedSo) {
    const std::vector<float> truth = traced(banked());
    EXPECT_EQ(truth, traced(sculptedSo()));
    EXPECT_NE(truth, traced(rampLawn(0)));
}

// Blade by blade both draw the same grass: they come as near to each other on the bank as on flat ground, and far from
// the truth of the ground below the layers.
TEST(HeightLayerPictures, StandOnTheGroundOfTheTruth) {
    const NoGlErrors none;
    Renderer r(gpu(), tables());
    const auto bare = [](Project p) {
        p.registry.get<GrassField>(findEntity(p, "grass"))->technique = "geometry";
        return p;
    };
    const std::vector<float> bank = picture(r, bare(banked())), flat = picture(r, bare(rampLawn(0)));
    const std::vector<float> bankTruth = traced(bare(banked())), flatTruth = traced(bare(rampLawn(0)));
    const bool turned = apart(flat, flatTruth, true) < apart(flat, flatTruth, false);
    const double onFlat = apart(flat, flatTruth, turned), onBank = apart(bank, bankTruth, turned),
                 amiss = apart(bank, flatTruth, turned);
    std::printf("  flat %.4f, bank %.4f, bank against the flat truth %.4f\n", onFlat, onBank, amiss);
    EXPECT_LT(onBank, 1.5 * onFlat);
    EXPECT_GT(amiss, 2 * onBank);
}

}  // namespace
}  // namespace sward
