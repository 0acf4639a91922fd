// Shapes on maps: their areas, blends and seams.
#include "script/map_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "script/map_ops.h"

namespace sward {
namespace {

Map filledMap(int width, int height, int channels, PixelType type, float value) {
    Map map({width, height, channels, type});
    fillMap(map, {value, value, value, value});
    return map;
}

double areaOf(const Shape& shape, ShapePaint paint = {}, int texels = 600) {
    Map map({texels, texels, 1, PixelType::F32});
    drawShape(map, 30, 30, shape, paint);
    return map.mean() * 900;
}
constexpr double kPi = 3.14159265358979323846;

TEST(MapShapes, AreasAreThoseOfGeometry) {
    EXPECT_NEAR(areaOf({ShapeKind::Disc, {{15, 15}}, 6}), kPi * 36, 0.2);
    EXPECT_NEAR(areaOf({ShapeKind::Disc, {{15, 15}}, 6, 5}), kPi * 11, 0.2);
    EXPECT_NEAR(areaOf({ShapeKind::Rect, {{2.1, 3.3}, {12.6, 20.9}}}), 10.5 * 17.6, 0.2);
    EXPECT_NEAR(areaOf({ShapeKind::Rect, {{12.6, 20.9}, {2.1, 3.3}}}), 10.5 * 17.6, 0.2);
    EXPECT_NEAR(areaOf({ShapeKind::Polygon, {{5, 5}, {25, 5}, {5, 25}}}), 200, 0.3);
    EXPECT_NEAR(areaOf({ShapeKind::Polyline, {{5, 5}, {25, 20}}, 1, 0, 2}), 25 * 2 + kPi, 0.3);
    EXPECT_NEAR(areaOf({ShapeKind::Polyline, {{10, 10}}, 1, 0, 4}), kPi * 4, 0.1);
    EXPECT_NEAR(areaOf({ShapeKind::Polyline, {{5, 5}, {25, 5}, {25, 25}, {5, 25}}, 1, 0, 1, true}), 79 + kPi / 4, 0.3);
    EXPECT_NEAR(areaOf({ShapeKind::Disc, {{0, 0}}, 6}), kPi * 36 / 4, 0.2);  // cut off by the edge
    EXPECT_EQ(areaOf({ShapeKind::Disc, {{-20, 15}}, 6}), 0);
}

TEST(MapShapes, WhatIsThinnerThanATexelStillCoversItsArea) {
    // 12 cm on texels of 25 cm.
    EXPECT_NEAR(areaOf({ShapeKind::Rect, {{5, 5.06}, {25, 5.18}}}, {}, 120), 20 * 0.12, 1e-4);
    EXPECT_NEAR(areaOf({ShapeKind::Polyline, {{5, 5.03}, {25, 14.7}}, 1, 0, 0.12}, {}, 120),
                std::hypot(20, 9.67) * 0.12, 0.1);
}

TEST(MapShapes, LongLinesMeanTheSameWhateverTilesTheyCross) {
    std::vector<ShapePoint> line;
    for (int i = 0; i <= 100; ++i) line.emplace_back(2 + 0.26 * i, 15 + 8 * std::sin(0.2 * i));
    const Shape shape{ShapeKind::Polyline, line, 1, 0, 0.8};
    Map map({600, 600, 1, PixelType::F32});
    ShapePaint paint;
    paint.soft = 0.6;
    drawShape(map, 30, 30, shape, paint);
    for (int y = 3; y < 600; y += 7)
        for (int x = 3; x < 600; x += 5) {
            const double t = std::clamp(0.5 - shapeDistance(shape, (x + 0.5) * 0.05, (y + 0.5) * 0.05) / 0.6, 0.0, 1.0);
            ASSERT_NEAR(map.at(x, y), t * t * (3 - 2 * t), 1e-5) << x << "," << y;
        }
}

TEST(MapShapes, BlendModes) {
    const Shape all{ShapeKind::Rect, {{-9, -9}, {99, 99}}};
    const auto blended = [&](BlendMode mode, float value, double opacity) {
        Map map = filledMap(4, 4, 1, PixelType::F32, 0.5f);
        drawShape(map, 30, 30, all, {{value, 0, 0, 0}, mode, opacity, 0});
        return map.at(2, 2);
    };
    EXPECT_FLOAT_EQ(blended(BlendMode::Set, 0.9f, 1), 0.9f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Set, 0.9f, 0.5), 0.7f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Add, 2, 0.5), 1.5f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Multiply, 0.5f, 1), 0.25f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Max, 0.2f, 1), 0.5f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Max, 0.8f, 1), 0.8f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Min, 0.2f, 1), 0.2f);
}

}  // namespace
}  // namespace sward
