// Content hashes against published values.
#include "core/hash.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sward {
namespace {

TEST(Hashes, AreThoseOfXxh3HoweverTheBytesAreCut) {
    EXPECT_EQ(hashHex(hashText("")), "2d06800538d394c2");  // XXH3_64bits of nothing, as its authors publish it
    const std::string text(100000, 'g');
    Hasher hasher;
    for (size_t i = 0; i < text.size(); i += 777) hasher.add(text.data() + i, std::min<size_t>(777, text.size() - i));
    EXPECT_EQ(hasher.value(), hashText(text));
}

}  // namespace
}  // namespace sward
