// Several entities are chosen; the last one counts where one must.
#include "app/selection.h"

#include <gtest/gtest.h>

#include "scene/project.h"

namespace sward {
namespace {

using Names = std::vector<std::string>;

TEST(Selection, AloneAddedAndToggled) {
    Selection s;
    EXPECT_EQ(shownEntity(s), "");
    choose(s, "a");
    choose(s, "b", Choose::Add);
    choose(s, "c", Choose::Add);
    EXPECT_EQ(s.entities, (Names{"a", "b", "c"}));
    EXPECT_EQ(shownEntity(s), "c");
    choose(s, "a", Choose::Add);
    EXPECT_EQ(shownEntity(s), "a") << "chosen again, it is the last";
    choose(s, "b", Choose::Toggle);
    choose(s, "d", Choose::Toggle);
    EXPECT_EQ(s.entities, (Names{"c", "a", "d"}));
    EXPECT_TRUE(isChosen(s, "c"));
    EXPECT_FALSE(isChosen(s, "b"));
    choose(s, "b");
    EXPECT_EQ(s.entities, Names{"b"});
}

TEST(Selection, ABoxTogglesEachOfItsOwn) {
    Selection s;
    choose(s, Names{"a", "b"}, Choose::Only);
    choose(s, Names{"b", "c"}, Choose::Toggle);
    EXPECT_EQ(s.entities, (Names{"a", "c"}));
    choose(s, Names{}, Choose::Only);
    EXPECT_TRUE(s.entities.empty());
}

TEST(Selection, ModifiersSayHow) {
    EXPECT_EQ(howChosen(false, false), Choose::Only);
    EXPECT_EQ(howChosen(false, true), Choose::Add);
    EXPECT_EQ(howChosen(true, false), Choose::Toggle);
}

TEST(Selection, WhatIsGoneIsForgotten) {
    Project p;
    ASSERT_TRUE(addEntity(p, "a"));
    Selection s;
    choose(s, Names{"a", "gone"}, Choose::Only);
    dropMissing(s, p);
    EXPECT_EQ(s.entities, Names{"a"});
}

}  // namespace
}  // namespace sward
