#include "scene/accepted_picture.h"

#include "scene/components.h"
#include "scenes.h"

namespace sward::test {
namespace {

std::vector<ComponentFault> faults(const Project& p, const std::string& entity) {
    std::vector<ComponentFault> found;
    acceptedPictureRow().check(p.registry, findEntity(p, entity), entity + ".AcceptedPicture", found);
    return found;
}

TEST(AcceptedPicture, WithoutACameraItIsNoticed) {
    Project p;
    put<AcceptedPicture>(p, "stone");
    ASSERT_EQ(faults(p, "stone").size(), 1u);
    EXPECT_NE(faults(p, "stone")[0].message.find("no Camera"), std::string::npos);
    put<Camera>(p, "stone");
    EXPECT_TRUE(faults(p, "stone").empty());
}

TEST(AcceptedPicture, IsFoundByItsEntity) {
    Project p;
    EXPECT_EQ(acceptedPicture(p, "human"), nullptr);
    put<AcceptedPicture>(p, "human").width = 320;
    ASSERT_NE(acceptedPicture(p, "human"), nullptr);
    EXPECT_EQ(acceptedPicture(p, "human")->width, 320);
}

TEST(AcceptedPicture, MakesNothingRun) {
    const AcceptedPicture any;
    EXPECT_EQ(acceptedPictureRow().features(&any), FeatureSet{});
}

}  // namespace
}  // namespace sward::test
