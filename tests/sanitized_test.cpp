// The executable that is named for the sanitizers has them, and the other one has not.
#include <gtest/gtest.h>

#include <filesystem>

#include "support.h"

namespace sward::test {
namespace {

TEST(Sanitizers, AreInTheExecutableThatIsNamedForThem) {
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").filename().string();
    EXPECT_EQ(sanitized(), self == "sward_sanitized_tests") << self;
}

}  // namespace
}  // namespace sward::test
