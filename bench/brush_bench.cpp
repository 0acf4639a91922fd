// What a stamp costs, undo included. A stroke's undo is the copy of the map it began with: tiles that stamps replace
// live on in it, so each stamp pays for fresh tiles, as here.
#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <optional>

#include "bench/limits.h"
#include "brushes/brush.h"
#include "brushes/shape.h"
#include "frame/map_textures.h"
#include "terrain/shade.h"
#include "tools/stroke.h"
#include "world/ground.h"

namespace {
using namespace sward;

constexpr int kSide = 4096;

Map paintedMap(PixelType type) {
    Map map({kSide, kSide, 1, type});
    std::vector<std::byte> row(size_t(kSide) * map.texelBytes());
    uint32_t h = 1;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            h = h * 1664525u + 1013904223u;
            const float value = 0.25f + 0.5f * static_cast<float>(h >> 8) * 0x1p-24f;
            if (type == PixelType::F32) std::memcpy(&row[size_t(x) * 4], &value, 4);
            if (type == PixelType::U8) row[size_t(x)] = static_cast<std::byte>(value * 255);
            const auto wide = static_cast<uint16_t>(value * 65535);
            if (type == PixelType::U16) std::memcpy(&row[size_t(x) * 2], &wide, 2);
        }
        map.writeRows(y, 1, row.data());
    }
    return map;
}

// One stamp of `radius` texels at the map's middle, with the map as it was before kept for undo.
void stamp(benchmark::State& state, const char* mode, PixelType type) {
    const Map original = paintedMap(type);
    const BrushRow& row = *findBrush(mode);
    const double radius = static_cast<double>(state.range(0));
    BrushSettings brush;
    brush.strength = 0.5f;
    uint32_t turn = 0;
    for (auto _ : state) {
        Map map = original;
        const Map undo = map;
        applyStamp(map, row, {kSide / 2.0, kSide / 2.0, radius, radius, turn++}, brush);
        benchmark::DoNotOptimize(map.tile(16, 16).get());
        if (map.sameTiles(undo)) state.SkipWithError("the stamp changed nothing");
    }
}

BENCHMARK_CAPTURE(stamp, add_u16, "add", PixelType::U16)
    ->Arg(100)
    ->Arg(500)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(stamp, set_u16, "set", PixelType::U16)->Arg(500)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(stamp, noise_u16, "noise", PixelType::U16)->Arg(500)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(stamp, smooth_u16, "smooth", PixelType::U16)->Arg(500)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(stamp, add_u8, "add", PixelType::U8)->Arg(500)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(stamp, add_f32, "add", PixelType::F32)->Arg(500)->Unit(benchmark::kMillisecond)->UseRealTime();

// What a frame can bear: a stamp of 500 texels' radius, with its undo; sending it to the GPU comes on top. The least of
// many, since other work on the machine only adds.
SWARD_LIMITS("stamp", [] {
    for (const char* mode : {"add", "subtract", "set", "smooth", "noise"}) {
        const Map original = paintedMap(PixelType::U16);
        std::vector<double> ms;
        for (uint32_t turn = 0; turn < 40; ++turn) {
            Map map = original;
            ms.push_back(1e3 * seconds([&] {
                             applyStamp(map, *findBrush(mode), {kSide / 2.0, kSide / 2.0, 500, 500, turn}, {});
                         }));
        }
        reportLimit((std::string("stamp of 500 texels on 4096^2, 16 bit, ") + mode).c_str(),
                    *std::min_element(ms.begin(), ms.end()), 5, "ms");
    }
});

