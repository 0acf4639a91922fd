// Cached slices come back as they were; what is wrong with a file is told, and costs no more than making them anew.
#include "grass/slice_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/hash.h"
#include "core/log.h"
#include "support.h"

namespace sward::test {
namespace {

std::vector<SliceLevel> levels(int width, int height, size_t layers, uint32_t seed) {
    std::vector<SliceLevel> out;
    for (int w = width, h = height;; w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
        SliceLevel l{w, h, {}, {}, {}, {}};
        for (auto* channel : {&l.reflectance, &l.threshold, &l.front, &l.back})
            for (size_t i = 0; i < 4 * layers * static_cast<size_t>(w * h); ++i)
                channel->push_back(static_cast<uint8_t>((seed = seed * 1664525 + 1013904223) >> 24));
        out.push_back(std::move(l));
        if (w == 1 && h == 1) return out;
    }
}
SliceImages images() { return {3, 0.31f, 0.7f, levels(16, 8, 6, 1), levels(8, 8, 1, 2)}; }

bool equal(const std::vector<SliceLevel>& a, const std::vector<SliceLevel>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const SliceLevel& x, const SliceLevel& y) {
        return x.width == y.width && x.height == y.height && x.reflectance == y.reflectance &&
               x.threshold == y.threshold && x.front == y.front && x.back == y.back;
    });
}

constexpr uint64_t kKey = 0x123456789abcdef0;

// A cache with one file, and what was warned of.
class SliceFile : public testing::Test {
  protected:
    SliceFile() {
        sink = addLogSink([this](LogLevel level, const std::string& text) {
            if (level == LogLevel::Warning) warnings.push_back(text);
        });
        cacheSlices(dir.path, kKey, images());
        bytes = readText(sliceFile(dir.path, kKey));
    }
    ~SliceFile() override { removeLogSink(sink); }
    void expectRefused(const std::string& damaged, const std::string& what) {
        warnings.clear();
        writeText(sliceFile(dir.path, kKey), damaged);
        EXPECT_FALSE(loadCachedSlices(dir.path, kKey)) << what;
        ASSERT_EQ(warnings.size(), 1u) << what;
        EXPECT_NE(warnings[0].find(sliceFile(dir.path, kKey).string()), std::string::npos) << warnings[0];
        EXPECT_FALSE(std::filesystem::exists(sliceFile(dir.path, kKey))) << what;
    }
    TempDir dir;
    std::vector<std::string> warnings;
    int sink = 0;
    std::string bytes;
};

TEST_F(SliceFile, ComesBackAsItWas) {
    const auto back = loadCachedSlices(dir.path, kKey);
    ASSERT_TRUE(back);
    const SliceImages all = images();
    EXPECT_EQ(back->slices, all.slices);
    EXPECT_EQ(back->top, all.top);
    EXPECT_EQ(back->reflectScale, all.reflectScale);
    EXPECT_TRUE(equal(back->vertical, all.vertical));
    EXPECT_TRUE(equal(back->far, all.far));
    EXPECT_GT(bytes.size(), all.bytes());
    EXPECT_FALSE(loadCachedSlices(dir.path, kKey + 1)) << "there is none of this key";
    EXPECT_TRUE(warnings.empty()) << warnings[0];
}

TEST_F(SliceFile, TruncatedAnywhereItIsRefused) {
    for (size_t n = 0; n < bytes.size(); n += 1000) expectRefused(bytes.substr(0, n), std::to_string(n) + " bytes");
    expectRefused(bytes.substr(0, bytes.size() - 1), "the last byte is missing");
    expectRefused(bytes + "x", "a byte too many");
}

TEST_F(SliceFile, AFlippedByteAnywhereIsFound) {
    for (size_t at = 0; at < bytes.size(); at += at < 64 ? 1 : 997) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
        expectRefused(damaged, "byte " + std::to_string(at));
    }
}

TEST_F(SliceFile, AnotherVersionsFileIsMadeAnewAndNamed) {
    std::string other = bytes;
    other[8] = 77;
    expectRefused(other, "version");
    EXPECT_NE(warnings[0].find("version 77"), std::string::npos) << warnings[0];
    cacheSlices(dir.path, kKey, images());
    EXPECT_TRUE(loadCachedSlices(dir.path, kKey));
}

// Found by fuzzing, which it took gigabytes from: a head may claim more than its file holds, with a hash that is right.
TEST_F(SliceFile, AHeadThatClaimsMoreThanTheFileHoldsIsRefusedBeforeRoomIsMade) {
    std::string claims = bytes.substr(0, bytes.size() - 8);
    const int sizes[] = {256, 2048, 2048, 2048};  // slices, width, height, size from above
    std::memcpy(claims.data() + 12, sizes, sizeof sizes);
    const uint64_t sum = hashBytes(claims.data(), claims.size());
    claims.append(reinterpret_cast<const char*>(&sum), 8);
    expectRefused(claims, "claims");
    EXPECT_NE(warnings[0].find("size"), std::string::npos) << warnings[0];
}

TEST_F(SliceFile, AnotherKeysFileUnderThisNameIsRefused) {
    cacheSlices(dir.path, kKey + 1, images());
    expectRefused(readText(sliceFile(dir.path, kKey + 1)), "key");
}

TEST_F(SliceFile, ACacheThatCannotBeWrittenIsToldAndForgiven) {
    writeText(dir / "file", "not a folder");
    cacheSlices(dir / "file", kKey, images());
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_FALSE(loadCachedSlices(dir / "file", kKey));
}

}  // namespace
}  // namespace sward::test
