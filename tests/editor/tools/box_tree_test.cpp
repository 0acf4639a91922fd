// A ray finds the nearest box without looking at most of them.
#include "tools/box_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace sward {
namespace {

std::vector<Box> scattered(size_t count, double size) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 1000), height(0, 20), half(0.1, size);
    std::vector<Box> boxes;
    for (size_t i = 0; i < count; ++i) {
        const glm::dvec3 at(place(random), height(random), place(random));
        boxes.push_back({at - half(random), at + half(random)});
    }
    return boxes;
}

// The box that the ray enters first, by looking at them all.
std::optional<size_t> nearestOf(const std::vector<Box>& boxes, const glm::dvec3& from, const glm::dvec3& way) {
    std::optional<size_t> best;
    double far = 1e9;
    for (size_t i = 0; i < boxes.size(); ++i)
        if (const auto t = entry(boxes[i], from, way, far); t && *t < far) far = *t, best = i;
    return best;
}

std::optional<size_t> castAt(const BoxTree& tree, const std::vector<Box>& boxes, const glm::dvec3& from,
                             const glm::dvec3& way, size_t* looked = nullptr) {
    std::optional<size_t> best;
    const size_t count = tree.cast(from, way, 1e9, [&](size_t i, double far) {
        const auto t = entry(boxes[i], from, way, far);
        if (!t || *t >= far) return far;
        best = i;
        return *t;
    });
    if (looked) *looked = count;
    return best;
}

TEST(BoxTree, ARayMeetsTheSameBoxAsByLookingAtThemAll) {
    const std::vector<Box> boxes = scattered(3000, 4);
    const BoxTree tree(boxes);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-100, 1100), angle(-1, 1);
    int met = 0;
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 from(place(random), 10 + 20 * angle(random), place(random));
        const glm::dvec3 way = glm::normalize(glm::dvec3(angle(random), 0.2 * angle(random), angle(random)));
        const auto wanted = nearestOf(boxes, from, way);
        ASSERT_EQ(castAt(tree, boxes, from, way), wanted) << i;
        met += wanted.has_value();
    }
    EXPECT_GT(met, 80);
}

TEST(BoxTree, OfFiftyThousandBoxesARayLooksAtFewHundreds) {
    const std::vector<Box> boxes = scattered(50000, 1);
    const BoxTree tree(boxes);
    size_t most = 0;
    for (int i = 0; i < 200; ++i) {
        const double a = i * 0.0314159;
        size_t looked = 0;
        castAt(tree, boxes, {500, 60, 500}, glm::normalize(glm::dvec3(std::cos(a), -0.15, std::sin(a))), &looked);
        most = std::max(most, looked);
    }
    EXPECT_LT(most, 2000u);
    EXPECT_GT(most, 20u);
}

// The nodes follow boxes that move, and a ray still looks at few.
TEST(BoxTree, BoxesThatMovedAreMetWhereTheyAreNow) {
    std::vector<Box> boxes = scattered(5000, 2);
    BoxTree tree(boxes);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0, 1000), angle(-1, 1);
    size_t most = 0;
    int met = 0;
    for (int round = 0; round < 40; ++round) {  // most of them in the end: made anew on the way
        std::vector<std::pair<uint32_t, Box>> moved;
        for (int k = 0; k < 100; ++k) {
            const uint32_t i = static_cast<uint32_t>(random() % boxes.size());
            const glm::dvec3 at(place(random), 10, place(random));
            moved.emplace_back(i, boxes[i] = {at - 1.5, at + 1.5});
        }
        tree.follow(moved);
        for (int ray = 0; ray < 20; ++ray) {
            const glm::dvec3 way = glm::normalize(glm::dvec3(angle(random), 0.02 * angle(random), angle(random)));
            const auto wanted = nearestOf(boxes, {500, 10, 500}, way);
            size_t looked = 0;
            ASSERT_EQ(castAt(tree, boxes, {500, 10, 500}, way, &looked), wanted) << round << " " << ray;
            most = std::max(most, looked);
            met += wanted.has_value();
        }
    }
    EXPECT_GT(met, 400);
    EXPECT_LT(most, 2500u) << "half of the boxes";
}

TEST(BoxTree, NothingIsMetInNoBoxesBehindTheEyeOrBeyondTheEnd) {
    const auto never = [](size_t, double far) {
        ADD_FAILURE();
        return far;
    };
    EXPECT_EQ(BoxTree().cast({0, 0, 0}, {1, 0, 0}, 1e9, never), 0u);
    const BoxTree tree({{{1, -1, -1}, {2, 1, 1}}});
    tree.cast({0, 0, 0}, {-1, 0, 0}, 1e9, never);
    tree.cast({0, 0, 0}, {1, 0, 0}, 0.5, never);
    tree.cast({0, 5, 0}, {1, 0, 0}, 1e9, never);  // along a side that it passes
    EXPECT_EQ(entry({{-1, -1, -1}, {1, 1, 1}}, {0, 0, 0}, {0, 1, 0}, 9).value_or(-1), 0) << "from within";
}

TEST(BoxTree, BoxesInOnePlaceAreAllMet) {
    const BoxTree tree(std::vector<Box>(100, {{1, -1, -1}, {2, 1, 1}}));
    int met = 0;
    tree.cast({0, 0, 0}, {1, 0, 0}, 1e9, [&](size_t, double far) {
        ++met;
        return far;
    });
    EXPECT_EQ(met, 100);
}

}  // namespace
}  // namespace sward
