// One field of grass as rays see it: its kinds of blades, each posed where it stands when a ray first meets its box,
// and kept for a while. For grass_rays.cpp. Does not: walk along a ray.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "core/numerics.h"
#include "grass/appearance.h"
#include "reference/embree.h"
#include "reference/grass_rays.h"
#include "reference/posed_cells.h"
#include "reference/standing.h"
#include "scene/unique.h"
#include "world/forces.h"
#include "world/ground.h"
#include "world/wind.h"

namespace sward {

// The ground under a cell: a plane through its corner, and how far the ground leaves it.
struct CellGround {
    float slopeX = 0, slopeZ = 0, bump = 0;
    float low = 0, high = 0;  // metres above the corner
};

struct Cell {
    uint64_t key = ~uint64_t(0);
    RTCScene scene = nullptr;  // null: nothing grows
    f32::CellVersion version{glm::vec2(1), glm::vec2(0)};
    float chance = 0.5f;  // numerics/sowing.h
    double base = 0;      // height of the plane at the cell's corner
    WindGlobals wind{};   // about the cell's corner, as strong as the kind feels it; unused in a calm
    CellGround ground;
    uint32_t first = 0;  // of its blades among the kind's
    // Of posedCell: null where it has not made it; rays since it last tried to; blades that it may have.
    const PosedCell* posed = nullptr;
    uint32_t asked = 0, mayHold = 0;
};
struct Kept {
    uint64_t key = ~uint64_t(0);
    Posed blade;
};
constexpr size_t kCells = 1 << 15, kBlades = 1 << 17;

struct GrassMemory::Tables {
    std::vector<Cell> cells{kCells};
    std::vector<Kept> blades{kBlades};
};
// What a scene of boxes is made for: the cell, where cells have blades of their own (else 0); thresholds up to 255ths,
// mean lean, its spread, the ground's bump; in steps.
struct SceneKey {
    uint64_t cell;
    int prefix, leanX, leanZ, spread, bump;
    auto operator<=>(const SceneKey&) const = default;
};
struct BoxScene {
    const Blade* blades;
    glm::vec2 lean;
    float spread, scale, bump;
    ScenePtr scene;
};

// One species: its patch, its looks, and the scenes made so far.
struct Kind {
    const Species* species = nullptr;
    Patch patch;
    UniqueBlades unique;   // empty: cells repeat the patch
    uint32_t sowSeed = 0;  // sowingSeed
    const std::vector<Blade>& blades() const { return unique.empty() ? patch.blades : unique.patch.blades; }
    const f32::Sown& sown() const { return unique.empty() ? patch.sown : unique.patch.sown; }
    TexelGrid image;
    Look look;
    float leanAtFull = 0, reach = 0;
    float gust = 0,
          windSlope =
              0;  // lean (m per m) that a full gust gives it, and by how much the wind's may change over a metre
    glm::vec3 clumps{0};
    DevicePtr device;
    mutable std::mutex mutex;
    mutable std::map<SceneKey, BoxScene> scenes;
    mutable PosedCells posed;
};

// A field of grass as its wind bends it at a time.
struct RayField {
    uint32_t number = 0;   // among the scene's fields
    size_t firstKind = 0;  // kinds of the fields before it: blades are remembered by kind
    const Terrain* terrain = nullptr;
    const GrassField* grass = nullptr;
    HeightBounds bounds;
    const Wind* wind = nullptr;  // null: a calm
    const Map* gusts = nullptr;  // its picture of gusts, which may be the one that is made
    Map made;
    double time = 0;
    std::vector<Force> forces;
    std::vector<std::unique_ptr<Kind>> kinds;
    std::shared_ptr<std::atomic<size_t>> posedBytes;  // of all fields' posed cells
};

// A ray within a cell, as the callbacks of its scene see it. First member: Embree's.
struct Query {
    RayContext context;
    const RayField* field;
    size_t number;  // of the species among the field's kinds
    const Kind* kind;
    GrassMemory::Tables* memory;
    const Cell* cell;
    const PosedCell* posed;  // null: the scene is that of the cell's class
    int x, z;
    glm::vec3 origin, way;  // relative to the cell's corner and base height
    uint32_t grain;
    uint32_t blade = 0;  // of the closest hit: number of its box in the scene
    f32::RibbonHit hit{};
};

// The field's paint, density and share of blades' height at a place: terrain-relative metres.
float densityAt(const RayField& f, const Species& s, const glm::dvec2& ground);
float bladeShareAt(const RayField& f, const glm::dvec2& ground);
// The blade where it stands; rootPlace, if given: its root's place on maps.
Posed poseBladeAt(const RayField& f, const Kind& kind, const Cell& cell, int x, int z, uint32_t index,
                  glm::dvec2* rootPlace = nullptr);
// All of the project's fields as its wind bends them at a scene time; none without grass or terrain. Errors as
// GrassRays::make.
Result<std::vector<std::unique_ptr<RayField>>> makeRayFields(const Project& p, double time, const JobControl& control);
// The cell at x, z without a scene of its blades' boxes, and how many of its first blades its density may let be.
Cell bareCell(const RayField& f, size_t kind, int x, int z);
uint32_t bladesIn(const RayField& f, const Kind& kind, Cell& cell, int x, int z);
// The cell at x, z with the scene of its blades' boxes, from a thread's memory or made.
Cell& cellAt(const RayField& f, GrassMemory::Tables& memory, size_t kind, int x, int z);

}  // namespace sward
