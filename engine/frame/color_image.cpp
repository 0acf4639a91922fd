#include "frame/color_image.h"

#include <bit>

#include "core/log.h"
#include "core/numerics.h"
#include "maps/map_io.h"

namespace sward {
namespace {

uint8_t encode(float linear) {
    return static_cast<uint8_t>(std::lround(255 * f32::srgbEncode(std::clamp(linear, 0.0f, 1.0f))));
}

// Value noise on a lattice of `period` points that wraps around, in [0,1].
float wrappedNoise(float x, float y, int period, uint32_t seed) {
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const float fx = f32::clumpFade(x - static_cast<float>(x0)), fy = f32::clumpFade(y - static_cast<float>(y0));
    const auto at = [&](int i, int j) {
        return f32::hashUnit(f32::hash3(static_cast<uint32_t>((i % period + period) % period),
                                        static_cast<uint32_t>((j % period + period) % period), seed));
    };
    return f32::bilinearMix(at(x0, y0), at(x0 + 1, y0), at(x0, y0 + 1), at(x0 + 1, y0 + 1), fx, fy);
}

// Half the blade's visible share of the strip's width at v: parallel below, pointed at the tip.
float halfWidth(float v) {
    const float taper = 1 - std::pow(v, 2.6f);
    return 0.48f * std::min(1.0f, 0.72f + 0.6f * v) * taper;
}

}  // namespace

Rgba8 makeSoil(int side) {
    Rgba8 out{side, side, std::vector<uint8_t>(static_cast<size_t>(side) * side * 4)};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            float sum = 0, weight = 0.5f;
            for (int period = 8, octave = 0; octave < 5; ++octave, period *= 2, weight *= 0.7f)
                sum += weight * (wrappedNoise(static_cast<float>(x) * period / side,
                                              static_cast<float>(y) * period / side, period, 17u + octave) -
                                 0.5f);
            const float light = std::clamp(0.5f * (1 + 1.1f * sum), 0.05f, 1.0f);  // 0.5: the shader doubles it
            const size_t at = (static_cast<size_t>(y) * side + x) * 4;
            const float warm = 0.04f * (wrappedNoise(16.0f * x / side, 16.0f * y / side, 16, 91u) - 0.5f);
            out.pixels[at] = encode(light * (1 + warm));
            out.pixels[at + 1] = encode(light);
            out.pixels[at + 2] = encode(light * (1 - warm));
            out.pixels[at + 3] = 255;
        }
    return out;
}

Rgba8 makeBladeImage(int width, int height) {
    Rgba8 out{width, height, std::vector<uint8_t>(static_cast<size_t>(width) * height * 4)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float u = (x + 0.5f) / width - 0.5f, v = (y + 0.5f) / height;
            const float edge = (halfWidth(v) - std::abs(u)) * width;
            const float rib = std::exp(-u * u * 900), vein = 0.5f + 0.5f * std::cos(u * 75);
            const float light = 0.42f + 0.10f * vein - 0.10f * rib + 0.06f * (wrappedNoise(3, v * 24, 24, 5u) - 0.5f);
            const size_t at = (static_cast<size_t>(y) * width + x) * 4;
            for (size_t c = 0; c < 3; ++c) out.pixels[at + c] = encode(light);
            out.pixels[at + 3] = static_cast<uint8_t>(std::lround(255 * std::clamp(edge + 0.5f, 0.0f, 1.0f)));
        }
    dilateColor(out);
    return out;
}

Rgba8 loadColorImage(const std::filesystem::path& file) {
    auto image = readImage(file);
    if (!image) {
        logWarning(image.error().text() + "; a texture made by the program stands in");
        return {};
    }
    Rgba8 out{image->width, image->height,
              std::vector<uint8_t>(static_cast<size_t>(image->width) * image->height * 4, 255)};
    for (size_t i = 0; i < static_cast<size_t>(image->width) * image->height; ++i)
        for (int c = 0; c < 4; ++c) {
            const int from = image->channels >= 3 ? c : (c < 3 ? 0 : 1);
            if (from >= image->channels) continue;
            const float v = image->pixels[i * static_cast<size_t>(image->channels) + static_cast<size_t>(from)];
            out.pixels[i * 4 + static_cast<size_t>(c)] =
                image->linear && c < 3 ? encode(v) : static_cast<uint8_t>(std::lround(255 * std::clamp(v, 0.0f, 1.0f)));
        }
    dilateColor(out);
    return out;
}

void dilateColor(Rgba8& image) {
    const int w = image.width, h = image.height;
    std::vector<uint8_t> known(static_cast<size_t>(w) * h);
    for (size_t i = 0; i < known.size(); ++i) known[i] = image.pixels[i * 4 + 3] > 0;
    if (std::none_of(known.begin(), known.end(), [](uint8_t k) { return k; })) return;
    for (bool grew = true; grew;) {
        grew = false;
        const std::vector<uint8_t> before = known;
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const size_t at = static_cast<size_t>(y) * w + x;
                if (before[at]) continue;
                int n = 0, sum[3] = {0, 0, 0};
                for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                    if (x + dx < 0 || x + dx >= w || y + dy < 0 || y + dy >= h) continue;
                    const size_t other = at + static_cast<size_t>(static_cast<std::ptrdiff_t>(dy) * w + dx);
                    if (!before[other]) continue;
                    ++n;
                    for (size_t c = 0; c < 3; ++c) sum[c] += image.pixels[other * 4 + c];
                }
                if (n == 0) continue;
                for (size_t c = 0; c < 3; ++c) image.pixels[at * 4 + c] = static_cast<uint8_t>(sum[c] / n);
                known[at] = 1;
                grew = true;
            }
    }
}

namespace {
Texture uploadColors(Gpu& gpu, const std::string& owner, const Rgba8& image, int levels, bool repeat) {
    Texture t = makeTexture2D(gpu, owner, GL_SRGB8_ALPHA8, image.width, image.height, levels, repeat);
    glTextureSubImage2D(t.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    glGenerateTextureMipmap(t.id());
    return t;
}
}  // namespace

Texture makeColorTexture(Gpu& gpu, const std::string& owner, const Rgba8& image, bool repeat) {
    return uploadColors(gpu, owner, image, 0, repeat);
}

Rgba8 withRows(const Rgba8& image, int rows) {
    if (image.height >= rows) return image;
    const size_t row = static_cast<size_t>(image.width) * 4;
    Rgba8 out{image.width, rows, std::vector<uint8_t>(row * static_cast<size_t>(rows))};
    for (int y = 0; y < rows; ++y) {
        const float at = std::clamp((static_cast<float>(y) + 0.5f) * static_cast<float>(image.height) / rows - 0.5f,
                                    0.0f, static_cast<float>(image.height - 1));
        const int below = static_cast<int>(at), above = std::min(below + 1, image.height - 1);
        const uint8_t *a = image.pixels.data() + row * static_cast<size_t>(below),
                      *b = image.pixels.data() + row * static_cast<size_t>(above);
        for (size_t i = 0; i < row; ++i)
            out.pixels[row * static_cast<size_t>(y) + i] =
                static_cast<uint8_t>(std::lround(std::lerp(float(a[i]), float(b[i]), at - static_cast<float>(below))));
    }
    return out;
}

Texture makeBladeTexture(Gpu& gpu, const std::string& owner, const Rgba8& image) {
    const int widest = std::bit_width(static_cast<unsigned>(image.width)) - 1;  // level at which it is a texel wide
    return uploadColors(gpu, owner, withRows(image, kBladeRows << widest), widest + 1, false);
}

}  // namespace sward
