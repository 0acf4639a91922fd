#include "scene/field_limits.h"

#include "scene/technique.h"
#include "shared/grass.h"
#include "shared/soil.h"

namespace sward {
namespace {

static_assert(kMaxFields == MAX_FIELDS && kMaxSpecies == MAX_SPECIES && kMaxSceneSpecies == MAX_SOIL_SPECIES &&
              kMaxSoilMaps == MAX_SOIL_MAPS);

size_t soilMaps(const GrassField& f) {
    if (!f.onTerrain) return 0;
    const auto drawn = [](const Species& s) { return s.density.present(); };
    return static_cast<size_t>(std::count_if(f.species.begin(), f.species.end(), drawn)) + f.bladeHeight.present() +
           f.ambientOcclusion.present();
}

}  // namespace

std::optional<FieldFault> brokenLimit(const Project& p) {
    size_t fields = 0, species = 0, maps = 0;
    for (const auto& [name, field] : fieldsOf(p)) {
        const GrassField& f = field.grows;
        fields += 1, species += f.species.size(), maps += soilMaps(f);
        const auto fault = [&entity = name](const char* where, std::string message) {
            return FieldFault{entity, where, entity + ".GrassField" + (*where ? "." : "") + where + ": " + message};
        };
        if (f.species.size() > kMaxSpecies)
            return fault("species", fmt::format("{} species; a field may have {}", f.species.size(), kMaxSpecies));
        if (fields > kMaxFields)
            return fault("", fmt::format("it is field {}; a scene may have {}", fields, kMaxFields));
        if (species > kMaxSceneSpecies)
            return fault("species",
                         fmt::format("with it fields have {} species; a scene may have {}", species, kMaxSceneSpecies));
        if (maps > kMaxSoilMaps)
            return fault("species",
                         fmt::format("with it fields have {} density, blade-height and ambient-occlusion maps; "
                                     "a scene may have {}",
                                     maps, kMaxSoilMaps));
    }
    return std::nullopt;
}

Status checkFields(const Project& p) {
    const std::optional<FieldFault> fault = brokenLimit(p);
    if (!fault) return {};
    return unsound(fault->message, "put species together, or remove some").at(p.dir / "project.json");
}

}  // namespace sward
