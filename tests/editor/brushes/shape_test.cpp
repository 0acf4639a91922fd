// Shapes of brushes: where their light falls, how they turn and shrink, what files they come from.
#include "brushes/shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "editor/brushes/sculpted.h"
#include "maps/map_io.h"
#include "support.h"

namespace sward {
namespace {

using namespace test;

// White in the upper right quarter alone.
ShapePtr corner() {
    std::vector<float> texels(16 * 16, 0.0f);
    for (int y = 0; y < 8; ++y)
        for (int x = 8; x < 16; ++x) texels[size_t(y) * 16 + size_t(x)] = 1;
    return makeShape("corner", 16, 16, std::move(texels));
}
Stamp turned(double angleDeg, double radius = 40) {
    Stamp s{100, 100, radius, radius};
    s.angle = angleDeg * 3.14159265358979323846 / 180;
    s.reach = std::abs(std::cos(s.angle)) + std::abs(std::sin(s.angle));
    return s;
}
// Of a map of 200 x 200, with what was painted where, as the quarter whose middle is nearest to it.
Map stamped(const Stamp& stamp, const ShapePtr& shape) {
    Map map = mapOf(200, 200, PixelType::F32, 0);
    BrushSettings b = brushOf(1);
    b.shape = shape, b.high = 1e6f;
    paint(map, "add", stamp, b);
    return map;
}
double sumOf(const Map& map) {
    double sum = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) sum += static_cast<double>(map.at(x, y));
    return sum;
}

TEST(Shape, ItsUpperRightIsNorthEastAndTurnsClockwise) {
    const int at[4][2] = {{120, 80}, {120, 120}, {80, 120}, {80, 80}};  // the four quarters, clockwise from north-east
    for (int turn = 0; turn < 4; ++turn) {
        const Map map = stamped(turned(90 * turn), corner());
        for (int q = 0; q < 4; ++q) EXPECT_NEAR(map.at(at[q][0], at[q][1]), q == turn ? 1 : 0, 1e-5) << turn << q;
    }
    Stamp flipped = turned(0);
    flipped.flipX = true;
    EXPECT_NEAR(stamped(flipped, corner()).at(80, 80), 1, 1e-5);
    flipped.flipZ = true;
    EXPECT_NEAR(stamped(flipped, corner()).at(80, 120), 1, 1e-5);
}

TEST(Shape, ATurnLosesNothingAndCornersReachBeyondTheRing) {
    for (const double angle : {0.0, 17.0, 45.0, 200.0}) {
        EXPECT_NEAR(sumOf(stamped(turned(angle), corner())), 40 * 40, 40 * 40 * 0.04) << angle;
        EXPECT_NEAR(sumOf(stamped(turned(angle), builtInShape("square"))), 80 * 80, 80 * 80 * 0.04) << angle;
    }
    const Map map = stamped(turned(45), builtInShape("square"));
    EXPECT_NEAR(map.at(100, 100 - 52), 1, 1e-4) << "a corner of the square, beyond the radius of 40";
}

TEST(Shape, ASmallStampTakesTheMeanOfAFinePicture) {
    std::vector<float> texels;
    for (int i = 0; i < 512 * 512; ++i) texels.push_back((i % 512 + i / 512) % 2 ? 1 : 0);
    const Map map = stamped(turned(10, 8), makeShape("checks", 512, 512, std::move(texels)));
    for (int y = 97; y < 103; ++y)
        for (int x = 97; x < 103; ++x) EXPECT_NEAR(map.at(x, y), 0.5, 0.02);
}

// The veil over the ground shows what a stamp would lay, of a picture of four texels, too.
TEST(Shape, TheLightOfASmallPictureIsShownTexelByTexel) {
    const ShapePtr chequered = makeShape("chequered", 2, 2, {1, 0, 0, 1});
    EXPECT_NEAR(shapeLight(*chequered, -0.5f, -0.5f), 1, 1e-6);
    EXPECT_NEAR(shapeLight(*chequered, 0.5f, -0.5f), 0, 1e-6);
    EXPECT_NEAR(shapeLight(*chequered, -0.5f, 0.5f), 0, 1e-6);
    EXPECT_NEAR(shapeLight(*chequered, 0.5f, 0.5f), 1, 1e-6);
    EXPECT_NEAR(shapeLight(*corner(), 0.5f, -0.5f), 1, 1e-6);
    EXPECT_NEAR(shapeLight(*corner(), -0.5f, -0.5f), 0, 1e-6);
    std::vector<float> fine(512 * 512);
    for (size_t i = 0; i < fine.size(); ++i) fine[i] = static_cast<float>(i % 2);
    EXPECT_NEAR(shapeLight(*makeShape("fine", 512, 512, fine), 0.1f, 0.3f), 0.5f, 1e-3) << "of a fine one the mean";
}

TEST(Shape, AWidePictureKeepsItsProportions) {
    const Map map = stamped(turned(0), makeShape("bar", 40, 10, std::vector<float>(400, 1.0f)));
    EXPECT_NEAR(map.at(65, 100), 1, 1e-5);
    EXPECT_NEAR(map.at(100, 93), 1, 1e-5);
    EXPECT_EQ(map.at(100, 85), 0);
}

// One stamp of every brush that has weights, on a map that it paints: the dark half stays as it was.
TEST(Shape, EveryBrushPaintsOnlyWhereItsShapeIsLight) {
    std::vector<float> texels(8 * 8, 0.0f);
    for (size_t i = 0; i < texels.size(); ++i) texels[i] = i % 8 >= 4 ? 1 : 0;  // light on the right
    const ShapePtr right = makeShape("right", 8, 8, std::move(texels));
    for (const BrushRow& row : brushRows()) {
        if (row.spans) continue;
        const MapKind kind = paints(row, MapKind::Amounts)      ? MapKind::Amounts
                             : paints(row, MapKind::Heights)    ? MapKind::Heights
                             : paints(row, MapKind::Directions) ? MapKind::Directions
                                                                : MapKind::Forces;
        const int channels = kind == MapKind::Directions ? 2 : kind == MapKind::Forces ? 4 : 1;
        Map map({128, 128, channels, PixelType::F32});
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x)
                for (int c = 0; c < channels; ++c)
                    map.set(
                        x, y, c,
                        0.5f + 0.2f * std::sin(0.7f * static_cast<float>(x)) * std::cos(0.9f * static_cast<float>(y)));
        BrushSettings b = kind == MapKind::Heights ? sculptor(PixelType::F32, 1) : brushOf(1, 0.5f, 0.3f);
        b.shape = right, b.mode = row.name, b.radius = 30;
        const Map before = map;
        Stamp stamp{64, 64, 30, 30};
        stamp.headingX = 0.6, stamp.headingZ = 0.8;
        applyStamp(map, row, stamp, b);
        int left = 0, there = 0;
        for (int y = 40; y < 90; ++y)
            for (int x = 0; x < 128; ++x) {
                const bool changed = map.at(x, y) != before.at(x, y);
                left += changed && x < 57;
                there += changed && x > 66 && x < 93;
            }
        EXPECT_EQ(left, 0) << row.name;
        EXPECT_GT(there, 100) << row.name;
    }
}

