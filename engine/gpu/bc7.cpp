#include "gpu/bc7.h"

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

constexpr int kWeights[16] = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};
constexpr int kEndBits = 7, kMode = 6;

using Color = std::array<float, 4>;
// Seven bits a channel, and the eighth, which all four share.
struct End {
    std::array<int, 4> high{};
    int low = 0;
    int at(size_t c) const { return high[c] << 1 | low; }
};

End rounded(const Color& color) {
    End best;
    float least = 1e30f;
    for (int low = 0; low < 2; ++low) {
        End e;
        e.low = low;
        float error = 0;
        for (size_t c = 0; c < 4; ++c) {
            e.high[c] = std::clamp(static_cast<int>(std::lround((color[c] - static_cast<float>(low)) / 2)), 0, 127);
            const float off = static_cast<float>(e.at(c)) - color[c];
            error += off * off;
        }
        if (error < least) least = error, best = e;
    }
    return best;
}

int between(const End& a, const End& b, size_t c, int weight) {
    return (a.at(c) * (64 - weight) + b.at(c) * weight + 32) >> 6;
}

// The direction along which texels differ most, by a few steps of power iteration.
Color axisOf(const Bc7Texels& texels, const Color& mean) {
    std::array<Color, 4> spread{};
    for (const auto& t : texels)
        for (size_t i = 0; i < 4; ++i)
            for (size_t k = 0; k < 4; ++k)
                spread[i][k] += (static_cast<float>(t[i]) - mean[i]) * (static_cast<float>(t[k]) - mean[k]);
    Color axis{1, 1, 1, 1};
    for (int step = 0; step < 6; ++step) {
        Color next{};
        float length = 0;
        for (size_t i = 0; i < 4; ++i) {
            for (size_t k = 0; k < 4; ++k) next[i] += spread[i][k] * axis[k];
            length += next[i] * next[i];
        }
        if (!(length > 0)) return axis;
        for (size_t i = 0; i < 4; ++i) axis[i] = next[i] / std::sqrt(length);
    }
    return axis;
}

struct Bits {
    Bc7Block& block;
    int at = 0;
    void put(int value, int count) {
        for (int i = 0; i < count; ++i, ++at)
            if (value >> i & 1) block[static_cast<size_t>(at / 8)] |= static_cast<uint8_t>(1 << at % 8);
    }
};
struct BitsRead {
    const Bc7Block& block;
    int at = 0;
    int take(int count) {
        int value = 0;
        for (int i = 0; i < count; ++i, ++at) value |= (block[static_cast<size_t>(at / 8)] >> at % 8 & 1) << i;
        return value;
    }
};

Bc7Block packed(const End& a, const End& b, const std::array<int, 16>& steps) {
    Bc7Block block{};
    Bits out{block};
    out.put(1 << kMode, kMode + 1);
    for (size_t c = 0; c < 4; ++c) out.put(a.high[c], kEndBits), out.put(b.high[c], kEndBits);
    out.put(a.low, 1), out.put(b.low, 1);
    for (size_t i = 0; i < 16; ++i) out.put(steps[i], i == 0 ? 3 : 4);
    return block;
}

}  // namespace

Bc7Block bc7Encoded(const Bc7Texels& texels) {
    Color mean{};
    for (const auto& t : texels)
        for (size_t c = 0; c < 4; ++c) mean[c] += static_cast<float>(t[c]) / 16;
    const Color axis = axisOf(texels, mean);
    float low = 1e30f, high = -1e30f;
    for (const auto& t : texels) {
        float along = 0;
        for (size_t c = 0; c < 4; ++c) along += (static_cast<float>(t[c]) - mean[c]) * axis[c];
        low = std::min(low, along), high = std::max(high, along);
    }
    Color from{}, to{};
    for (size_t c = 0; c < 4; ++c)
        from[c] = std::clamp(mean[c] + axis[c] * low, 0.0f, 255.0f),
        to[c] = std::clamp(mean[c] + axis[c] * high, 0.0f, 255.0f);
    End a = rounded(from), b = rounded(to);
    std::array<int, 16> steps{};
    for (size_t i = 0; i < 16; ++i) {
        int least = 1 << 30;
        for (int s = 0; s < 16; ++s) {
            int error = 0;
            for (size_t c = 0; c < 4; ++c) {
                const int off = between(a, b, c, kWeights[s]) - texels[i][c];
                error += off * off;
            }
            if (error < least) least = error, steps[i] = s;
        }
    }
    if (steps[0] >= 8) {  // the first step's highest bit is not stored
        std::swap(a, b);
        for (int& s : steps) s = 15 - s;
    }
    return packed(a, b, steps);
}

Bc7Texels bc7Decoded(const Bc7Block& block) {
    Bc7Texels out{};
    BitsRead in{block};
    if (in.take(kMode + 1) != 1 << kMode) return out;
    End a, b;
    for (size_t c = 0; c < 4; ++c) a.high[c] = in.take(kEndBits), b.high[c] = in.take(kEndBits);
    a.low = in.take(1), b.low = in.take(1);
    for (size_t i = 0; i < 16; ++i) {
        const int step = in.take(i == 0 ? 3 : 4);
        for (size_t c = 0; c < 4; ++c) out[i][c] = static_cast<uint8_t>(between(a, b, c, kWeights[step]));
    }
    return out;
}

std::vector<uint8_t> bc7Image(const uint8_t* rgba, int width, int height) {
    std::vector<uint8_t> out;
    for (int y = 0; y < height; y += 4)
        for (int x = 0; x < width; x += 4) {
            Bc7Texels texels;
            for (int i = 0; i < 16; ++i) {
                const int at = 4 * (std::min(y + i / 4, height - 1) * width + std::min(x + i % 4, width - 1));
                std::copy(rgba + at, rgba + at + 4, texels[static_cast<size_t>(i)].begin());
            }
            const Bc7Block block = bc7Encoded(texels);
            out.insert(out.end(), block.begin(), block.end());
        }
    return out;
}

}  // namespace sward
