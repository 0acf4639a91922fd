// The tables of components: finding rows, and how paths name elements of lists.
#include "scene/rows.h"

#include <gtest/gtest.h>

#include "scene/components.h"

namespace sward {
namespace {

const FieldRow* fieldOf(const ComponentRow& row, std::string_view name) {
    for (const FieldRow& f : row.fields)
        if (name == f.name) return &f;
    return nullptr;
}

TEST(Rows, AComponentIsFoundByItsWholeNameAlone) {
    const auto rows = sharedComponentRows();
    for (const ComponentRow& row : rows) EXPECT_EQ(findComponent(rows, row.name), &row);
    for (const char* none : {"", "grassField", "Grass", "GrassField "})
        EXPECT_EQ(findComponent(rows, none), nullptr) << none;
}

TEST(Rows, AnElementIsSelectedByANameThatIsItsOwnElseByItsNumber) {
    const ComponentRow* field = findComponent(sharedComponentRows(), "GrassField");
    ASSERT_NE(field, nullptr);
    const FieldRow* species = fieldOf(*field, "species");
    ASSERT_NE(species, nullptr);
    ASSERT_NE(species->list, nullptr);
    const auto selectors = [&](std::initializer_list<const char*> names) {
        std::vector<Species> list;
        for (const char* name : names) list.emplace_back().name = name;
        return elementSelectors(*species->list, &list);
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(selectors({}), Texts{});
    EXPECT_EQ(selectors({"lawn", "weeds"}), (Texts{"lawn", "weeds"}));
    EXPECT_EQ(selectors({"lawn", "weeds", "lawn"}), (Texts{"0", "weeds", "2"})) << "a name of two is no name";
    EXPECT_EQ(selectors({"", "7", "a.b", "a[b", "7a"}), (Texts{"0", "1", "2", "3", "7a"}))
        << "numbers and marks of paths would be read as something else";
}

}  // namespace
}  // namespace sward
