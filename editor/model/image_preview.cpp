#include "model/image_preview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "maps/map_io.h"

namespace sward {
namespace {

void findRange(const Map& map, ImagePreview& p) {
    p.low = INFINITY, p.high = -INFINITY;
    for (int y = 0; y < map.info().height; ++y)
        for (int x = 0; x < map.info().width; ++x)
            for (int c = 0; c < std::min(map.info().channels, 3); ++c) {
                const double value = static_cast<double>(map.at(x, y, c));
                p.low = std::min(p.low, value), p.high = std::max(p.high, value);
            }
}

// The mean of the texels below a pixel, up to 8 x 8 of them.
float meanBelow(const Map& map, const ImagePreview& p, int px, int py, int c) {
    const auto place = [](int pixel, int pixels, int size, int i, int n) {
        return std::min(size - 1, static_cast<int>((pixel + (i + 0.5) / n) / pixels * size));
    };
    const int n = std::clamp(std::max(map.info().width / p.width, map.info().height / p.height), 1, 8);
    float sum = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            sum += map.at(place(px, p.width, map.info().width, i, n), place(py, p.height, map.info().height, j, n), c);
    return sum / static_cast<float>(n * n);
}

uint32_t pixelOf(const Map& map, const ImagePreview& p, int x, int y) {
    const int channels = map.info().channels;
    const bool within = p.low >= 0 && p.high <= 1 && channels > 1;
    const float low = within ? 0 : static_cast<float>(p.low),
                span = within ? 1 : static_cast<float>(std::max(p.high - p.low, 1e-12));
    uint32_t pixel = 0xff000000u;
    for (int c = 0; c < 3; ++c) {
        const int from = channels == 1 ? 0 : c;
        const float value = from < channels ? (meanBelow(map, p, x, y, from) - low) / span : 0;
        pixel |= static_cast<uint32_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255)) << (8 * c);
    }
    return pixel;
}

}  // namespace

ImagePreview previewOf(const Map& map) {
    ImagePreview p;
    p.info = map.info();
    if (map.empty()) return p;
    findRange(map, p);
    const double most = std::max(p.info.width, p.info.height), scale = std::min(1.0, kPreviewSide / most);
    p.width = std::max(1, static_cast<int>(p.info.width * scale));
    p.height = std::max(1, static_cast<int>(p.info.height * scale));
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) p.pixels.push_back(pixelOf(map, p, x, y));
    return p;
}

ImagePreview previewOf(const std::string& file) {
    ImagePreview p;
    std::vector<std::string> repaired;
    MapWish any;
    any.channels = 0;
    const Result<Map> map = readMap(file, any, &repaired);
    if (map)
        p = previewOf(*map);
    else
        p.error = map.error().text();
    p.file = file;
    p.repaired = std::move(repaired);
    return p;
}

std::string describe(const ImagePreview& p) {
    const char* type = p.info.type == PixelType::U8 ? "8 bit" : p.info.type == PixelType::U16 ? "16 bit" : "floats";
    return fmt::format("{} x {}, {}, {} channel{}, {:.4g} to {:.4g}", p.info.width, p.info.height, type,
                       p.info.channels, p.info.channels == 1 ? "" : "s", p.low, p.high);
}

}  // namespace sward
