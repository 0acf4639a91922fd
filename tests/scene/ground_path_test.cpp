#include "scene/ground_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "project/project_files.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {
namespace {

GroundPath through(const std::vector<glm::dvec2>& places, bool closed = false) {
    GroundPath p;
    for (const glm::dvec2& at : places) p.points.push_back({"", at});
    p.closed = closed;
    return p;
}
const std::vector<glm::dvec2> kWinding{{2, 3}, {7, 1}, {9, 8}, {3, 9}, {3.2, 8.7}, {12, 14}};

// What finds the nearest place by trying very many.
double triedDistance(const GroundCurve& curve, const glm::dvec2& place) {
    double best = 1e300;
    for (const CurvePiece& piece : curve.pieces)
        for (int i = 0; i <= 20000; ++i) best = std::min(best, glm::length(placeOn(piece, i / 20000.0) - place));
    return best;
}

TEST(GroundPath, ItsCurvePassesItsPointsWithoutAKink) {
    for (const bool closed : {false, true}) {
        const GroundCurve curve = groundCurve(through(kWinding, closed));
        ASSERT_EQ(curve.pieces.size(), kWinding.size() - (closed ? 0 : 1));
        for (size_t i = 0; i < curve.pieces.size(); ++i) {
            EXPECT_LT(glm::length(placeOn(curve.pieces[i], 0) - kWinding[i]), 1e-12);
            EXPECT_EQ(curve.pieces[i].from, i);
            if (i == 0 && !closed) continue;
            const CurvePiece& before = curve.pieces[(i + curve.pieces.size() - 1) % curve.pieces.size()];
            const glm::dvec2 in = glm::normalize(slopeOn(before, 1)), out = glm::normalize(slopeOn(curve.pieces[i], 0));
            EXPECT_LT(glm::length(in - out), 1e-9) << i;
        }
    }
}
TEST(GroundPath, PointsOnALineGiveThatLine) {
    const GroundCurve curve = groundCurve(through({{0, 0}, {1, 2}, {4, 8}, {4.5, 9}}));
    for (const CurvePiece& piece : curve.pieces)
        for (double t = 0; t <= 1; t += 0.05) {
            const glm::dvec2 at = placeOn(piece, t);
            EXPECT_NEAR(at.y, 2 * at.x, 1e-12);
        }
}
TEST(GroundPath, TheNearestPlaceIsNoneThatTryingManyBeats) {
    for (const bool closed : {false, true}) {
        const GroundCurve curve = groundCurve(through(kWinding, closed));
        for (double x = -3; x < 16; x += 1.37)
            for (double z = -3; z < 17; z += 1.21) {
                const NearestOnCurve n = nearestOn(curve, {x, z});
                const double tried = triedDistance(curve, {x, z});
                EXPECT_LE(n.distance, tried + 1e-12) << x << " " << z;
                EXPECT_GE(n.distance * n.distance, tried * tried - 1e-6) << "tried 0.5 mm apart";
                EXPECT_LT(glm::length(n.at - placeOn(curve.pieces[n.piece], n.t)), 1e-12);
                EXPECT_NEAR(glm::length(n.at - glm::dvec2(x, z)), n.distance, 1e-12);
            }
    }
}
TEST(GroundPath, APlaceOnTheCurveHasNoDistance) {
    const GroundCurve curve = groundCurve(through(kWinding));
    for (const CurvePiece& piece : curve.pieces)
        for (double t = 0; t <= 1; t += 0.0625) EXPECT_LT(nearestOn(curve, placeOn(piece, t)).distance, 1e-9);
}
TEST(GroundPath, DistanceToAStraightPathIsThatToALine) {
    const GroundCurve curve = groundCurve(through({{10, 10}, {20, 10}}));
    EXPECT_NEAR(nearestOn(curve, {13, 14}).distance, 4, 1e-12);
    EXPECT_NEAR(nearestOn(curve, {15, 7}).distance, 3, 1e-12) << "its middle, where a half begins";
    EXPECT_NEAR(nearestOn(curve, {7, 14}).distance, 5, 1e-12) << "its end is nearest";
    EXPECT_EQ(nearestOn(curve, {13, 14}, 3.9).distance, std::numeric_limits<double>::infinity());
}
TEST(GroundPath, NinetyKilometresFromTheOriginItIsTheSame) {
    std::vector<glm::dvec2> far = kWinding;
    for (glm::dvec2& at : far) at += glm::dvec2(90000, -90000);
    const GroundCurve here = groundCurve(through(kWinding)), there = groundCurve(through(far));
    for (double x = -3; x < 16; x += 2.3)
        EXPECT_NEAR(nearestOn(here, {x, 5}).distance, nearestOn(there, {x + 90000, 5 - 90000}).distance, 1e-9);
    EXPECT_NEAR(nearestOn(here, {90000, 3}).distance, triedDistance(here, {90000, 3}), 1e-6);
}
TEST(GroundPath, FewPointsAndDoubledOnesGiveNumbers) {
    EXPECT_TRUE(groundCurve(through({})).pieces.empty());
    EXPECT_EQ(weightAt(through({}), groundCurve(through({})), {1, 1}), 0);
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const bool closed : {false, true})
        for (const std::vector<glm::dvec2>& places : std::vector<std::vector<glm::dvec2>>{
                 {{5, 5}},
                 {{5, 5}, {5, 5}},
                 {{5, 5}, {5, 5}, {5, 5}, {5, 5}},
                 {{nan, 5}, {5, 5}, {inf, inf}},
                 {{5, 5}, {5 + 1e-200, 5}},
             }) {
            const GroundPath path = through(places, closed);
            const GroundCurve curve = groundCurve(path);
            ASSERT_FALSE(curve.pieces.empty());
            EXPECT_NEAR(nearestOn(curve, {8, 9}).distance, 5, 1e-12);
            EXPECT_EQ(weightAt(path, curve, {5, 5}), 1);
            EXPECT_EQ(weightAt(path, curve, {8, 9}), 0);
            EXPECT_EQ(stationsOn(curve).size(), 1u);
            EXPECT_EQ(placeAlong(stationsOn(curve), 3), glm::dvec2(5, 5));
        }
    const GroundCurve doubled = groundCurve(through({{0, 0}, {4, 0}, {4, 0}, {8, 0}}));
    ASSERT_EQ(doubled.pieces.size(), 2u);
    EXPECT_EQ(doubled.pieces[1].from, 1u);
    EXPECT_NEAR(nearestOn(doubled, {4, 3}).distance, 3, 1e-12);
    EXPECT_EQ(weightAt(through({{0, 0}, {4, 0}}), doubled, {nan, 0}), 0);
}
TEST(GroundPath, ThereAndBackIsClosed) {
    const GroundCurve curve = groundCurve(through({{0, 0}, {4, 0}}, true));
    ASSERT_EQ(curve.pieces.size(), 2u);
    EXPECT_NEAR(nearestOn(curve, {2, 1}).distance, 1, 1e-12);
    EXPECT_EQ(groundCurve(through({{0, 0}, {4, 0}, {0, 0}}, true)).pieces.size(), 2u);
}

