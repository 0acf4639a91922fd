#include "model/map_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/jobs.h"
#include "maps/map_io.h"
#include "model/assets.h"
#include "model/one_step.h"
#include "scene/map_fields.h"
#include "tools/stroke.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr int kMostTaps = 8;  // along a side, of a picture that is finer than the ground

Map mirroredRows(const Map& map) {
    Map out(map.info());
    const size_t texel = map.texelBytes(), width = size_t(map.info().width);
    std::vector<std::byte> row(width * texel), other(width * texel);
    for (int y = 0; y < map.info().height; ++y) {
        map.readRows(y, 1, row.data());
        for (size_t x = 0; x < width; ++x) std::copy_n(&row[x * texel], texel, &other[(width - 1 - x) * texel]);
        out.writeRows(y, 1, other.data());
    }
    return out;
}

double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// How far the picture counts at a place of the rectangle.
double weightOf(const HeightPlace& p, double x, double z) {
    const double dx = std::min(x - p.at.x, p.at.x + p.size.x - x), dz = std::min(z - p.at.y, p.at.y + p.size.y - z);
    if (dx < 0 || dz < 0) return 0;
    const double rim = 0.5 * static_cast<double>(p.falloff) * std::min(p.size.x, p.size.y);
    return rim > 0 ? smooth(std::min(dx, dz) / rim) : 1;
}

double metresAt(const Map& source, const HeightPlace& p, double u, double v) {
    const double value = static_cast<double>(
        source.sample(std::clamp(p.flipX ? 1 - u : u, 0.0, 1.0), std::clamp(p.flipZ ? 1 - v : v, 0.0, 1.0)));
    return source.info().type == PixelType::F32 ? value : p.low + (p.high - p.low) * value;
}

Status checkPlace(const Terrain& t, const HeightPlace& p) {
    const bool finite =
        std::isfinite(p.at.x + p.at.y + p.size.x + p.size.y + p.low + p.high) && std::isfinite(p.falloff);
    if (!finite || !(p.size.x > 0 && p.size.y > 0))
        return usage("the rectangle is empty", "give a width and a depth above 0 m");
    const bool over = p.at.x < t.size.x && p.at.y < t.size.y && p.at.x + p.size.x > 0 && p.at.y + p.size.y > 0;
    if (!over)
        return usage("the rectangle lies beside the terrain",
                     fmt::format("it goes from 0, 0 to {}, {} m", t.size.x, t.size.y));
    if (p.falloff < 0 || p.falloff > 1) return usage("the falloff is not between 0 and 1", "0 is a hard edge");
    return {};
}

// The texels [from, to[ of a side that a rectangle's side covers.
std::pair<int, int> covered(double at, double size, double metres, int texels) {
    const auto texel = [&](double m) { return std::clamp(m / metres * texels, 0.0, static_cast<double>(texels)); };
    return {static_cast<int>(std::floor(texel(at))), static_cast<int>(std::ceil(texel(at + size)))};
}

struct TexelBox {
    int x0, y0, x1, y1;  // the latter beyond the last
};

// Of one tile; how many texels' height does not fit the map's range.
size_t setHeights(Map& map, const Terrain& t, const Map& source, const HeightPlace& place, const TexelBox& box) {
    const MapInfo info = map.info();
    const auto [offset, scale] = heightScale(t);
    const double wide = t.size.x / info.width, deep = t.size.y / info.height;
    size_t beyond = 0;
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x) {
            const double before = offset + scale * static_cast<double>(map.at(x, y));
            const double after =
                placedHeight(source, place, (x + 0.5) * wide, (y + 0.5) * deep, before, std::max(wide, deep));
            if (after == before) continue;
            const double value = (after - offset) / scale;
            beyond += info.type != PixelType::F32 && (value < -1e-6 || value > 1 + 1e-6);
            map.set(x, y, 0, static_cast<float>(value));
        }
    return beyond;
}

