// Parts of a reference image as files: what they hold comes back, what is damaged is named. Traces nothing.
#include "reference/reference_part.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/file.h"
#include "support.h"

namespace sward::test {
namespace {

// Numbers that tell where they belong.
Truth numbered(const ReferenceSettings& s) {
    const size_t pixels = static_cast<size_t>(s.width) * static_cast<size_t>(s.height);
    Truth t{s.width, s.height, std::vector<float>(3 * pixels), std::vector<float>(3 * pixels),
            std::vector<float>(pixels)};
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) {
            if (!isOfShard(y, s)) continue;
            const size_t i = static_cast<size_t>(y * s.width + x);
            for (size_t c = 0; c < 3; ++c)
                t.color[3 * i + c] = static_cast<float>(10 * i + c), t.error[3 * i + c] = 0.5f + static_cast<float>(i);
            t.grass[i] = static_cast<float>(i) / static_cast<float>(pixels);
        }
    return t;
}

struct ReferenceParts : testing::Test {
    TempDir dir;
    static ReferenceSettings settings(int shard, int shards) {
        ReferenceSettings s;
        s.width = 21, s.height = 37, s.samples = 3, s.shard = shard, s.shards = shards;
        return s;
    }
    std::filesystem::path part(int shard, int shards, const std::string& name, uint64_t of = 7,
                               int bandRows = kShardRows) {
        ReferenceSettings s = settings(shard, shards);
        s.bandRows = bandRows;
        EXPECT_TRUE(writeFileAtomic(dir / name, encodePart({"eye", of, s, numbered(s)})));
        return dir / name;
    }
    static std::string says(const std::vector<std::filesystem::path>& files) {
        const auto merged = mergeParts(files);
        return merged ? std::string("merged") : merged.error().text();
    }
};

TEST_F(ReferenceParts, MergeInAnyOrderBitForBit) {
    const Truth whole = numbered(settings(0, 1));
    const auto merged = mergeParts({part(2, 3, "c"), part(0, 3, "a"), part(1, 3, "b")});
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_EQ(whole.color, merged->color);
    EXPECT_EQ(whole.error, merged->error);
    EXPECT_EQ(whole.grass, merged->grass);
    EXPECT_EQ(says({part(0, 1, "whole")}), "merged");
    EXPECT_EQ(says({part(0, 9, "0"), part(1, 9, "1"), part(2, 9, "2"), part(3, 9, "3"), part(4, 9, "4"),
                    part(5, 9, "5"), part(6, 9, "6"), part(7, 9, "7"), part(8, 9, "8")}),
              "merged")
        << "shards without a row";
}

TEST_F(ReferenceParts, WithLowBandsMergeAndNeverWithOthers) {
    const Truth whole = numbered(settings(0, 1));
    const auto merged = mergeParts({part(0, 2, "a", 7, 1), part(1, 2, "b", 7, 1)});
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_EQ(whole.color, merged->color);
    EXPECT_NE(says({dir / "a", part(1, 2, "c", 7, 8)}).find("another image"), std::string::npos);
}

// As many machines as there are: none has over a quarter more rows than the mean, where there are rows enough.
TEST_F(ReferenceParts, BandsLeaveNoShardWithMuchMore) {
    EXPECT_EQ(bandRowsFor(1080, 1), kShardRows);
    EXPECT_EQ(bandRowsFor(4, 1 << 20), 1);
    for (const int height : {1080, 2160, 4320})
        for (const int shards : {2, 7, 20, 100, 200}) {
            std::vector<int> rows(static_cast<size_t>(shards));
            for (int i = 0; i < shards; ++i) {
                ReferenceSettings s = settings(i, shards);
                s.bandRows = bandRowsFor(height, shards);
                for (int y = 0; y < height; ++y) rows[static_cast<size_t>(i)] += isOfShard(y, s);
            }
            EXPECT_LE(*std::max_element(rows.begin(), rows.end()), std::ceil(1.25 * height / shards))
                << height << " rows, " << shards << " shards";
        }
}

TEST_F(ReferenceParts, WhatIsMissingTwiceOrForeignIsNamed) {
    const auto a = part(0, 2, "a"), b = part(1, 2, "b"), other = part(1, 2, "other", 8), third = part(1, 3, "third");
    EXPECT_NE(says({a}).find("shard 1 of 2 is missing"), std::string::npos) << says({a});
    EXPECT_NE(says({a, b, b}).find("twice"), std::string::npos);
    EXPECT_NE(says({a, other}).find("another image"), std::string::npos);
    EXPECT_NE(says({a, third}).find("another image"), std::string::npos);
    EXPECT_NE(says({a, dir / "absent"}).find("absent"), std::string::npos);
    EXPECT_NE(says({}).find("no parts"), std::string::npos);
}

TEST_F(ReferenceParts, WhatIsDamagedIsRefused) {
    const auto a = part(0, 2, "a"), b = part(1, 2, "b");
    const std::string bytes = readText(b);
    const size_t line = bytes.find('\n');
    std::vector<std::string> damaged{bytes + "more", "text", "{}\n", std::string(5000, 'x')};
    for (const size_t keep : {size_t(0), size_t(10), line, line + 1, line + 9, bytes.size() - 1})
        damaged.push_back(bytes.substr(0, keep));
    for (const auto& [from, to] : {std::pair{"\"width\": 21", "\"width\": 2147483648"},
                                   {"\"width\": 21", "\"width\": -1"},
                                   {"\"height\": 37", "\"height\": 1e9"},
                                   {"\"shards\": 2", "\"shards\": 0"},
                                   {"\"shard\": 1", "\"shard\": 2"},
                                   {"\"band\": 8", "\"band\": 9"},
                                   {"\"band\": 8", "\"bond\": 8"},
                                   {"\"samples\": 3", "\"samples\": \"3\""},
                                   {"\"of\"", "\"if\""},
                                   {"\"width\": 21", "\"width\": 20.5"}}) {
        std::string changed = bytes;
        const size_t at = changed.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        damaged.push_back(changed.replace(at, std::strlen(from), to));
    }
    for (const std::string& text : damaged) {
        writeText(dir / "cut", text);
        const auto merged = mergeParts({a, dir / "cut"});
        ASSERT_FALSE(merged) << text.substr(0, 200);
        EXPECT_EQ(merged.error().code, ExitCode::Unsound) << merged.error().text();
        EXPECT_NE(merged.error().text().find("cut"), std::string::npos);
    }
}

TEST_F(ReferenceParts, OneBitThatFlippedAnywhereIsRefusedAndTheFileNamed) {
    const auto a = part(0, 2, "a"), b = part(1, 2, "b");
    const std::string bytes = readText(b);
    constexpr size_t kPlaces = 120;
    for (size_t i = 0; i < kPlaces; ++i) {
        std::string flipped = bytes;
        // A third of the places lie in the first line.
        const size_t line = bytes.find('\n') + 1,
                     at = i % 3 == 0 ? i * line / kPlaces : line + i * (bytes.size() - line) / kPlaces;
        flipped[at] = static_cast<char>(flipped[at] ^ (1 << (i % 8)));
        writeText(dir / "flipped", flipped);
        const auto merged = mergeParts({a, dir / "flipped"});
        ASSERT_FALSE(merged) << "bit " << i % 8 << " of byte " << at;
        EXPECT_EQ(merged.error().code, ExitCode::Unsound) << merged.error().text();
        EXPECT_NE(merged.error().text().find("flipped"), std::string::npos) << merged.error().text();
    }
}

}  // namespace
}  // namespace sward::test
