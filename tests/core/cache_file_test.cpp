// Files of the cache: read where they are sound, said and removed where they are not, and no loss where none can be
// written.
#include "core/cache_file.h"

#include <gtest/gtest.h>

#include <charconv>

#include "support.h"

namespace sward::test {
namespace {

std::optional<int> parsed(const std::string& bytes, std::string& wrong) {
    int n = 0;
    if (std::from_chars(bytes.data(), bytes.data() + bytes.size(), n).ec == std::errc()) return n;
    return wrong = "it is no number", std::nullopt;
}

TEST(CacheFile, HoldsWhatWasWritten) {
    const TempDir dir;
    const auto file = dir.path / "numbers" / "seven";
    EXPECT_FALSE(loadCached(file, 100, "number", parsed));
    writeCached(file, "number", "7");
    EXPECT_EQ(loadCached(file, 100, "number", parsed), 7);
}

TEST(CacheFile, OneThatIsDamagedOrTooLongIsRemoved) {
    const TempDir dir;
    const auto file = dir.path / "number";
    writeCached(file, "number", "none");
    EXPECT_FALSE(loadCached(file, 100, "number", parsed));
    EXPECT_FALSE(std::filesystem::exists(file));
    writeCached(file, "number", "1234567");
    EXPECT_FALSE(loadCached(file, 3, "number", parsed));
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(CacheFile, OneThatCannotBeWrittenIsNoLoss) {
    const TempDir dir;
    writeCached(dir.path / "taken", "number", "7");
    writeCached(dir.path / "taken" / "below", "number", "8");
    EXPECT_EQ(loadCached(dir.path / "taken", 100, "number", parsed), 7);
    EXPECT_FALSE(loadCached(dir.path / "taken" / "below", 100, "number", parsed));
}

}  // namespace
}  // namespace sward::test