TEST(GroundPath, WeightIsFullOverTheWidthAndFadesSmoothlyToNothing) {
    GroundPath path = through({{0, 0}, {10, 0}});
    path.width = 2, path.falloff = 1;
    const GroundCurve curve = groundCurve(path);
    EXPECT_EQ(weightAt(path, curve, {5, 0}), 1);
    EXPECT_EQ(weightAt(path, curve, {5, 1}), 1);
    EXPECT_NEAR(weightAt(path, curve, {5, 1.5}), 0.5, 1e-12);
    EXPECT_EQ(weightAt(path, curve, {5, 2}), 0);
    double last = 1;
    for (double z = 0; z < 2.2; z += 0.01) {
        const double w = weightAt(path, curve, {5, z});
        EXPECT_LE(w, last);
        EXPECT_LT(last - w, 0.016) << "1.5 a metre at most";
        last = w;
    }
}
TEST(GroundPath, WithoutFalloffItHasAnEdgeAndWithoutWidthALine) {
    GroundPath path = through({{0, 0}, {10, 0}});
    path.width = 2, path.falloff = 0;
    EXPECT_EQ(weightAt(path, groundCurve(path), {5, 1}), 1);
    EXPECT_EQ(weightAt(path, groundCurve(path), {5, 1.001}), 0);
    path.width = 0;
    EXPECT_EQ(weightAt(path, groundCurve(path), {5, 0}), 1);
    EXPECT_EQ(weightAt(path, groundCurve(path), {5, 0.001}), 0);
}
TEST(GroundPath, ItsBoxHoldsAllOfItsEffect) {
    const GroundPath path = through(kWinding);
    const GroundCurve curve = groundCurve(path);
    const GroundBox box = boxOf(curve, reachOf(path));
    int covered = 0;
    for (double x = -3; x < 17; x += 0.1)
        for (double z = -3; z < 19; z += 0.1)
            if (weightAt(path, curve, {x, z}) > 0) {
                ++covered;
                EXPECT_TRUE(x >= box.low.x && x <= box.high.x && z >= box.low.y && z <= box.high.y) << x << " " << z;
            }
    EXPECT_GT(covered, 1000);
    EXPECT_GT(boxOf({}, 1).low.x, boxOf({}, 1).high.x);
}

