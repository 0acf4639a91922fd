// What stands among a species' blades: the other species of its field, which shade them. Does not: shade
// (numerics/others.h), nor know other fields.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/components.h"

namespace sward {

// Another species, as it stands where the first one grows.
struct Among {
    float height = 0;   // mean, m
    glm::vec2 area{0};  // of its leaves at density 1: towards a level view and towards the zenith, m2 a m2
    float skyLeft = 1;  // share of the sky's light that these leave to the soil
    float density = 1;  // of it, in the mean over the first one's blades
};
// Share of light that they leave so high over the ground (m); towards: the light, unit, or 0 of all of the sky.
float amongLeave(const std::vector<Among>& among, float high, const glm::vec3& towards);

// How dense each species of a field is where each of them grows, in the mean over the terrain.
struct DensitiesAmong {
    std::vector<float> means;  // of species k where i grows: i times the number of species, and k
    std::vector<Map> madeFrom;
    uint64_t key = 0;  // of what else
    float of(size_t k, size_t i) const { return means[i * madeFrom.size() + k]; }
};
// Made anew if maps or how they lie differ from what they were made from; fields of one species have none.
void updateDensitiesAmong(DensitiesAmong& among, const GrassField& field, const Terrain& terrain);

}  // namespace sward
