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

// A ramp says where a texel lies: level by level none is shifted, though no level but two is half of the one before.
TEST(MapTextures, NoMipLevelIsShiftedHoweverManyTexelsAMapHas) {
    NoGlErrors errors;
    for (const int width : {2500, 1000, 333, 130, 129, 127}) {
        Map m({width, 3, 1, PixelType::F32});
        for (int x = 0; x < width; ++x)
            for (int y = 0; y < 3; ++y) m.set(x, y, 0, (static_cast<float>(x) + 0.5f) / static_cast<float>(width));
        MapTextures textures(gpu());
        textures.beginFrame();
        const GLuint t = textures.get("test", "m", m);
        for (int l = 0; width >> l > 1; ++l) {
            const int count = width >> l;
            const auto texels = level(t, l, width, 3);
            for (int i = 0; i < count; ++i)
                ASSERT_NEAR(texels[static_cast<size_t>(i)] * static_cast<float>(count), static_cast<float>(i) + 0.5f,
                            0.26f)
                    << width << " texels, level " << l;
        }
    }
}

TEST(MapTextures, ColoursCountByTheirOpacityAndAsLight) {
    NoGlErrors errors;
    for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::F32}) {
        Map m({256, 2, 4, type});
        for (int x = 0; x < 256; ++x)
            for (int y = 0; y < 2; ++y) {
                const bool painted = x % 2 == 0;
                for (int c = 0; c < 3; ++c) m.set(x, y, c, painted ? (y == 0 ? 0.2f : 0.8f) : 1.0f);
                m.set(x, y, 3, painted ? 0.8f : 0.0f);
            }
        MapTextures textures(gpu());
        textures.beginFrame();
        std::vector<glm::vec4> texels(128);
        glGetTextureImage(textures.get("test", "m", m, true), 1, GL_RGBA, GL_FLOAT,
                          static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
        const float stored = 0.5f * (f32::srgbDecode(m.at(0, 0, 0)) + f32::srgbDecode(m.at(0, 1, 0)));
        const float light = type == PixelType::U8 ? f32::srgbDecode(texels[5].x) : texels[5].x;
        EXPECT_NEAR(light, stored, 0.006f) << "the white of what is transparent shows";
        EXPECT_NEAR(texels[5].w, 0.4f, 0.003f);
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

TEST(MapTextures, WhatChangedInAMapOfOddSizeIsInEachOfItsLevels) {
    NoGlErrors errors;
    Map m = noisy({651, 389, 1, PixelType::U16});
    MapTextures textures(gpu()), fresh(gpu());
    textures.beginFrame();
    textures.get("test", "m", m);
    for (const glm::ivec2& at : {glm::ivec2(200, 200), glm::ivec2(650, 388), glm::ivec2(0, 0)})
        m.set(at.x, at.y, 0, 0.9f);
    textures.get("test", "m", m);
    m.set(127, 128, 0, 0.1f);  // at a tile's edge, whose neighbours' coarse texels it reaches
    const GLuint t = textures.get("test", "m", m);
    fresh.beginFrame();
    const GLuint whole = fresh.get("test", "m", m);
    for (int l = 0; l < 10; ++l) EXPECT_EQ(level(t, l, 651, 389), level(whole, l, 651, 389)) << "level " << l;
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