// The same with a turned picture of 2048^2 for a shape, whose corners reach beyond the ring: heights as they are
// sculpted.
SWARD_LIMITS("stamp", [] {
    std::vector<float> light(2048 * 2048);
    for (size_t i = 0; i < light.size(); ++i) light[i] = static_cast<float>(i * 2654435761u % 1000) / 1000;
    BrushSettings brush;
    brush.shape = makeShape("bench", 2048, 2048, std::move(light));
    brush.strength = 0.5f, brush.blend = HeightBlend::Replace;
    for (const PixelType type : {PixelType::U16, PixelType::F32})
        for (const char* mode : {"raise", "smooth", "imprint"}) {
            const Map original = paintedMap(type);
            paintHeights(brush, type == PixelType::U16 ? std::pair(0.0, 100.0) : std::pair(0.0, 1.0));
            std::vector<double> ms;
            for (uint32_t turn = 0; turn < 25; ++turn) {
                Map map = original;
                Stamp stamp{kSide / 2.0, kSide / 2.0, 500, 500, turn};
                stamp.angle = 0.7, stamp.reach = std::cos(0.7) + std::sin(0.7);
                ms.push_back(1e3 * seconds([&] { applyStamp(map, *findBrush(mode), stamp, brush); }));
            }
            reportLimit(fmt::format("stamp of 500 texels on 4096^2 {} heights with a turned shape, {}",
                                    type == PixelType::U16 ? "16 bit" : "float", mode)
                            .c_str(),
                        *std::min_element(ms.begin(), ms.end()), 12, "ms");
        }
});

// Hills of some metres on 4096^2, half a metre a texel.
Terrain hillyLand(PixelType type) {
    Terrain t;
    t.size = {2048, 2048};
    t.heightRange = {0, 100};
    t.height.file = "a";
    t.height.map = Map({kSide, kSide, 1, type});
    std::vector<std::byte> row(size_t(kSide) * t.height.map.texelBytes());
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const float metres =
                50 + 20 * std::sin(static_cast<float>(x) * 0.01f) * std::cos(static_cast<float>(y) * 0.013f);
            const auto whole = static_cast<uint16_t>(metres * 655.35f);
            if (type == PixelType::F32) std::memcpy(&row[size_t(x) * 4], &metres, 4);
            if (type == PixelType::U16) std::memcpy(&row[size_t(x) * 2], &whole, 2);
        }
        t.height.map.writeRows(y, 1, row.data());
    }
    return t;
}

// A stamp of a sculpting stroke and all that follows for it to be seen: its tiles sent to the GPU, bounds of the
// ground, shadows of hills. The least of many, since other work on the machine only adds.
double sculptMs(PixelType type, const char* mode) {
    Terrain t = hillyLand(type);
    const glm::vec3 sun = glm::normalize(glm::vec3(0.6f, 0.5f, 0.3f));
    HeightBounds bounds;
    HeightGrid heights = shadeHeights(t), hidden = hiddenHeights(heights, t.size, sun);
    std::optional<MapTextures> textures;
    if (gpu()) textures.emplace(*gpu());
    BrushSettings brush;
    brush.radius = 250, brush.strength = 0.5f, brush.value = 1;
    paintHeights(brush, heightScale(t));
    std::vector<double> ms;
    for (uint32_t turn = 0; turn < 20; ++turn) {
        const Map before = t.height.map;
        const auto follow = [&] {
            updateHeightBounds(bounds, t);
            updateHiddenHeights(hidden, heights, t.size, sun, updateShadeHeights(heights, before, t));
            if (!textures) return;
            textures->get("bench", "heights", t.height.map);
            glFinish();
        };
        if (turn == 0) follow();
        ms.push_back(1e3 * seconds([&] {
                         applyStamp(t.height.map, *findBrush(mode), {2000, 2100, 500, 500, turn}, brush);
                         follow();
                     }));
    }
    return *std::min_element(ms.begin(), ms.end());
}

SWARD_LIMITS("sculpt", [] {
    constexpr std::pair<const char*, double> kMost[] = {
        {"raise", 12}, {"flatten", 12}, {"smooth", 12}, {"noise", 12}, {"erode", 12}};
    for (const PixelType type : {PixelType::U16, PixelType::F32})
        for (const auto& [mode, most] : kMost)
            reportLimit(fmt::format("{} 500 texels of 4096^2 {} heights, shadows and upload included", mode,
                                    type == PixelType::U16 ? "16 bit" : "float")
                            .c_str(),
                        sculptMs(type, mode), most, "ms");
});

}  // namespace
