// A lawn on a ramp with layers over its density, for tests of layers.
#pragma once
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "scene/map_layers.h"
#include "techniques.h"
#include "tests/scenes.h"
#include "world/map_stacks.h"

namespace sward::test {

inline constexpr float kInf = std::numeric_limits<float>::infinity();
inline constexpr const char* kLayered = "GrassField.species[lawn].density";
inline constexpr const char* kLayeredPath = "grass.GrassField.species[lawn].density";

inline Terrain& terrain(Project& p) { return *p.registry.get<Terrain>(findEntity(p, "ground")); }
// Flat at 0 m up to x = 10, from there on rising by `slopeDeg`; 20 x 20 m, painted with `painted` everywhere.
inline Project rampLawn(double slopeDeg, float painted = 0.8f) {
    Project p = lawn();
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    Map heights({200, 200, 1, PixelType::F32});
    const double rise = std::tan(glm::radians(slopeDeg));
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x)
            heights.set(x, y, 0, static_cast<float>(std::max((x + 0.5) * 0.1 - 10, 0.0) * rise));
    t.height = field(std::move(heights), "maps/heights.exr");
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density =
        field(filled({256, 256, 1, PixelType::U16}, painted), "maps/density.png");
    return p;
}

inline MapMask maskBy(MaskBy by, float from, float to, float falloff = 0) {
    MapMask mask;
    mask.by = by;
    mask.from = from, mask.to = to, mask.falloff = falloff;
    return mask;
}
inline MapLayer ruleLayer(const std::string& name, std::vector<MapMask> masks,
                          LayerOperation operation = LayerOperation::Multiply) {
    MapLayer layer;
    layer.name = name;
    layer.map = kLayered;
    layer.operation = operation;
    layer.masks = std::move(masks);
    return layer;
}
// Over the lawn's maps, in this order.
inline MapLayers& lay(Project& p, std::vector<MapLayer> layers) {
    return put(p, "grass", MapLayers{std::move(layers)});
}

// The project as its layers leave it; none if no layer does anything.
inline std::optional<Project> withLayers(const Project& p, std::span<const ComponentRow> rows) {
    MapStacks stacks;
    const Project& shown = stacks.shown(p, rows);
    return &shown == &p ? std::nullopt : std::optional(snapshot(shown, rows));
}

inline Map& painted(Project& p) { return p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density.map; }
inline const Map& density(const Project& p) {
    return p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density.map;
}
// At terrain-relative metres, of a map that lies on the lawn once.
inline float at(const Map& map, double x, double z) { return map.sample(x / 20, z / 20); }

}  // namespace sward::test
