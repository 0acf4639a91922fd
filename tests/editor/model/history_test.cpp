// Undo and redo as two stacks that stay within their bytes.
#include "model/history.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

// About 2 kB each.
UndoStep step(const std::string& label) { return {label, {{"entity", nullptr, nullptr, std::make_shared<int>(1)}}}; }

TEST(History, StepsGoBackAndForthInOrder) {
    History h(1 << 20);
    EXPECT_EQ(h.next(false), nullptr);
    h.push(step("a"));
    h.push(step("b"));
    EXPECT_EQ(h.next(false)->label, "b");
    h.moved(false);
    EXPECT_EQ(h.next(false)->label, "a");
    EXPECT_EQ(h.next(true)->label, "b");
    EXPECT_EQ(h.position(), 1u);
    h.moved(true);
    EXPECT_EQ(h.next(true), nullptr);
    EXPECT_EQ(h.position(), 2u);
}

TEST(History, ANewStepForgetsWhatCouldBeRedone) {
    History h(1 << 20);
    h.push(step("a"));
    h.moved(false);
    h.push(step("b"));
    EXPECT_EQ(h.next(true), nullptr);
    EXPECT_EQ(h.next(false)->label, "b");
}

TEST(History, TheOldestGoWhenBytesRunOutAndTheNewestStays) {
    const size_t one = stepBytes(step("x"));
    History h(2 * one);
    for (const char* label : {"a", "b", "c"}) h.push(step(label));
    EXPECT_EQ(h.bytes(), 2 * one);
    EXPECT_EQ(h.position(), 3u) << "forgotten ones count";
    h.moved(false), h.moved(false);
    EXPECT_EQ(h.next(false), nullptr) << "a is gone";
    History tiny(1);
    tiny.push(step("a"));
    EXPECT_EQ(tiny.next(false)->label, "a");
}

TEST(History, ALaterChangeExtendsTheEarlierAndWhatChangesNothingIsDropped) {
    std::vector<Change> changes;
    const auto one = std::make_shared<int>(1), two = std::make_shared<int>(2);
    mergeChange(changes, {"a", nullptr, nullptr, one});
    mergeChange(changes, {"b", nullptr, one, nullptr});
    mergeChange(changes, {"a", nullptr, one, two});
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_EQ(changes[0].before, nullptr);
    EXPECT_EQ(changes[0].after, two);
    mergeChange(changes, {"a", nullptr, two, nullptr});
    dropEmptyChanges(changes);
    ASSERT_EQ(changes.size(), 1u) << "it came and went";
    EXPECT_EQ(changes[0].entity, "b");
}

}  // namespace
}  // namespace sward
