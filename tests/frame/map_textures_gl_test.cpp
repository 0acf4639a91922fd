#include "frame/map_textures.h"

#include "core/numerics.h"
#include "scenes.h"

namespace sward::test {
namespace {

Map noisy(const MapInfo& info) {
    Map m(info);
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x)
            for (int c = 0; c < info.channels; ++c)
                m.set(x, y, c,
                      f32::hashUnit(
                          f32::hash3(static_cast<uint32_t>(x), static_cast<uint32_t>(y), static_cast<uint32_t>(c))));
    return m;
}

std::vector<float> level(GLuint texture, int l, int width, int height) {
    std::vector<float> out(static_cast<size_t>(std::max(width >> l, 1)) *
                           static_cast<size_t>(std::max(height >> l, 1)));
    glGetTextureImage(texture, l, GL_RED, GL_FLOAT, static_cast<GLsizei>(out.size() * sizeof(float)), out.data());
    return out;
}

TEST(MapTextures, HoldTheMapsTexels) {
    NoGlErrors errors;
    for (const MapInfo info : {MapInfo{300, 170, 1, PixelType::U16}, MapInfo{5, 3, 1, PixelType::F32},
                               MapInfo{128, 256, 1, PixelType::U8}}) {
        MapTextures textures(gpu());
        const Map m = noisy(info);
        textures.beginFrame();
        const auto texels = level(textures.get("test", "m", m), 0, info.width, info.height);
        for (int y = 0; y < info.height; ++y)
            for (int x = 0; x < info.width; ++x)
                ASSERT_NEAR(texels[static_cast<size_t>(y * info.width + x)], m.at(x, y), 1e-6f) << x << " " << y;
    }
}

// The format says it of 8 bits, and its texels come back as they were stored.
TEST(MapTextures, ColoursOfMoreThanEightBitsAreUploadedAsLinearLight) {
    NoGlErrors errors;
    for (const PixelType type : {PixelType::U16, PixelType::F32}) {
        MapTextures textures(gpu());
        const Map m = noisy({140, 130, 4, type});
        textures.beginFrame();
        std::vector<glm::vec4> texels(140 * 130);
        glGetTextureImage(textures.get("test", "m", m, true), 0, GL_RGBA, GL_FLOAT,
                          static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
        for (int y = 0; y < 130; ++y)
            for (int x = 0; x < 140; ++x)
                for (int c = 0; c < 4; ++c)
                    ASSERT_NEAR(texels[static_cast<size_t>(y * 140 + x)][c],
                                c < 3 ? f32::srgbDecode(m.at(x, y, c)) : m.at(x, y, c), 1e-5f);
    }
}

TEST(MapTextures, EveryMipLevelKeepsTheMean) {
    MapTextures textures(gpu());
    const Map m = noisy({512, 256, 1, PixelType::U16});
    textures.beginFrame();
    const GLuint t = textures.get("test", "m", m);
    for (int l = 0; l <= 9; ++l) {
        const auto texels = level(t, l, 512, 256);
        double sum = 0;
        for (float v : texels) sum += v;
        EXPECT_NEAR(sum / static_cast<double>(texels.size()), m.mean(), 1e-3) << "level " << l;
    }
}

TEST(MapTextures, OnlyTilesThatChangedAreUploadedAndTheResultIsTheWholeMaps) {
    NoGlErrors errors;
    Map m = noisy({640, 384, 1, PixelType::U16});
    MapTextures textures(gpu()), fresh(gpu());
    textures.beginFrame();
    textures.get("test", "m", m);
    const uint64_t all = textures.uploadedBytes();
    textures.endFrame();
    textures.beginFrame();
    textures.get("test", "m", m);
    EXPECT_EQ(textures.uploadedBytes(), 0u);
    m.set(200, 200, 0, 0.25f);
    const GLuint t = textures.get("test", "m", m);
    EXPECT_LE(textures.uploadedBytes(), all / 15 + 64);
    EXPECT_GT(textures.uploadedBytes(), 0u);
    fresh.beginFrame();
    const GLuint whole = fresh.get("test", "m", m);
    for (int l = 0; l < 10; ++l) EXPECT_EQ(level(t, l, 640, 384), level(whole, l, 640, 384)) << "level " << l;
}

TEST(MapTextures, WhatNoPassAsksForIsFreed) {
    const int64_t before = gpu().totalBytes();
    MapTextures textures(gpu());
    textures.beginFrame();
    textures.get("test", "m", noisy({64, 64, 1, PixelType::U8}));
    textures.endFrame();
    EXPECT_GT(gpu().totalBytes(), before);
    textures.beginFrame();
    textures.endFrame();
    EXPECT_EQ(gpu().totalBytes(), before);
}

}  // namespace
}  // namespace sward::test
