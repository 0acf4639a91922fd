// Which blades exist: the one definition that every technique and the reference read.
// A patch is one cell's blades; cells repeat it mirrored and begun elsewhere (numerics/population.h); density decides
// which of a cell's blades exist. Source: Boulanger, Pattanaik and Bouatouch 2006, sections 3.1, 3.2, 3.4; stable forms
// in shaders/numerics. Does not: draw. Cost: a patch of 22,000 blades 3 ms and 1.4 MB, once a species.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/numerics.h"
#include "scene/components.h"
#include "shared/grass.h"  // Blade

namespace sward {

// Sorted by threshold, so that what a range of densities needs is one contiguous range of blades.
struct Patch {
    std::vector<Blade> blades;
    std::array<uint32_t, 256> upTo{};    // upTo[k]: blades with threshold <= k/255; upTo[0] = 0
    f32::Sown sown = f32::sownEvenly();  // how cells take its thresholds (numerics/sowing.h)
};

inline constexpr int kMaxPatchBlades = 4'000'000;  // a patch has no more
// bladesPerM2 * cellSize^2 blades, or so many that they are whole, with stratified roots (each in a stratum of its own,
// B-24): where cells have fewer, or no whole number, `sown` says which of them each has. Equal arguments give equal
// patches. cellSize: metres, above 0.
Patch makePatch(const Species& species, float cellSize, uint32_t seed);
// `blades` blades of a cell that has its own (scene/unique.h), sorted by threshold: any number in ]0, 1], even also
// where they are few.
std::vector<Blade> cellBlades(const Species& species, float cellSize, uint32_t seed, int blades);
// What a species' chances of cells (cellChance) are made of; seed: the field's.
uint32_t sowingSeed(const Species& species, uint32_t seed);
// Hash over all that makePatch reads, to know when a patch is stale.
uint64_t patchKey(const Species& species, float cellSize, uint32_t seed);

// Lean (m per m of blade) that paint of full strength gives, and what full clump values give: lean (m per m), share of
// height, share of lightness; as numerics/stand.h takes them.
float leanAtFull(const Species& species);
glm::vec3 clumpStrengths(const Species& species);

}  // namespace sward
