#include "project/packed_map.h"

#include "core/utf8.h"
#include "maps/map_io.h"
#include "maps/map_repair.h"
#include "scene/map_fields.h"
#include "world/map_stacks.h"

namespace sward {
namespace {

constexpr float kGreenStep = 1.5f / 255;  // within which green counts as a share of red

// One of several channels, as a map of its own.
Map channelOf(const Map& floats, int channel, PixelType type) {
    const MapInfo& info = floats.info();
    Map out({info.width, info.height, 1, PixelType::F32});
    std::vector<float> in(static_cast<size_t>(info.width) * static_cast<size_t>(info.channels)),
        one(static_cast<size_t>(info.width));
    for (int y = 0; y < info.height; ++y) {
        floats.readRows(y, 1, in.data());
        for (size_t x = 0; x < one.size(); ++x)
            one[x] = in[x * static_cast<size_t>(info.channels) + static_cast<size_t>(channel)];
        out.writeRows(y, 1, one.data());
    }
    return convertMap(out, type);
}

bool hasOwnCoarse(const Map& floats) {
    const MapInfo& info = floats.info();
    std::vector<float> row(static_cast<size_t>(info.width) * static_cast<size_t>(info.channels));
    for (int y = 0; y < info.height; ++y) {
        floats.readRows(y, 1, row.data());
        for (size_t i = 0; i < row.size(); i += static_cast<size_t>(info.channels))
            if (std::abs(row[i + 1] - kCoarseShare * row[i]) > kGreenStep) return true;
    }
    return false;
}

float shareAt(const MapField& m, double u, double v) { return m.present() ? m.map.sample(u, v) : 1.0f; }

Map packed(const MapField& density, const MapField& bladeHeight) {
    const MapInfo size = (density.present() ? density : bladeHeight).map.info();
    Map out({size.width, size.height, 3, PixelType::F32});
    std::vector<float> row(static_cast<size_t>(size.width) * 3);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double u = (x + 0.5) / size.width, v = (y + 0.5) / size.height;
            float* texel = &row[static_cast<size_t>(x) * 3];
            texel[0] = shareAt(density, u, v);
            texel[1] = kCoarseShare * texel[0];
            texel[2] = shareAt(bladeHeight, u, v);
        }
        out.writeRows(y, 1, row.data());
    }
    return convertMap(out, PixelType::U16);
}

void put(Project& p, const FieldRef& field, Map map, const std::filesystem::path& file, bool flip) {
    MapField& to = *static_cast<MapField*>(field.value);
    to.file = mapFileFor(field, map.info());
    to.map = std::move(map);
    p.imports[field.path] = {utf8Text(file.filename().string()), flip, {}};
}

// As asked for, else as remembered.
bool flipOf(const Project& p, const ConstFieldRef& map, const ImportOptions& options) {
    const auto it = p.imports.find(map.path);
    return options.flip.value_or(it != p.imports.end() && it->second.flip);
}

}  // namespace

Result<PackedMaps> readPacked(const std::filesystem::path& file, bool flip, std::vector<std::string>* repaired) {
    MapWish wish;
    wish.channels = 0;
    wish.flip = flip;
    const Result<Map> read = readMap(file, wish, repaired);
    if (!read) return read.error();
    if (read->info().channels < 3)
        return unsound(
                   fmt::format("has {} channels; a packed density map has red, green and blue", read->info().channels),
                   "leave out packed, or export it in colour")
            .at(file);
    const Map floats = convertMap(*read, PixelType::F32);
    return PackedMaps{channelOf(floats, 0, PixelType::U16), channelOf(floats, 2, PixelType::U8), hasOwnCoarse(floats)};
}

Result<ConstFieldRef> bladeHeightBeside(const Project& p, std::span<const ComponentRow> rows,
                                        const ConstFieldRef& density) {
    const FieldRow* height = density.row->map->packedWith;
    if (!height)
        return usage(density.path + " is no density map: only those are packed with blade heights",
                     "name a species' density");
    return findField(p, rows, fmt::format("{}.{}.{}", density.entity, density.component->name, height->name));
}

Status importPacked(Project& p, std::span<const ComponentRow> rows, const std::string& mapName,
                    const std::filesystem::path& file, const ImportOptions& options,
                    std::vector<std::string>* repaired) {
    const Result<FieldRef> density = findMap(p, rows, mapName);
    if (!density) return density.error();
    const Result<ConstFieldRef> beside = bladeHeightBeside(p, rows, *density);
    if (!beside) return beside.error();
    const Result<FieldRef> height = findField(p, rows, beside->path);
    const bool flip = flipOf(p, *density, options);
    Result<PackedMaps> maps = readPacked(file, flip, repaired);
    if (!maps) return maps.error();
    if (maps->ownCoarse && repaired) repaired->emplace_back(kGreenNotKept);
    put(p, *density, std::move(maps->density), file, flip);
    put(p, *height, std::move(maps->bladeHeight), file, flip);
    *static_cast<float*>(fieldBeside(*height, *height->row->map->tiling).value) = mapTiling(*density);
    return {};
}

Status exportPacked(const Project& p, std::span<const ComponentRow> rows, const std::string& mapName,
                    const std::filesystem::path& file, const ImportOptions& options) {
    MapStacks stacks;
    const Project& shown = stacks.shown(p, rows);
    const Result<ConstFieldRef> density = findMap(shown, rows, mapName);
    if (!density) return density.error();
    const Result<ConstFieldRef> height = bladeHeightBeside(shown, rows, *density);
    if (!height) return height.error();
    const MapField &red = mapOf(*density), &blue = mapOf(*height);
    if (!red.present() && !blue.present())
        return usage(fmt::format("neither {} nor {} has a map", density->path, height->path),
                     "import or paint one first");
    if (red.present() && blue.present() && mapTiling(*density) != mapTiling(*height))
        return usage(fmt::format("{} and {} repeat differently, and cannot be one image", density->path, height->path),
                     "give both the same tiling, or export them apart");
    return writeMap(file, packed(red, blue), flipOf(p, *density, options));
}

}  // namespace sward
