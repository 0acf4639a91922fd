#include "core/enum_names.h"

#include <gtest/gtest.h>

#include <span>

namespace sward {
namespace {
enum class Size { Small, Middle, Large };
enum class Lone { Only };
enum class Level16 { Of8, Of16 };
constexpr auto kSizes = enumNames<Size>("small", "middle", "large");
}  // namespace

TEST(EnumNames, ValuesAreCountedToTheFirstNumberWithoutOne) {
    EXPECT_EQ(enumCount<Size>(), 3u);
    EXPECT_EQ(enumCount<Lone>(), 1u);
    EXPECT_EQ(enumCount<Level16>(), 2u) << "digits at the end of a name make no number of it";
}

TEST(EnumNames, AreFoundByValueByNumberAndInOrder) {
    EXPECT_STREQ(kSizes[Size::Large], "large");
    EXPECT_STREQ(kSizes[1], "middle");
    const std::span<const char* const> all = kSizes;
    ASSERT_EQ(all.size(), 3u);
    EXPECT_STREQ(all.front(), "small");
}

}  // namespace sward
