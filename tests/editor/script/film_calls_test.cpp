// camera.picture and camera.film hand a plan to the host.
#include "editor/script/script_stage.h"
#include "model/film_plan.h"

namespace sward {
namespace {

TEST(FilmCalls, HandOverWhatIsAskedFor) {
    test::ScriptStage stage;
    std::vector<FilmPlan> plans;
    std::string from;
    stage.host.film = [&](const FilmPlan& plan, const std::string& camera) {
        plans.push_back(plan), from = camera;
        return Status{};
    };
    ASSERT_EQ(stage.fault(R"(project.new()
        expect.equal(camera.picture("a.exr", {width = 64, height = 32, camera = "camera", time = 2}), 1)
        expect.equal(camera.film("out", {seconds = 1, fps = 10, from = 3}), 11))"),
              "");
    ASSERT_EQ(plans.size(), 2u);
    EXPECT_EQ(plans[0].out, stage.dir / "a.exr");
    EXPECT_EQ(plans[0].width, 64);
    EXPECT_EQ(plans[0].from, 2);
    EXPECT_FALSE(plans[0].film);
    EXPECT_TRUE(plans[1].film);
    EXPECT_EQ(plans[1].fps, 10);
    EXPECT_EQ(from, "") << "the host's choice";
}

TEST(FilmCalls, WithoutAHostThatDrawsTheySaySo) {
    test::ScriptStage stage;
    EXPECT_FAULT(stage, "project.new() camera.picture('a.png')", "draws none");
    EXPECT_FAULT(stage, "project.new() camera.film('a', {speed = 2})", "speed");
}

}  // namespace
}  // namespace sward
