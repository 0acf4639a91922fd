// The population "unique": every cell has blades of its own, instead of one patch repeated (Jahrmann and Wimmer 2013,
// sections 3 and 4.2: the basic technique, for small scenes). How many a cell has follows from the density's texels, to
// the last part of a blade (J-9). A blade has a threshold as a patch's has, and is stored where the density at its root
// reaches it; so any choice by thresholds is even, and the first of a cell's blades are a coarser version of it, for
// views that need no more (reflections). Does not: serve slices, which are images of the patch; they show the patch's.
// Cost: 64 bytes a blade; making them about 0.2 us for each that the density would allow.
#pragma once
#include "scene/population.h"
#include "scene/project.h"
#include "scene/tiling.h"

namespace sward {

// Over all species of a field; 128 MB, which every renderer holds in one buffer.
inline constexpr double kMaxUniqueBlades = 2'000'000;

struct UniqueBlades {
    Patch patch;  // blades of all cells, cell by cell; each cell's sorted by threshold. upTo is not used
    std::vector<uint32_t> first;  // by cell, rows along z; one more than there are cells
    int cellsX = 0;
    uint32_t mostInCell = 0;
    // True where the species has no blades of its own.
    bool empty() const { return first.empty(); }
    // Blades of a cell with thresholds in [low, high]: from, and to beyond the last.
    std::pair<uint32_t, uint32_t> range(int x, int z, float low, float high) const;
};
// Whether the field's population is "unique".
bool isUnique(const GrassField& f);
// The same for equal species, cell size, seed, density and extent.
UniqueBlades makeUnique(const Species& species, const GrassField& field, const Terrain& terrain);
// Hash over all that makeUnique reads but the density map.
uint64_t uniqueKey(const Species& species, const GrassField& field, const Terrain& terrain);

// The first entity by name whose GrassField has a unique population; empty if none has.
std::string uniqueField(const Project& p);
// Unsound error, naming project.json, the field and the limit, if a unique population has more blades than that;
// `blades`: virtualBlades of the project. Without it they are counted, if there is such a population.
Status checkUnique(const Project& p, double blades);
Status checkUnique(const Project& p);

}  // namespace sward
