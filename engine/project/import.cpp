#include "project/import.h"

#include "core/utf8.h"
#include "maps/map_io.h"
#include "scene/map_fields.h"
#include "world/map_stacks.h"

namespace sward {
namespace {

// What was asked for, else what is remembered.
Result<MapImport> settle(const Project& p, const ConstFieldRef& map, const std::filesystem::path& file,
                         const ImportOptions& options) {
    const auto it = p.imports.find(map.path);
    MapImport out = it == p.imports.end() ? MapImport() : it->second;
    out.file = utf8Text(file.filename().string());
    if (options.flip) out.flip = *options.flip;
    if (options.range) out.range = options.range;
    if (out.range &&
        !(std::isfinite(out.range->first) && std::isfinite(out.range->second) && out.range->first < out.range->second))
        return usage(fmt::format("{}: the range must be two numbers, the smaller first", map.path),
                     "write --range 0,100");
    return out;
}

// The range becomes what integer heights span; floats are metres already.
Status setHeightRange(const FieldRef& map, const MapImport& import, PixelType type) {
    const FieldRow* row = map.row->map->heightRange;
    if (!row || !import.range || type == PixelType::F32) return {};
    const auto [low, high] = *import.range;
    if (low < row->hardMin || high > row->hardMax)
        return usage(fmt::format("{}: the range lies beyond {} to {} m", map.path, row->hardMin, row->hardMax));
    *static_cast<glm::dvec2*>(fieldBeside(map, *row).value) = {low, high};
    return {};
}

}  // namespace

Result<Map> readImport(const Project& p, const ConstFieldRef& map, const std::filesystem::path& file,
                       const ImportOptions& options, MapImport* used, std::vector<std::string>* repaired) {
    CHECK(map.row && map.row->type == FieldType::Map);
    Result<MapImport> settled = settle(p, map, file, options);
    if (!settled) return settled.error();
    MapWish wish = mapWish(*map.row);
    wish.flip = settled->flip;
    wish.range = settled->range;
    if (!wish.isHeight) wish.type = map.row->map->type;
    if (!settled->range && wish.isHeight) settled->range = sidecarRange(file);
    Result<Map> texels = readMap(file, wish, repaired);
    if (texels && used) *used = *settled;
    return texels;
}

Status importMap(Project& p, std::span<const ComponentRow> rows, const std::string& mapName,
                 const std::filesystem::path& file, const ImportOptions& options, std::vector<std::string>* repaired) {
    const Result<FieldRef> map = findMap(p, rows, mapName);
    if (!map) return map.error();
    MapImport used;
    Result<Map> texels = readImport(p, *map, file, options, &used, repaired);
    if (!texels) return texels.error();
    if (Status s = setHeightRange(*map, used, texels->info().type); !s) return s;
    auto& field = *static_cast<MapField*>(map->value);
    field.file = mapFileFor(*map, texels->info());
    field.map = std::move(*texels);
    p.imports[map->path] = used;
    return {};
}

Status exportMap(const Project& p, std::span<const ComponentRow> rows, const std::string& mapName,
                 const std::filesystem::path& file, const ImportOptions& options) {
    MapStacks stacks;
    const Result<ConstFieldRef> map = findMap(stacks.shown(p, rows), rows, mapName);
    if (!map) return map.error();
    const auto& field = *static_cast<const MapField*>(map->value);
    if (!field.present()) return usage(fmt::format("{} has no map", map->path), "import or paint one first");
    const Result<MapImport> settled = settle(p, *map, file, options);
    if (!settled) return settled.error();
    return writeMap(file, field.map, settled->flip, settled->range);
}

}  // namespace sward