TEST(GroundPath, StationsCountMetres) {
    const std::vector<CurveStation> line = stationsOn(groundCurve(through({{0, 0}, {3, 0}, {10, 0}})));
    EXPECT_NEAR(line.back().metres, 10, 1e-9);
    EXPECT_NEAR(placeAlong(line, 4).x, 4, 1e-9);
    EXPECT_EQ(placeAlong(line, -1), glm::dvec2(0, 0));
    EXPECT_EQ(placeAlong(line, 99), glm::dvec2(10, 0));
    std::vector<glm::dvec2> circle;
    for (int i = 0; i < 16; ++i) circle.push_back({5 * std::cos(i * M_PI / 8), 5 * std::sin(i * M_PI / 8)});
    const GroundCurve ring = groundCurve(through(circle, true));
    const std::vector<CurveStation> around = stationsOn(ring);
    EXPECT_NEAR(around.back().metres, 10 * M_PI, 0.1) << "nearly a circle";
    EXPECT_LT(glm::length(around.back().at - around.front().at), 1e-12);
}

TEST(GroundPath, SurvivesSaving) {
    const TempDir dir;
    Project p = lawn();
    p.dir = dir / "p";
    GroundPath path = through(kWinding, true);
    path.width = 2.5f, path.falloff = 0.25f, path.grass = 0.5f, path.flowers = 0;
    put(p, "way", path);
    const auto saved = saveProject(p, tables().components);
    ASSERT_TRUE(saved) << saved.error().text();
    const auto loaded = loadProject(p.dir, tables().components);
    ASSERT_TRUE(loaded) << loaded.error().text();
    const GroundPath& back = *loaded->registry.get<GroundPath>(findEntity(*loaded, "way"));
    ASSERT_EQ(back.points.size(), path.points.size());
    for (size_t i = 0; i < path.points.size(); ++i) EXPECT_EQ(back.points[i].at, path.points[i].at);
    EXPECT_TRUE(back.closed);
    EXPECT_EQ(back.width, 2.5f);
    EXPECT_EQ(back.falloff, 0.25f);
    EXPECT_EQ(back.grass, 0.5f);
    EXPECT_EQ(back.flowers, 0);
}
TEST(GroundPath, NumbersThatAreNoneAreRefusedWithTheirPlace) {
    const TempDir dir;
    writeText(dir / "p/project.json",
              "{\"format\": 1, \"entities\": {\"way\": {\"GroundPath\": {\"points\": [\n{\"at\": [1, \"NaN\"]}]}}}}");
    const auto loaded = loadProject(dir / "p", tables().components);
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().text().find("way.GroundPath.points[0].at"), std::string::npos) << loaded.error().text();
    EXPECT_NE(loaded.error().text().find(":2"), std::string::npos) << loaded.error().text();
}
TEST(GroundPath, CheckSaysWhereThereIsNoPathOrASpot) {
    Project p = lawn();
    const ComponentRow row = groundPathRow();
    const auto faults = [&](const GroundPath& path) {
        put(p, "way", path);
        std::vector<ComponentFault> out;
        row.check(p.registry, findEntity(p, "way"), "way.GroundPath", out);
        return out;
    };
    EXPECT_TRUE(faults(through(kWinding)).empty());
    ASSERT_EQ(faults(through({})).size(), 1u);
    EXPECT_NE(faults(through({}))[0].message.find("way.GroundPath.points: there is none"), std::string::npos);
    ASSERT_EQ(faults(through({{1, 1}, {1, 1}})).size(), 1u);
    EXPECT_NE(faults(through({{1, 1}, {1, 1}}))[0].message.find("one place"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
