// What a whole scene asks for: the union of its components' features, and what holds only between them.
#include "scene/components.h"

namespace sward {

Entity sunEntity(const Registry& registry) {
    Entity first = kNoEntity;
    std::string_view least;
    registry.each<Light>([&](Entity e, const Light& light) {
        const Name* name = registry.get<Name>(e);
        if (!name || light.type != LightType::Directional) return;
        if (first != kNoEntity && name->value >= least) return;
        first = e;
        least = name->value;
    });
    return first;
}

bool shines(const Light& light) {
    return light.intensity > 0 && std::max({light.color.x, light.color.y, light.color.z}) > 0;
}

namespace {
// A source of force presses where it stands and where it left tracks; in play the walker's feet have these alone.
bool presses(const Registry& registry, Entity e) {
    const ForceSource* s = registry.get<ForceSource>(e);
    return s && (registry.get<Transform>(e) || !s->tracks.empty());
}
// What one entity asks for by all its components.
FeatureSet entityFeatures(const Registry& registry, const Tables& tables, Entity e, Entity sun, bool coarse) {
    FeatureSet all;
    for (const ComponentRow& row : tables.components)
        if (const void* component = row.get(registry, e)) {
            all |= row.features(component);
            if (row.featuresOnEntity) all |= row.featuresOnEntity(registry, e, tables, coarse);
        }
    if (registry.get<Rolling>(e)) all &= ~featureSet(Feature::ObjectLight);  // it would be traced anew in each frame
    if (!presses(registry, e)) all &= ~featureSet(Feature::Forces, Feature::ForceOutlines);
    if (has(all, Feature::Sun) && e != sun) all = (all & ~featureSet(Feature::Sun)) | featureSet(Feature::Lamps);
    return all;
}
// Whether a light beside the sun casts shadows.
bool lampCasts(const Registry& registry, Entity sun) {
    bool any = false;
    registry.each<Light>([&](Entity e, const Light& light) {
        any = any || (e != sun && light.castShadows && shines(light) && registry.get<Name>(e));
    });
    return any;
}
}  // namespace

FeatureSet sceneFeatures(const Registry& registry, const Tables& tables, bool coarse) {
    FeatureSet all;
    const Entity sun = sunEntity(registry);
    registry.each<Name>([&](Entity e, const Name&) { all |= entityFeatures(registry, tables, e, sun, coarse); });
    if (!has(all, Feature::Sun) && !has(all, Feature::Sky)) all &= ~featureSet(Feature::ObjectLight);
    if (!has(all, Feature::Sun)) all &= ~featureSet(Feature::ObjectShadows, Feature::TerrainShadows);  // of the sun
    if (!lampCasts(registry, sun)) all &= ~featureSet(Feature::LampShadows, Feature::LampHills);
    return all;
}

std::vector<std::string> entitiesWith(const Registry& registry, const Tables& tables, Feature f) {
    std::vector<std::string> names;
    const Entity sun = sunEntity(registry);
    registry.each<Name>([&](Entity e, const Name& name) {
        if (has(entityFeatures(registry, tables, e, sun, false), f)) names.push_back(name.value);
    });
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace sward
