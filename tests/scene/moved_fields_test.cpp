// Names of fields that moved to a component of their own: those of the first form go on working.
#include "scene/moved_fields.h"

#include <gtest/gtest.h>

#include "fields.h"
#include "scenes.h"

namespace sward::test {
namespace {

TEST(MovedFields, EachIsWhereItsRowSays) {
    for (const MovedField& moved : movedFields()) {
        const ComponentRow* to = findComponent(tables().components, moved.to);
        ASSERT_TRUE(to) << moved.to;
        EXPECT_TRUE(std::any_of(to->fields.begin(), to->fields.end(),
                                [&](const FieldRow& f) { return std::string_view(f.name) == moved.field; }))
            << moved.to << "." << moved.field;
        EXPECT_STREQ(movedTo(moved.component, moved.field), moved.to);
    }
    EXPECT_EQ(movedTo("GrassField", "seed"), nullptr);
}

TEST(MovedFields, OldPathsReadAndWriteThem) {
    Project p = lawn();
    for (const MovedField& moved : movedFields()) {
        const std::string old = std::string("grass.") + moved.component + "." + moved.field,
                          path = std::string("grass.") + moved.to + "." + moved.field;
        const auto before = findField(p, tables().components, old), now = findField(p, tables().components, path);
        ASSERT_TRUE(before && now) << old;
        EXPECT_EQ(before->value, now->value) << old;
    }
    const auto f = findField(p, tables().components, "grass.GrassField.minGeom");
    ASSERT_TRUE(setFieldText(*f, "2.5"));
    EXPECT_EQ(flatField(p).minGeom, 2.5f);
}

}  // namespace
}  // namespace sward::test
