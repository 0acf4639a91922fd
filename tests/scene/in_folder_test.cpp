// Folders of the outliner ask for nothing of a frame and survive a snapshot.
#include "scene/in_folder.h"

#include <gtest/gtest.h>

#include "techniques.h"

namespace sward {
namespace {

TEST(InFolderComponent, NamesAFolderAndDrawsNothing) {
    Project p;
    p.registry.add<InFolder>(*addEntity(p, "bench"), InFolder{"seats"});
    ASSERT_TRUE(addEntity(p, "tree"));
    EXPECT_EQ(folderOf(p, "bench"), "seats");
    EXPECT_EQ(folderOf(p, "tree"), "");
    EXPECT_EQ(folderOf(p, "nobody"), "");
    EXPECT_EQ(sceneFeatures(p.registry, tables()), FeatureSet{});
    EXPECT_EQ(folderOf(snapshot(p, tables().components), "bench"), "seats");
}

}  // namespace
}  // namespace sward
