#include "model/hollow.h"

#include <algorithm>
#include <cmath>

#include "model/float_heights.h"
#include "model/new_map.h"
#include "model/one_step.h"
#include "tools/stroke.h"
#include "world/ground.h"

namespace sward {
namespace {

// Calls change(value, x, z) for each texel within the radius; x and z are metres on the terrain.
template <class F>
void changeWithin(Map& map, const glm::dvec2& size, const glm::dvec2& middle, double radius, const F& change) {
    const glm::dvec2 texel = size / glm::dvec2(map.info().width, map.info().height);
    const auto first = [](double at, double of) { return std::max(0, static_cast<int>(std::floor(at / of))); };
    const int x1 = std::min(map.info().width - 1, first(middle.x + radius, texel.x));
    const int z1 = std::min(map.info().height - 1, first(middle.y + radius, texel.y));
    for (int j = first(middle.y - radius, texel.y); j <= z1; ++j)
        for (int i = first(middle.x - radius, texel.x); i <= x1; ++i) {
            const double x = (i + 0.5) * texel.x, z = (j + 0.5) * texel.y;
            if (glm::length(glm::dvec2(x, z) - middle) <= radius)
                map.set(i, j, 0, static_cast<float>(change(static_cast<double>(map.at(i, j)), x, z)));
        }
}

// Whether a texel of the map lies at one place of the terrain alone.
bool coversOnce(const Project& p, const ConstFieldRef& map) {
    const Result<MapScale> scale = mapScale(p, map);
    const glm::dvec2 size = findGround(p).terrain->size;
    return scale && !scale->repeats && scale->width == size.x && scale->depth == size.y;
}

Status lower(Document& doc, const std::string& entity, const Hollow& h, const glm::dvec2& middle) {
    const std::string path = entity + ".Terrain.height";
    if (Status made = doc.createMap(path); !made) return made;
    if (!coversOnce(doc.project(), *findField(doc.project(), doc.tables().components, path)))
        return usage(entity + "'s heights repeat, so that a hollow would be dug again and again",
                     "set its heightTiling and mapSize so that the map covers the terrain once");
    const Terrain* t = doc.project().registry.get<Terrain>(findEntity(doc.project(), entity));
    if (t->height.map.info().type != PixelType::F32) {
        if (Status s = heightsAsFloats(doc); !s) return s;
        t = doc.project().registry.get<Terrain>(findEntity(doc.project(), entity));
    }
    Map heights = t->height.map;
    changeWithin(heights, t->size, middle, h.radius, [&](double was, double x, double z) {
        const double out = glm::length(glm::dvec2(x, z) - middle) / h.radius;
        const double share = 1 - out * out * (3 - 2 * out);  // smooth at the rim and in the middle
        return std::min(was, was + (h.floor - was) * share);
    });
    return doc.setMap(path, std::move(heights), "dig");
}

// Nothing grows below the waterline.
Status bare(Document& doc, const std::string& entity, const Hollow& h, const glm::dvec2& middle) {
    std::vector<std::string> paths;
    for (const ConstFieldRef& map : allMaps(doc.project(), doc.tables().components, true))
        if (map.row->map->role == MapRole::Density && !map.row->map->onMesh) paths.push_back(map.path);
    for (const std::string& path : paths) {
        const auto field = findField(doc.project(), doc.tables().components, path);
        if (!field || !coversOnce(doc.project(), *field)) continue;  // what repeats would be bare elsewhere, too
        Map density = static_cast<const MapField*>(field->value)->map;
        if (density.empty()) density = newMap(doc.project(), *field);
        const Terrain& t = *doc.project().registry.get<Terrain>(findEntity(doc.project(), entity));
        changeWithin(density, t.size, middle, h.radius,
                     [&](double was, double x, double z) { return terrainHeight(t, x, z) < h.bareBelow ? 0 : was; });
        if (Status s = doc.setMap(path, std::move(density), "clear"); !s) return s;
    }
    return {};
}

}  // namespace

RimLow lowestAlongRim(const Terrain& t, std::span<const WaterPlace> waters, const glm::dvec2& middle, double radius) {
    RimLow low{1e30};
    for (int i = 0; i < 32; ++i) {
        const double a = 2 * 3.14159265358979 * i / 32;
        const glm::dvec2 at = middle + radius * glm::dvec2(std::cos(a), std::sin(a));
        RimLow here{terrainHeight(t, at.x, at.y)};
        for (const WaterPlace& w : waters)
            if (const double level = w.water->level; level > here.height && within(w, at.x, at.y)) here = {level, true};
        if (here.height < low.height) low = here;
    }
    return low;
}

Status digHollow(Document& doc, const Hollow& hollow) {
    const Ground ground = findGround(doc.project());
    if (!ground.terrain) return usage("the scene has no ground", "add an entity with a Terrain");
    const std::string entity = entityOf(doc.project(), *ground.terrain);
    const glm::dvec2 middle = hollow.middle - glm::dvec2(ground.origin.x, ground.origin.z);
    return inOneStep(doc, "dig a hollow", [&]() -> Status {
        if (Status s = lower(doc, entity, hollow, middle); !s) return s;
        return bare(doc, entity, hollow, middle);
    });
}

}  // namespace sward
