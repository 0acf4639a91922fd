// Images whole: a map whose texels are finite, an image, or an error; both readers take the same files, and so does who
// opens their tiles.
#include <cmath>

#include "fuzz/scratch.h"
#include "maps/image_head.h"
#include "maps/map_io.h"
#include "maps/tile_file.h"

using namespace sward;

namespace {
constexpr int64_t kMostTexels = 1 << 16;  // larger ones are sound, and slow
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    const auto file = fuzz::inputFile("image", fuzz::textOf(data, size));
    if (const auto head = readImageHead(file);
        head && static_cast<double>(head->width) * static_cast<double>(head->height) > kMostTexels)
        return 0;
    const auto image = readImage(file);
    fuzz::promise(bool(checkImage(file)) == bool(image), "check decodes what a reader does");
    if (image)
        for (const float v : image->pixels) fuzz::promise(std::isfinite(v), "pixels are finite");
    MapWish wish;
    wish.channels = 0;
    const auto map = readMap(file, wish);
    if (!map) return 0;
    if (const auto head = readImageHead(file); head->tiles) {
        const auto opened = openTiles(file, *head->tiles);
        fuzz::promise(opened && checkTiles(*opened), "tiles lie within the file");
        fuzz::promise(opened->hash() == map->hash(), "tiles hold what the library reads");
    }
    const MapInfo& info = map->info();
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x)
            for (int c = 0; c < info.channels; ++c) fuzz::promise(std::isfinite(map->at(x, y, c)), "texels are finite");
    return 0;
}
