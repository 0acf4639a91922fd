// Walks along a camera's path: their moments, and what is judged of pictures whose popping is known.
#include "cost/transitions.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reference/reference.h"
#include "scenes.h"
#include "world/camera_path.h"

namespace sward::test {
namespace {

Project walked(const std::vector<CameraKey>& keys) {
    Project p = lawn();
    put(p, "walk", CameraPath{keys, 0});
    put(p, "still", CameraPath{{{"only", 0, {2, 1, 2}, {8, 0, 8}, 55}}, 0});
    return p;
}
const std::vector<CameraKey> kForward = {{"a", 0, {4, 0.6, 4}, {8, 0, 8}, 55}, {"b", 2, {5, 0.6, 5}, {9, 0, 9}, 55}};
const std::vector<CameraKey> kStanding = {{"a", 0, {4, 0.6, 4}, {8, 0, 8}, 55}, {"b", 2, {4, 0.6, 4}, {8, 0, 8}, 55}};

TransitionPlan plan() {
    TransitionPlan plan;
    plan.path = "walk";
    plan.pictures = 5, plan.width = 48, plan.height = 32, plan.samples = 4;
    return plan;
}

// A walk whose pictures are the truth itself.
std::shared_ptr<TransitionWalk> trueWalk(const Project& p) {
    auto walk = beginWalk(p, tables(), plan());
    EXPECT_TRUE(walk) << walk.error().text();
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    ReferenceSettings s;
    s.width = plan().width, s.height = plan().height, s.samples = plan().samples;
    s.lighting = ReferenceLighting::Direct;
    const std::vector<ViewCamera>& views = (*walk)->views;
    for (size_t i = 0; i < views.size(); ++i) {
        s.seed += i > 0 && views[i].eye != views[i - 1].eye;
        const auto truth = scene->trace(views[i], s, control);
        (*walk)->drawn.push_back(tracedPicture(truth->width, truth->height, truth->color, truth->error));
    }
    return *walk;
}
Transitions judged(TransitionWalk& walk) {
    JobControl control;
    double share = 0;
    while (!isTraced(walk)) {
        const Status traced = traceNextOf(walk, tables(), control);
        EXPECT_TRUE(traced) << traced.error().text();
        if (!traced) return {};
        EXPECT_GE(tracedShare(walk), share);
        share = tracedShare(walk);
    }
    EXPECT_EQ(share, 1);
    auto t = judgeWalk(walk);
    EXPECT_TRUE(t) << t.error().text();
    return t ? std::move(*t) : Transitions{};
}

TEST(Transitions, MomentsLieEvenlyFromThePathsBeginningToItsEnd) {
    const Project p = walked(kForward);
    const auto walk = beginWalk(p, tables(), plan());
    ASSERT_TRUE(walk);
    EXPECT_EQ((*walk)->seconds, (std::vector<double>{0, 0.5, 1, 1.5, 2}));
    EXPECT_EQ((*walk)->views[0].eye, glm::dvec3(4, 0.6, 4));
    EXPECT_EQ((*walk)->views[4].eye, glm::dvec3(5, 0.6, 5));
    EXPECT_FALSE(isDrawn(**walk));
}

TEST(Transitions, APartOfThePathIsWalkedAlone) {
    TransitionPlan part = plan();
    part.from = 0.5, part.to = 0.7;
    const auto walk = beginWalk(walked(kForward), tables(), part);
    ASSERT_TRUE(walk);
    EXPECT_EQ((*walk)->seconds.front(), 0.5);
    EXPECT_NEAR((*walk)->seconds[1], 0.55, 1e-12);
    EXPECT_NEAR((*walk)->seconds.back(), 0.7, 1e-12);
}

TEST(Transitions, WhatIsNoWalkIsRefusedWithWhatToDo) {
    const Project p = walked(kForward);
    const auto refused = [&](auto change) {
        TransitionPlan wrong = plan();
        change(wrong);
        const auto walk = beginWalk(p, tables(), wrong);
        EXPECT_FALSE(walk);
        return walk ? std::string() : walk.error().text();
    };
    EXPECT_NE(refused([](auto& w) { w.path = "grass"; }).find("still, walk"), std::string::npos)
        << "it names the paths";
    EXPECT_NE(refused([](auto& w) { w.path = "still"; }).find("no length"), std::string::npos);
    EXPECT_NE(refused([](auto& w) { w.from = 2; }).find("from 0 to 2"), std::string::npos);
    EXPECT_NE(refused([](auto& w) { w.to = 2.5; }).find("from 0 to 2"), std::string::npos);
    EXPECT_NE(refused([](auto& w) { w.from = -1; }).find("from 0 to 2"), std::string::npos);
    EXPECT_NE(refused([](auto& w) { w.pictures = 1; }).find("2 to 400"), std::string::npos);
    EXPECT_NE(refused([](auto& w) { w.width = 8; }).find("16"), std::string::npos);
    EXPECT_NE(refused([](auto& w) { w.samples = 0; }).find("1024"), std::string::npos);
}

TEST(Transitions, TheTruthItselfPopsNothingAndOtherBladesDo) {
    const Transitions t = judged(*trueWalk(walked(kForward)));
    ASSERT_EQ(t.drawn.steps.size(), 4u);
    for (const double step : t.drawn.steps) EXPECT_EQ(step, 0);
    for (const double step : t.floor.steps) EXPECT_GT(step, 0.001);
    EXPECT_EQ(stepsAboveFloor(t), 0u);
    EXPECT_EQ(t.blind, 0u);
}

TEST(Transitions, ACameraThatStandsPopsNothing) {
    const Transitions t = judged(*trueWalk(walked(kStanding)));
    EXPECT_EQ(t.drawn.steps, std::vector<double>(4, 0));
    EXPECT_EQ(t.floor.steps, std::vector<double>(4, 0));
}

TEST(Transitions, APictureThatJumpsIsTheWorstStepAndAboveTheFloor) {
    const auto walk = trueWalk(walked(kForward));
    for (size_t i = 3; i < 5; ++i)
        for (glm::vec3& c : walk->drawn[i].pixels) c = glm::min(c + 0.2f, glm::vec3(1));
    const Transitions t = judged(*walk);
    EXPECT_EQ(t.drawn.worstStep, 2) << "from picture 2 to 3 all gets brighter";
    EXPECT_NEAR(t.drawn.worst, 0.2, 0.03);
    EXPECT_LT(t.drawn.steps[3], 0.02) << "what stays brighter does not pop";
    EXPECT_EQ(stepsAboveFloor(t), 1u);
    EXPECT_NE(transitionsText(t).find("from second 1 to 1.5"), std::string::npos) << transitionsText(t);
    const auto json = nlohmann::json::parse(transitionsJson(t));
    EXPECT_EQ(json.at("worst_step"), (std::vector<double>{1, 1.5}));
    EXPECT_EQ(json.at("above_floor"), 1);
    ASSERT_EQ(json.at("steps").size(), 4u);
    EXPECT_EQ(json["steps"][2]["popping"].get<double>(), t.drawn.worst);
    EXPECT_EQ(json["steps"][2]["floor"].get<double>(), t.floor.steps[2]);
}

TEST(Transitions, APictureThatStandsStillWhileTheTruthMovesIsAboveTheFloor) {
    const auto walk = trueWalk(walked(kForward));
    std::fill(walk->drawn.begin(), walk->drawn.end(), Picture(walk->drawn[0]));
    const Transitions t = judged(*walk);
    EXPECT_GE(stepsAboveFloor(t), 3u) << transitionsText(t);
    EXPECT_GT(t.drawn.mean, t.floor.mean);
    EXPECT_EQ(t.drawn.change, 0);
}

TEST(Transitions, PicturesWithoutGrassCountNothingAndAreTold) {
    const std::vector<CameraKey> up = {{"a", 0, {4, 1, 4}, {8, 9, 8}, 30}, {"b", 2, {5, 1, 5}, {9, 10, 9}, 30}};
    const Transitions t = judged(*trueWalk(walked(up)));
    EXPECT_EQ(t.blind, 5u);
    EXPECT_EQ(t.floor.worst, 0);
    EXPECT_NE(transitionsText(t).find("5 pictures see no grass"), std::string::npos);
}

TEST(Transitions, AWalkThatIsCancelledIsTracedNoFurther) {
    const auto walk = trueWalk(walked(kForward));
    JobControl control;
    ASSERT_TRUE(traceNextOf(*walk, tables(), control)) << "the scene";
    ASSERT_TRUE(traceNextOf(*walk, tables(), control));
    EXPECT_EQ(tracedShare(*walk), 0.1);
    control.cancel();
    EXPECT_FALSE(traceNextOf(*walk, tables(), control));
    EXPECT_EQ(tracedShare(*walk), 0.1);
}

}  // namespace
}  // namespace sward::test
