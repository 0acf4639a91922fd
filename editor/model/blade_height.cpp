#include "model/blade_height.h"

#include "maps/map_repair.h"
#include "project/packed_map.h"
#include "script/map_ops.h"
#include "tools/stroke.h"

namespace sward {
namespace {

constexpr double kReach = 2;  // heights of the species
constexpr double kLeastTexels = 2;

double heightOf(const Project& p, const ConstFieldRef& density) {
    const auto* field = p.registry.get<GrassField>(findEntity(p, density.entity));
    for (const Species& s : field->species)
        if (&s.density == density.value) return static_cast<double>(s.height);
    return 0;
}

}  // namespace

Status heightFromDensity(Document& document, const std::string& name) {
    const Project& p = document.project();
    const auto rows = document.tables().components;
    const Result<ConstFieldRef> density = findMap(p, rows, name);
    if (!density) return density.error();
    const Result<ConstFieldRef> height = bladeHeightBeside(p, rows, *density);
    if (!height) return height.error();
    const MapField& from = *static_cast<const MapField*>(density->value);
    if (!from.present()) return usage(density->path + ": there is no map", "create or import one first");
    const Result<MapScale> scale = mapScale(p, *density);
    if (!scale) return scale.error();
    Map map = convertMap(from.map, height->row->mapType);
    const double radius = kReach * heightOf(p, *density);
    const auto texels = [&](int n, double metres) {
        return std::clamp(radius * n / metres, kLeastTexels, static_cast<double>(n));
    };
    blurMap(map, texels(map.info().width, scale->width), texels(map.info().height, scale->depth), kAllChannels,
            scale->repeats);
    document.beginGroup("height from density");
    Status done = document.setMap(height->path, std::move(map), "height from density");
    if (done) done = document.setField(height->path + "Tiling", fmt::format("{}", scale->factor));
    done ? document.endGroup() : document.cancelGroup();
    return done;
}

}  // namespace sward
