// How much grass one scene may have, beyond which neither renderer nor check lets it through. Source of the numbers:
// what shaders hold (shaders/shared). Does not: limit blades; a unique population has its own limit (scene/unique.h).
#pragma once
#include "scene/project.h"

namespace sward {

inline constexpr size_t kMaxFields = 8;         // GrassFields a scene
inline constexpr size_t kMaxSpecies = 16;       // species a field
inline constexpr size_t kMaxSceneSpecies = 64;  // species of all fields together
inline constexpr size_t kMaxSoilMaps = 20;  // density, blade-height and ambient-occlusion maps of all fields together

// What is too much. path: of the field of a component that holds it, without list elements ("lawn.GrassField.species").
struct FieldFault {
    std::string entity, field, message;
};
// The first limit that a scene breaks, by its fields in the order of names; nothing if it keeps them all. Fields
// without blades count as well.
std::optional<FieldFault> brokenLimit(const Project& p);
// The same as an Unsound error that names project.json.
Status checkFields(const Project& p);

}  // namespace sward