// Tile by tile, on all workers.
size_t setHeights(Map& map, const Terrain& t, const Map& source, const HeightPlace& place, JobControl* control) {
    const auto [x0, x1] = covered(place.at.x, place.size.x, t.size.x, map.info().width);
    const auto [y0, y1] = covered(place.at.y, place.size.y, t.size.y, map.info().height);
    std::vector<TexelBox> boxes;
    for (int y = y0; y < y1; y = (y / kTileSize + 1) * kTileSize)
        for (int x = x0; x < x1; x = (x / kTileSize + 1) * kTileSize)
            boxes.push_back(
                {x, y, std::min((x / kTileSize + 1) * kTileSize, x1), std::min((y / kTileSize + 1) * kTileSize, y1)});
    std::atomic<size_t> beyond = 0, done = 0;
    parallelFor(boxes.size(), [&](size_t i) {
        if (control && control->cancelled()) return;
        beyond += setHeights(map, t, source, place, boxes[i]);
        if (control) control->setProgress(static_cast<double>(++done) / static_cast<double>(boxes.size()));
    });
    return beyond;
}

}  // namespace

Status importIntoMap(Document& doc, const std::string& mapPath, const std::filesystem::path& file,
                     const ImportOptions& options, bool flipX) {
    const Result<ConstFieldRef> map = findMap(doc.project(), doc.tables().components, mapPath);
    if (!map) return map.error();
    MapImport used;
    Result<Map> texels = readImport(doc.project(), *map, file, options, &used);
    if (!texels) return texels.error();
    const FieldRow* range = map->row->map->heightRange;
    const bool spans = range && used.range && texels->info().type != PixelType::F32;
    const std::string path = map->path, rangePath = spans ? fieldBeside(*map, *range).path : "";
    const Status done = inOneStep(doc, "import " + path, [&] {
        if (Status set = doc.setMap(path, flipX ? mirroredRows(*texels) : std::move(*texels), "import"); !set)
            return set;
        return spans ? doc.setField(rangePath, fmt::format("[{}, {}]", used.range->first, used.range->second))
                     : Status{};
    });
    if (done) doc.rememberImport(path, used);
    return done;
}

Status chooseFile(Document& doc, const std::string& fieldPath, const std::filesystem::path& file) {
    const Result<ConstFieldRef> field = findField(doc.project(), doc.tables().components, fieldPath);
    if (!field) return field.error();
    if (!field->row->isFile) return usage(fieldPath + " names no file");
    const std::filesystem::path& dir = doc.project().dir;
    const Result<std::string> name = field->row->isMesh ? importAsset(dir, file) : importImage(dir, file);
    return name ? doc.setField(fieldPath, *name) : name.error();
}

double placedHeight(const Map& source, const HeightPlace& p, double x, double z, double before, double texel) {
    const double weight = weightOf(p, x, z);
    if (weight <= 0) return before;
    const double finest = std::min(p.size.x / source.info().width, p.size.y / source.info().height);
    const int taps = std::clamp(static_cast<int>(std::ceil(texel / finest)), 1, kMostTaps);
    double sum = 0;
    for (int j = 0; j < taps; ++j)
        for (int i = 0; i < taps; ++i) {
            const double dx = ((i + 0.5) / taps - 0.5) * texel, dz = ((j + 0.5) / taps - 0.5) * texel;
            sum += metresAt(source, p, (x + dx - p.at.x) / p.size.x, (z + dz - p.at.y) / p.size.y);
        }
    return before + (sum / (taps * taps) - before) * weight;
}

Result<Map> readHeights(const std::string& file) {
    MapWish heights;
    heights.isHeight = true;
    return readMap(file, heights);
}

Status placeHeights(Document& doc, const Map& source, const HeightPlace& place, size_t* beyond, JobControl* control) {
    const Ground ground = doc.isOpen() ? findGround(doc.project()) : Ground{};
    if (!ground.terrain) return usage("there is no terrain", "add an entity with a Terrain");
    if (source.empty()) return usage("there is no picture of heights", "choose a file");
    if (Status sound = checkPlace(*ground.terrain, place); !sound) return sound;
    const std::string path = entityOf(doc.project(), *ground.terrain) + ".Terrain.height";
    const Result<ConstFieldRef> field = findMap(doc.project(), doc.tables().components, path);
    if (!field) return field.error();
    const Result<MapScale> scale = mapScale(doc.project(), *field);
    if (!scale) return scale.error();
    if (scale->repeats)
        return usage(path + " repeats over the terrain, and so would the picture",
                     "set mapSize to 0 and heightTiling to 1 first");
    return inOneStep(doc, "place heights", [&] {
        if (Status made = doc.createMap(path); !made) return made;
        const Terrain& t = *findGround(doc.project()).terrain;
        Map heights = t.height.map;
        const size_t over = setHeights(heights, t, source, place, control);
        if (beyond) *beyond = over;
        return doc.setMap(path, std::move(heights), "place heights");
    });
}

}  // namespace sward
