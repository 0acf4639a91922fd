// Components compared and copied by their field tables.
#include "model/field_walk.h"

#include <gtest/gtest.h>

#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

Map filled(int side, float value) {
    Map map({side, side, 1, PixelType::U8});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) map.set(x, y, 0, value);
    return map;
}

TEST(FieldWalk, MapsAreTheSameByTheirTexelsNotByTheirTiles) {
    const Map a = filled(8, 0.5f), b = filled(8, 0.5f), shared = a;
    EXPECT_TRUE(sameTexels(a, shared));
    EXPECT_TRUE(sameTexels(a, b));
    Map other = b;
    other.set(7, 7, 0, 1);
    EXPECT_FALSE(sameTexels(a, other));
    EXPECT_FALSE(sameTexels(a, filled(9, 0.5f)));
    EXPECT_FALSE(sameTexels(a, {}));
    EXPECT_TRUE(sameTexels({}, {}));
}

TEST(FieldWalk, EveryComponentIsTheSameAsItsCopyAndDefaultsHaveNoMaps) {
    for (const ComponentRow& row : tables().components) {
        EXPECT_TRUE(sameFields(row.fields, row.defaults(), row.defaults())) << row.name;
        eachMap(row.fields, row.defaults(), [&](const MapField& m) { EXPECT_FALSE(m.present()) << row.name; });
    }
}

TEST(FieldWalk, OneFieldMakesTheDifferenceAndCopyingTakesItAway) {
    const ComponentRow* row = findComponent(tables().components, "Camera");
    ASSERT_NE(row, nullptr);
    Camera a, b;
    EXPECT_TRUE(sameFields(row->fields, &a, &b));
    b.fovDeg = 20;
    EXPECT_FALSE(sameFields(row->fields, &a, &b));
    copyFields(row->fields, &a, &b);
    EXPECT_TRUE(sameFields(row->fields, &a, &b));
    EXPECT_EQ(a.fovDeg, 20);
}

}  // namespace
}  // namespace sward
