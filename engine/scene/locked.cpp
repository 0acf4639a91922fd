#include "scene/locked.h"

namespace sward {

const ComponentRow& lockedRow() {
    static const ComponentRow row = componentRow<Locked>("Locked", "The viewport neither chooses nor moves it.", {},
                                                         [](const void*) { return FeatureSet{}; });
    return row;
}

bool isLocked(const Project& p, const std::string& entity) {
    const Entity e = findEntity(p, entity);
    return e != kNoEntity && p.registry.get<Locked>(e);
}

}  // namespace sward
