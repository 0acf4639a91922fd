// Memory that the driver does not have is told as that of the program is.
#include "gpu/resources.h"

#include <gtest/gtest.h>

#include <new>

#include "child.h"
#include "core/memory_budget.h"
#include "gpu/gpu.h"
#include "scenes.h"

namespace sward::test {
namespace {

const ChildFunctionRow kTexture("texture", [](const std::vector<std::string>& args) -> std::string {
    auto gpu = makeHeadlessGpu();
    if (!gpu) return gpu.error().text();
    boundMemory(uint64_t(1) << 30);
    try {
        const int side = std::stoi(args.at(0));
        makeTexture2D(**gpu, "test", GL_RGBA32F, side, side);
        return "made";
    } catch (const std::bad_alloc&) {
        return "refused";
    }
});

TEST(Resources, ATextureBeyondTheBudgetIsRefusedAsMemoryIs) {
    if (!gpu().software) GTEST_SKIP() << "textures lie in memory that no budget of the program's bounds";
    EXPECT_EQ(runChild("texture", {"256"}), "made");
    EXPECT_EQ(runChild("texture", {"16384"}), "refused");
}

TEST(Resources, AnotherErrorIsNoLackOfMemory) {
    gpu();
    glGetError();
    glBindTextureUnit(1, 12345678);  // there is no such texture
    EXPECT_NO_THROW(throwWithoutMemory());
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace
}  // namespace sward::test
