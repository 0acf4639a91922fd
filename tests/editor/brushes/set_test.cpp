// The brush that sets a value.
#include "brushes/brush.h"

#include <gtest/gtest.h>

#include "editor/brushes/stamped.h"

namespace sward {
namespace {

using namespace test;

TEST(SetBrush, SetAtFullStrengthReachesItsValueExactlyFromAnywhere) {
    for (const PixelType type : kTypes)
        for (const float value : {0.0f, 0.3f, 1.0f}) {
            const Map wanted = mapOf(1, 1, type, value);
            Map map = randomMap(200, 200, type, 5);
            paint(map, "set", {100, 100, 50, 50, 77}, brushOf(1, 0, value));
            for (int y = 70; y < 130; ++y)
                for (int x = 70; x < 130; ++x) ASSERT_EQ(map.at(x, y), wanted.at(0, 0)) << x << "," << y;
        }
}

TEST(SetBrush, WeakSetConvergesToItsValue) {
    for (const PixelType type : {PixelType::U8, PixelType::U16}) {
        Map map({32, 32, 1, type});
        for (int i = 0; i < 4000; ++i) paint(map, "set", {16, 16, 12, 12, uint32_t(i)}, brushOf(0.01f, 0.5f, 0.6f));
        EXPECT_NEAR(map.at(16, 16), 0.6f, type == PixelType::U8 ? 1.01f / 255 : 1.01f / 65535);
    }
}

}  // namespace
}  // namespace sward
