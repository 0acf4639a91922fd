// A forest's volume as bytes: what it was made from names it; it comes back from the cache as it was; it can be
// cancelled; compressed it takes a quarter.
#include "forest/volume_images.h"

#include <gtest/gtest.h>

#include "core/log.h"
#include "support.h"

namespace sward::test {
namespace {

VolumeSpec spec(bool compressed = false) {
    Forest f;
    f.species = {{.leaves = 60}};
    f.variety = TileVariety::Eight;
    f.tileSize = 8;
    f.perHectare = 600;
    f.distance = 2;
    std::vector<Mesh> meshes{*treeMesh(".", f.species[0])};
    return {forestTiles(f), std::make_shared<const std::vector<Mesh>>(std::move(meshes)), 0.5, compressed};
}
VolumeImages baked(const VolumeSpec& s) {
    JobControl control;
    return std::move(*bakeVolume(s, control));
}

TEST(VolumeImages, HoldEveryLevelWithItsMips) {
    const VolumeImages v = baked(spec());
    ASSERT_EQ(v.levels.size(), static_cast<size_t>(std::log2(v.layers)) + 1);
    for (size_t l = 0; l < v.levels.size(); ++l) {
        int side = v.side;
        for (const auto& mip : v.levels[l]) {
            EXPECT_EQ(mip.size(), static_cast<size_t>(4 * side * side * (v.layers >> l)));
            side = std::max(side / 2, 1);
        }
    }
    EXPECT_EQ(v.trees.size(), 1u);
    EXPECT_EQ(v.sky[0].size(), v.air.extinction.size());
}

TEST(VolumeImages, OfThePapersSizeTakeLessThan24MillionBytesCompressed) {
    // 128 slabs of 256 x 256 with the pyramid and mips: counted, as every block takes 16 bytes.
    size_t bytes = 0;
    for (int layers = 128; layers > 0; layers /= 2)
        for (int side = 256; side > 0; side /= 2)
            bytes += 16 * static_cast<size_t>((side + 3) / 4 * ((side + 3) / 4) * layers);
    EXPECT_LE(bytes, size_t(24) << 20);
    const VolumeImages plain = baked(spec()), blocks = baked(spec(true));
    EXPECT_LT(static_cast<double>(blocks.bytes()), 0.26 * static_cast<double>(plain.bytes()));
}

TEST(VolumeImages, TheKeyFollowsWhatItIsMadeFrom) {
    const VolumeSpec a = spec();
    EXPECT_EQ(volumeKey(a), volumeKey(spec()));
    VolumeSpec b = spec();
    b.voxel = 0.4;
    EXPECT_NE(volumeKey(a), volumeKey(b));
    EXPECT_NE(volumeKey(a), volumeKey(spec(true)));
    b = spec();
    std::vector<Mesh> meshes = *b.meshes;
    meshes[0].parts[0].color.x += 0.01f;
    b.meshes = std::make_shared<const std::vector<Mesh>>(meshes);
    EXPECT_NE(volumeKey(a), volumeKey(b));
    b = spec();
    b.tiles.onEdge[0][0].push_back({{4, 0}, 0, 1, 0});
    EXPECT_NE(volumeKey(a), volumeKey(b));
}

TEST(VolumeImages, ACancelledBakeGivesNothing) {
    JobControl control;
    control.cancel();
    EXPECT_FALSE(bakeVolume(spec(), control));
}

TEST(VolumeImages, TellHowFarTheyAre) {
    JobControl control;
    ASSERT_TRUE(bakeVolume(spec(), control));
    EXPECT_GT(control.progress(), 0.95);
}

TEST(VolumeFile, BringsBackWhatWasBakedAndRefusesWhatIsDamaged) {
    const TempDir dir;
    JobControl control;
    const VolumeSpec s = spec(true);
    const VolumeImages made = std::move(*volumeOf(dir.path, s, control));
    const std::filesystem::path file = volumeFile(dir.path, volumeKey(s));
    const auto back = loadCachedVolume(dir.path, volumeKey(s));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->levels, made.levels);
    EXPECT_EQ(back->slots, made.slots);
    EXPECT_EQ(back->sky, made.sky);
    EXPECT_EQ(back->air.extinction, made.air.extinction);
    EXPECT_EQ(back->trees[0].extinction, made.trees[0].extinction);
    EXPECT_TRUE(back->compressed);
    const std::string bytes = readText(file);
    for (const size_t at : {size_t(9), size_t(17), bytes.size() / 2, bytes.size() - 1}) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        std::vector<std::string> warnings;
        const int sink = addLogSink([&](LogLevel level, const std::string& text) {
            if (level == LogLevel::Warning) warnings.push_back(text);
        });
        writeText(file, damaged);
        EXPECT_FALSE(loadCachedVolume(dir.path, volumeKey(s))) << at;
        removeLogSink(sink);
        ASSERT_EQ(warnings.size(), 1u) << at;
        EXPECT_NE(warnings[0].find(file.string()), std::string::npos);
        EXPECT_FALSE(std::filesystem::exists(file)) << "it is made anew";
    }
    writeText(file, bytes.substr(0, 20));
    EXPECT_FALSE(loadCachedVolume(dir.path, volumeKey(s)));
}

}  // namespace
}  // namespace sward::test
