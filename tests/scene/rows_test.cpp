// The tables of components: finding rows, and how paths name elements of lists.
#include "scene/rows.h"

#include <gtest/gtest.h>

#include "scene/components.h"
#include "techniques.h"

namespace sward {
namespace {

const FieldRow* fieldOf(const ComponentRow& row, std::string_view name) {
    for (const FieldRow& f : row.fields)
        if (name == f.name) return &f;
    return nullptr;
}

TEST(Rows, AComponentIsFoundByItsWholeNameAlone) {
    const auto rows = tables().components;
    for (const ComponentRow& row : rows) EXPECT_EQ(findComponent(rows, row.name), &row);
    for (const char* none : {"", "grassField", "Grass", "GrassField "})
        EXPECT_EQ(findComponent(rows, none), nullptr) << none;
}

TEST(Rows, AnElementIsSelectedByANameThatIsItsOwnElseByItsNumber) {
    const ComponentRow* field = findComponent(tables().components, "GrassField");
    ASSERT_NE(field, nullptr);
    const FieldRow* species = fieldOf(*field, "species");
    ASSERT_NE(species, nullptr);
    ASSERT_NE(species->list, nullptr);
    const auto selectors = [&](std::initializer_list<const char*> names) {
        std::vector<Species> list;
        for (const char* name : names) list.emplace_back().name = name;
        const std::vector<std::string> all = elementSelectors(*species->list, &list);
        for (size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(elementSelector(*species->list, &list, i), all[i]);
            EXPECT_EQ(selectedElement(*species->list, &list, all[i]), i);
            EXPECT_EQ(selectedElement(*species->list, &list, std::to_string(i)), i) << "its number will do, too";
        }
        for (const char* none : {"", "nobody", "99", "-1", "1x", "a.b"})
            EXPECT_EQ(selectedElement(*species->list, &list, none), std::nullopt) << none;
        return all;
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
