// The gizmo's mathematics: what a drag means, and that it never runs away.
#include "tools/gizmo.h"

#include <gtest/gtest.h>

#include <set>

namespace sward {
namespace {

using Kinds = std::vector<HandleKind>;

// An eye at (0, 3, 10) that looks at the origin, 800 pixels high at 60 degrees.
struct Seen {
    glm::dvec3 eye{0, 3, 10}, forward = glm::normalize(glm::dvec3(0, -3, -10)), right{1, 0, 0};
    double focal = 400 / std::tan(glm::radians(30.0));
    std::optional<glm::dvec2> project(const glm::dvec3& p) const {
        const glm::dvec3 d = p - eye, up = glm::cross(right, forward);
        const double depth = glm::dot(d, forward);
        if (depth < 0.05) return std::nullopt;
        return glm::dvec2(400 + glm::dot(d, right) / depth * focal, 400 - glm::dot(d, up) / depth * focal);
    }
    GizmoRay ray(const glm::dvec2& at) const {
        const glm::dvec3 up = glm::cross(right, forward);
        return {eye, glm::normalize(forward + right * ((at.x - 400) / focal) + up * ((400 - at.y) / focal))};
    }
    GizmoView view(const glm::dvec3& pivot) const {
        return {eye, forward, glm::dot(pivot - eye, forward) / focal,
                [this](const glm::dvec3& p) { return project(p); }};
    }
};

ScreenPart partNamed(const std::vector<ScreenPart>& parts, const std::string& name) {
    for (const ScreenPart& s : parts)
        if (s.part->name == name) return s;
    ADD_FAILURE() << name << " is not on the screen";
    return {};
}

std::optional<Motion> dragged(const Seen& seen, GizmoMode mode, const std::string& name, const glm::dvec3& pivot,
                              const glm::dvec2& by, const GizmoSteps* steps = nullptr) {
    const Kinds kinds{HandleKind::Object};
    const ScreenPart part = partNamed(screenParts(mode, kinds, pivot, seen.view(pivot)), name);
    const GizmoGrab grab = grabPart(part, pivot, seen.view(pivot), part.grip, seen.ray(part.grip));
    return motionOf(grab, part.grip + by, seen.ray(part.grip + by), steps);
}

TEST(Gizmo, AnAxisFollowsTheHandAndMovesAlongItAlone) {
    const Seen seen;
    const glm::dvec3 pivot{1, 0, -2};
    const auto m = dragged(seen, GizmoMode::Move, "move x", pivot, {60, 0});
    ASSERT_TRUE(m);
    EXPECT_GT(m->move.x, 0.5);
    EXPECT_EQ(m->move.y, 0);
    EXPECT_EQ(m->move.z, 0);
    const glm::dvec2 before = *seen.project(pivot), after = *seen.project(pivot + m->move);
    EXPECT_NEAR(after.x - before.x, 60, 1.5) << "it stays under the hand";
    const auto back = dragged(seen, GizmoMode::Move, "move x", pivot, {0, 0});
    EXPECT_EQ(back->move, glm::dvec3(0));
}

TEST(Gizmo, APlaneFollowsTheHandInBothDirectionsAndItsMiddleInTheScreens) {
    const Seen seen;
    const glm::dvec3 pivot{0, 0, 0};
    const auto flat = dragged(seen, GizmoMode::Move, "move xz", pivot, {40, 25});
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->move.y, 0);
    EXPECT_GT(flat->move.x, 0.1);
    EXPECT_GT(flat->move.z, 0.1) << "down on the screen is nearer";
    const auto free = dragged(seen, GizmoMode::Move, "move free", pivot, {40, 25});
    ASSERT_TRUE(free);
    EXPECT_NEAR(glm::dot(free->move, seen.forward), 0, 1e-12);
    EXPECT_NEAR(glm::length(*seen.project(free->move) - *seen.project(pivot) - glm::dvec2(40, 25)), 0, 1e-6);
}

TEST(Gizmo, ARayParallelToAnAxisOrAPlaneMovesNothing) {
    const glm::dvec3 x{1, 0, 0}, y{0, 1, 0};
    EXPECT_FALSE(alongAxis({0, 0, 0}, x, {{-10, 1, 0}, x}));
    EXPECT_FALSE(alongAxis({0, 0, 0}, x, {{-10, 1, 0}, glm::normalize(glm::dvec3(1, 0.01, 0))}));
    EXPECT_FALSE(onPlane({0, 0, 0}, y, {{-10, 1, 0}, x}));
    EXPECT_FALSE(onPlane({0, 0, 0}, y, {{-10, 1, 0}, glm::normalize(glm::dvec3(1, -0.01, 0))}));
    EXPECT_FALSE(onPlane({0, 0, 0}, y, {{-10, 1, 0}, glm::normalize(glm::dvec3(-1, 1, 0))})) << "behind the eye";
}

TEST(Gizmo, NoDragThrowsAnythingToInfinity) {
    const Seen seen;
    const glm::dvec3 pivot{0.3, 0, 0};
    for (const GizmoPart& part : gizmoParts()) {
        const Kinds kinds{HandleKind::Object};
        for (const ScreenPart& s : screenParts(part.mode, kinds, pivot, seen.view(pivot))) {
            const GizmoGrab grab = grabPart(s, pivot, seen.view(pivot), s.grip, seen.ray(s.grip));
            for (double x = -3000; x <= 3800; x += 85)
                for (double y = -3000; y <= 3800; y += 85) {
                    const auto m = motionOf(grab, {x, y}, seen.ray({x, y}), nullptr);
                    if (!m) continue;
                    EXPECT_LT(glm::length(m->move), 120 * glm::length(pivot - seen.eye)) << part.name;
                    EXPECT_LT(std::abs(m->angle), 120) << part.name;
                    EXPECT_GE(m->scale, 0.01);
                    EXPECT_LE(m->scale, 100);
                }
        }
    }
}

TEST(Gizmo, ItIsOfOneSizeWhereverItStands) {
    const Seen seen;
    for (const glm::dvec3 pivot : {glm::dvec3(0, 2, 6), glm::dvec3(0, 0, -40), glm::dvec3(0, 0, -4000)}) {
        const Kinds kinds{HandleKind::Object};
        const ScreenPart x = partNamed(screenParts(GizmoMode::Move, kinds, pivot, seen.view(pivot)), "move x");
        EXPECT_NEAR(glm::length(x.grip - *seen.project(pivot)), 84, 3) << pivot.z;
    }
}

TEST(Gizmo, AnAxisThatPointsAtTheEyeIsNotOffered) {
    const Seen seen;
    const glm::dvec3 pivot = seen.eye + glm::dvec3(0, 0, -20);  // level with the eye, whose view goes down
    const Kinds kinds{HandleKind::Object};
    std::set<std::string> names;
    for (const ScreenPart& s : screenParts(GizmoMode::Move, kinds, pivot, seen.view(pivot))) names.insert(s.part->name);
    EXPECT_FALSE(names.contains("move z"));
    EXPECT_FALSE(names.contains("move xz")) << "seen from its edge";
    EXPECT_TRUE(names.contains("move x"));
    EXPECT_TRUE(names.contains("move xy"));
}

TEST(Gizmo, ARingTurnsByTheWayAlongItsTangent) {
    const Seen seen;
    const auto right = dragged(seen, GizmoMode::Turn, "turn y", {0, 0, 0}, {70, 0});
    ASSERT_TRUE(right);
    EXPECT_EQ(right->axis, glm::dvec3(0, 1, 0));
    EXPECT_NEAR(right->angle, 1, 0.05) << "a radius is a radian, counter-clockwise from above";
    const auto across = dragged(seen, GizmoMode::Turn, "turn y", {0, 0, 0}, {0, 40});
    EXPECT_NEAR(across->angle, 0, 0.05);
}

TEST(Gizmo, CtrlSnapsToTheGridToAnglesAndToFactors) {
    const Seen seen;
    GizmoSteps steps;
    steps.grid = 0.5f, steps.angleDeg = 15, steps.scale = 0.25f;
    const glm::dvec3 pivot{0.13, 0, 0};
    const auto moved = dragged(seen, GizmoMode::Move, "move x", pivot, {90, 0}, &steps);
    ASSERT_TRUE(moved);
    const double at = pivot.x + moved->move.x;
    EXPECT_GT(at, 0.4);
    EXPECT_NEAR(at, std::round(at * 2) / 2, 1e-12) << "on the world's grid";
    const auto turned = dragged(seen, GizmoMode::Turn, "turn y", {0, 0, 0}, {40, 0}, &steps);
    EXPECT_NEAR(glm::degrees(turned->angle), 30, 1e-9);
    const auto scaled = dragged(seen, GizmoMode::Scale, "scale", {0, 0, 0}, {20, -20}, &steps);
    EXPECT_NEAR(scaled->scale, 1.5, 1e-9);
    EXPECT_EQ(snapped(0.37, 0), 0.37) << "no step";
}

TEST(Gizmo, ThePointerMeansTheMiddleThenPlanesThenTheNearestLine) {
    const Seen seen;
    const Kinds kinds{HandleKind::Object};
    const auto parts = screenParts(GizmoMode::Move, kinds, {0, 0, 0}, seen.view({0, 0, 0}));
    for (const char* name : {"move x", "move y", "move xz", "move free"}) {
        const ScreenPart* at = partAt(parts, partNamed(parts, name).grip);
        ASSERT_NE(at, nullptr) << name;
        EXPECT_STREQ(at->part->name, name);
    }
    EXPECT_EQ(partAt(parts, {10, 10}), nullptr);
}

TEST(Gizmo, HandlesAreThoseThatDoSomething) {
    const auto names = [](GizmoMode mode, const Kinds& kinds) {
        std::set<std::string> out;
        for (const GizmoPart& part : gizmoParts())
            if (part.mode == mode && partFits(part, kinds)) out.insert(part.name);
        return out;
    };
    using enum HandleKind;
    EXPECT_EQ(names(GizmoMode::Move, {Water}), (std::set<std::string>{"move y"}));
    EXPECT_EQ(names(GizmoMode::Move, {Lamp}).size(), 7u);
    EXPECT_EQ(names(GizmoMode::Turn, {Lamp}).size(), 0u);
    EXPECT_EQ(names(GizmoMode::Turn, {Lamp, Lamp}), (std::set<std::string>{"turn y"}));
    EXPECT_EQ(names(GizmoMode::Turn, {Force}), (std::set<std::string>{"turn y"}));
    EXPECT_EQ(names(GizmoMode::Turn, {Camera}).size(), 3u);
    EXPECT_EQ(names(GizmoMode::Scale, {Camera}).size(), 0u);
    EXPECT_EQ(names(GizmoMode::Scale, {Camera, Object}), (std::set<std::string>{"scale"}));
}

}  // namespace
}  // namespace sward