TEST(Shape, FilesOfAnyGreyAreShapes) {
    TempDir dir;
    Map grey({4, 2, 1, PixelType::U16}), heights({4, 2, 1, PixelType::F32}), colour({4, 2, 4, PixelType::U8});
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 2; ++y) {
            grey.set(x, y, 0, static_cast<float>(x) / 3);
            heights.set(x, y, 0, 100 + 10 * static_cast<float>(x));
            colour.set(x, y, 1, 1), colour.set(x, y, 3, static_cast<float>(x) / 3);
        }
    ASSERT_TRUE(writeMap(dir / "grey.png", grey));
    ASSERT_TRUE(writeMap(dir / "heights.exr", heights));
    ASSERT_TRUE(writeMap(dir / "colour.png", colour));
    for (const auto& [file, most] : {std::pair{"grey.png", 1.0f}, {"heights.exr", 1.0f}, {"colour.png", 0.7152f}}) {
        const Result<ShapePtr> shape = loadShape(dir / file);
        ASSERT_TRUE(shape) << file;
        const ShapeLevel& level = (*shape)->levels[0];
        EXPECT_EQ((*shape)->name, (dir / file).string());
        for (int x = 0; x < 4; ++x)
            EXPECT_NEAR(level.texels[7 + 1 + static_cast<size_t>(x)], most * static_cast<float>(x) / 3, 0.003) << file;
    }
    EXPECT_FALSE(loadShape(dir / "none.png"));
    writeText(dir / "broken.png", "no image");
    const Result<ShapePtr> broken = loadShape(dir / "broken.png");
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().text().find("broken.png"), std::string::npos);
}

TEST(Shape, ThoseMadeHereAreTheSameEachTimeAndNeverEven) {
    std::set<double> sums;
    for (const char* name : builtInShapes()) {
        const ShapePtr shape = builtInShape(name);
        ASSERT_TRUE(shape) << name;
        EXPECT_EQ(shape->levels[0].texels, builtInShape(name)->levels[0].texels) << name;
        double sum = 0;
        for (const float t : shape->levels[0].texels) {
            ASSERT_TRUE(t >= 0 && t <= 1) << name;
            sum += static_cast<double>(t);
        }
        EXPECT_GT(sum, 0.05 * 256 * 256) << name;
        sums.insert(sum);
    }
    EXPECT_EQ(sums.size(), builtInShapes().size());
    EXPECT_EQ(builtInShape("nothing"), nullptr);
}

}  // namespace
}  // namespace sward
