// Several fields in one scene, each of its own technique; and many species in one field: all drawn, traced and shading.
#include "grass/field.h"

#include "fields.h"
#include "reference/reference.h"
#include "scenes.h"

namespace sward::test {
namespace {

std::vector<uint8_t> picture(Project& p, const ViewCamera& camera = above()) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const Status drawn = r.draw(p, camera, small());
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    return r.readImage();
}

// The left half of the lawn, or its right.
MapField half(bool right) {
    Map m({16, 16, 1, PixelType::U8});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) m.set(x, y, 0, (x >= 8) == right ? 1.0f : 0.0f);
    return field(m, right ? "maps/right.png" : "maps/left.png");
}

struct Halves {
    double left, right;  // share of pixels that differ
};
Halves apart(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
    const ViewSettings s = small();
    Halves h{0, 0};
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) {
            if (std::abs(x - s.width / 2) < s.width / 10) continue;  // blades lean over the middle
            const size_t at = 3 * (static_cast<size_t>(y) * static_cast<size_t>(s.width) + static_cast<size_t>(x));
            int most = 0;
            for (size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a[at + c] - b[at + c]));
            (x < s.width / 2 ? h.left : h.right) += most > 12;
        }
    const double pixels = s.width * s.height * 0.4;
    return {h.left / pixels, h.right / pixels};
}

// Grass of one technique on the left of the lawn, of another on its right, which is blue.
Project twoFields(Technique left, Technique right) {
    Project p = lawn();
    FlatField one = flatField(p);
    one.technique = nameOf(left);
    one.species[0].density = half(false), one.species[0].bladesPerM2 = 600;
    FlatField other;
    other.technique = nameOf(right);
    Species s = one.species[0];
    s.name = "blue", s.density = half(true);
    s.rootColor = s.midColor = s.tipColor = {0.02f, 0.03f, 0.4f};
    other.species[0] = s;
    put(p, "other", other);
    return p;
}

void expectEachByItsOwn(std::initializer_list<std::pair<Technique, Technique>> pairs) {
    for (const auto& [left, right] : pairs) {
        Project both = twoFields(left, right);
        const auto whole = picture(both);
        Project alone = twoFields(left, right);
        removeEntity(alone, "other");
        const Halves without = apart(whole, picture(alone));
        const double here = std::max(without.left, without.right), there = std::min(without.left, without.right);
        EXPECT_GT(here, 0.25) << nameOf(left) << ", " << nameOf(right) << ": the second field shows";
        EXPECT_LT(there, 0.05) << nameOf(left) << ", " << nameOf(right) << ": and where it grows alone";
        Project second = twoFields(left, right);
        removeEntity(second, "grass");
        const Halves first = apart(whole, picture(second));
        EXPECT_GT(std::max(first.left, first.right), 0.25) << nameOf(left) << ": the first field shows";
    }
}

TEST(Fields, EachIsDrawnByItsOwnTechnique) {
    expectEachByItsOwn({{Technique::Geometry, Technique::Tessellated}, {Technique::Hybrid, Technique::Flat}});
}
TEST(Fields, EachOfMorePairsIsDrawnByItsOwnTechnique) {
    expectEachByItsOwn({{Technique::Tessellated, Technique::Hybrid},
                        {Technique::Slices, Technique::Geometry},
                        {Technique::Hybrid, Technique::Hybrid}});
}

TEST(Fields, EachIsTraced) {
    const auto traced = [](const Project& p) {
        JobControl control;
        auto scene = ReferenceScene::make(p, tables(), 0, control);
        EXPECT_TRUE(scene) << (scene ? "" : scene.error().text());
        ReferenceSettings s;
        s.width = 40, s.height = 30, s.samples = 4;
        const auto truth = scene->trace(above(), s, control);
        EXPECT_TRUE(truth);
        double blue = 0, grass = 0;
        for (size_t i = 0; i < truth->grass.size(); ++i)
            grass += truth->grass[i], blue += truth->color[3 * i + 2] > 2 * truth->color[3 * i + 1];
        return std::pair{grass, blue};
    };
    const Project both = twoFields(Technique::Geometry, Technique::Geometry);
    Project alone = twoFields(Technique::Geometry, Technique::Geometry);
    removeEntity(alone, "other");
    EXPECT_GT(traced(both).first, 1.6 * traced(alone).first);
    EXPECT_GT(traced(both).second, 100);
    EXPECT_EQ(traced(alone).second, 0);
}

TEST(Fields, SixteenSpeciesAllShow) {
    const auto sixteen = [](size_t without) {
        Project p = lawn();
        FlatField f = flatField(p);
        f.technique = nameOf(Technique::Geometry);
        f.species.assign(16, f.species[0]);
        for (size_t i = 0; i < 16; ++i) {
            Species& s = f.species[i];
            s.name = "s" + std::to_string(i);
            s.bladesPerM2 = i == without ? 0.0f : 60;
            s.width = 0.04f;
            s.height = 0.05f;
            if (i == 4 || i == 15) {  // they stand out of the others
                s.height = i == 4 ? 0.3f : 0.5f;
                s.rootColor = s.midColor = s.tipColor = i == 15 ? glm::vec3(0.5f, 0.02f, 0.02f) : glm::vec3(0.5f);
            }
        }
        return p;
    };
    Project all = sixteen(99), last = sixteen(15), fifth = sixteen(4);
    const auto whole = picture(all);
    EXPECT_GT(apart(whole, picture(last)).left, 0.02) << "the sixteenth";
    EXPECT_GT(apart(whole, picture(fifth)).left, 0.02) << "the fifth";
}

TEST(Fields, MoreThanASceneMayHaveIsRefusedAndNothingIsDrawn) {
    Project p = lawn();
    flatField(p).species.assign(17, Species{});
    Renderer r(gpu(), tables());
    const Status drawn = r.draw(p, above(), small());
    ASSERT_FALSE(drawn);
    EXPECT_NE(drawn.error().message.find("grass.GrassField.species: 17 species"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
