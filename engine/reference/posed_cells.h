// Cells of a field that rays ask for often: every blade is posed where it stands and has boxes of its own, where other
// cells share boxes wide enough for all leans of a class, of which a ray meets tens for each blade (ray_field.h). For
// grass_rays.cpp. How: a thread counts the rays that it sends through a cell, and makes its blades once that has cost
// as much; all threads share them, up to kPosedBytes a project. Does not: forget a cell. Cost: 1 us and 150 bytes a
// blade.
#pragma once
#include <atomic>
#include <memory>
#include <shared_mutex>
#include <unordered_map>
#include <vector>

#include "core/numerics.h"
#include "reference/embree.h"

namespace sward {

constexpr size_t kPosedBytes = size_t{192} << 20;  // of blades and boxes, of all fields of a project

// A blade relative to its cell's corner and base height. index: its number among the cell's.
struct PosedBlade {
    glm::vec3 root, control, tip;
    glm::vec2 facing;
    float width;
    uint32_t index;
};
struct PosedCell {
    std::vector<PosedBlade> blades;
    ScenePtr scene;
};
// Number of the blade that has this box of the scene.
uint32_t numberOf(const PosedCell& cell, uint32_t box);
// Of one kind, by the cells' keys.
struct PosedCells {
    mutable std::shared_mutex mutex;
    std::unordered_map<uint64_t, std::unique_ptr<PosedCell>> cells;  // null: a thread is making it
    // Null of what is not there, or not yet.
    const PosedCell* find(uint64_t key) const;
};

struct RayField;
struct Cell;
// The cell at x, z, if it is there or now worth it and within the budget; counts that a ray asks for it.
const PosedCell* posedCell(const RayField& f, size_t kind, Cell& cell, int x, int z);

}  // namespace sward
