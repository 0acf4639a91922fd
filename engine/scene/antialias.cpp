#include "scene/antialias.h"

#include "scene/field_rows.h"

namespace sward {
namespace {

constexpr FieldRow kFields[] = {
    choice("antialias", &Antialias::antialias, offsetof(Antialias, antialias), kAntialiasings,
           "msaa: each frame takes all samples of a pixel; temporal: one each, and frames add up"),
    where([](const void* owner) { return static_cast<const Antialias*>(owner)->antialias == Antialiasing::Temporal; },
          whole("frames", offsetof(Antialias, frames), "", {kLeastFrames, kMostFrames, 4, 32},
                "how many frames a picture is the mean of")),
};

FeatureSet features(const void* component) {
    const auto& a = *static_cast<const Antialias*>(component);
    return a.antialias == Antialiasing::Temporal ? featureSet(Feature::Temporal) : FeatureSet{};
}

}  // namespace

const ComponentRow& antialiasRow() {
    static const ComponentRow row =
        componentRow<Antialias>("Antialias", "How pixels come to their samples.", kFields, features);
    return row;
}

const Antialias* temporalOf(const Project& p) {
    for (const auto& [name, e] : p.entities)
        if (const Antialias* a = p.registry.get<Antialias>(e); a && a->antialias == Antialiasing::Temporal) return a;
    return nullptr;
}

void setAntialias(Project& p, Antialiasing kind) {
    bool set = false;
    for (const auto& [name, e] : p.entities)
        if (Antialias* a = p.registry.get<Antialias>(e)) a->antialias = kind, set = true;
    if (set || kind == Antialiasing::Msaa) return;
    std::string name = "antialias";
    while (p.entities.contains(name)) name += "-";
    if (const auto e = addEntity(p, name)) p.registry.add(*e, Antialias{kind});
}

}  // namespace sward
