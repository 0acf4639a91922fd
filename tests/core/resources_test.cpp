// Where the program finds what comes with it: installed, in a checkout, and when both are gone.
#include "core/resources.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support.h"

namespace sward {
namespace {

namespace fs = std::filesystem;
using test::TempDir;

void touch(const fs::path& file) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "x";
}

TEST(Resources, LieInShareBesideAnInstalledProgram) {
    const TempDir dir;
    touch(dir / "usr/bin/sward");
    touch(dir / "usr/share/sward/shaders/lib/light.glsl");
    EXPECT_EQ(resourceOf(dir / "usr/bin/sward", "/nowhere", "shaders"), fs::canonical(dir / "usr/share/sward/shaders"));
}

TEST(Resources, LieInTheCheckoutThatAProgramWasBuiltIn) {
    const TempDir dir;
    touch(dir / "tree/build/release/sward");
    touch(dir / "tree/projects/lawn/project.json");
    EXPECT_EQ(resourceOf(dir / "tree/build/release/sward", "/nowhere", "projects"),
              fs::canonical(dir / "tree/projects"));
}

TEST(Resources, AreSaidToLieInTheSourceTreeWhenTheyAreNowhere) {
    const TempDir dir;
    touch(dir / "alone/sward");
    EXPECT_EQ(resourceOf(dir / "alone/sward", "/source", "shaders"), fs::path("/source/shaders"));
    EXPECT_EQ(resourceOf({}, "/source", "shaders"), fs::path("/source/shaders"));
    EXPECT_TRUE(fs::is_directory(resource("shaders/numerics"))) << "of this very program";
}

}  // namespace
}  // namespace sward
