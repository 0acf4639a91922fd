#include "reference/posed_cells.h"

#include "reference/blade_hits.h"
#include "reference/ray_field.h"

namespace sward {
namespace {

constexpr uint32_t kParts = 2;                 // boxes of a blade, since one that leans lies in the diagonal of one box
constexpr uint32_t kBladesWorthARay = 16;      // made in the time that a ray takes through boxes of a class
constexpr uint32_t kLooks = 32;                // rays after which it is looked for again
constexpr size_t kBytesOfBoxes = 48 * kParts;  // of a blade, in Embree

std::optional<f32::RibbonHit> posedMet(const Query& q, uint32_t part, float near, float far) {
    const PosedBlade& b = q.posed->blades[part / kParts];
    const float chance = f32::hashUnit(f32::hash3(q.grain, b.index, static_cast<uint32_t>(q.cell->key)));
    return bladeMetBy({q.origin - b.root, q.way, b.control, b.tip, b.facing, b.width, q.kind->image, chance}, near,
                      far);
}

// A part of a blade lies in the hull of its own three controls.
void partBounds(const RTCBoundsFunctionArguments* a) {
    const PosedBlade& b = static_cast<const PosedCell*>(a->geometryUserPtr)->blades[a->primID / kParts];
    const float part = static_cast<float>(a->primID % kParts), from = part / kParts, to = (part + 1) / kParts;
    const glm::vec3 first = f32::bladePosition(b.control, b.tip, from), last = f32::bladePosition(b.control, b.tip, to),
                    middle = b.control * (from * (1 - to) + to * (1 - from)) + b.tip * (from * to);
    const glm::vec3 side(0.5f * b.width * std::abs(b.facing.y) + 1e-5f, 1e-5f,
                         0.5f * b.width * std::abs(b.facing.x) + 1e-5f);
    const glm::vec3 low = b.root + glm::min(first, glm::min(middle, last)) - side,
                    high = b.root + glm::max(first, glm::max(middle, last)) + side;
    *a->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
}

std::unique_ptr<PosedCell> poseCell(const RayField& f, const Kind& kind, const Cell& cell, uint32_t blades, int x,
                                    int z) {
    auto out = std::make_unique<PosedCell>();
    for (uint32_t i = 0; i < blades; ++i) {
        const Posed b = poseBladeAt(f, kind, cell, x, z, i);
        if (b.width > 0) out->blades.push_back({b.root, b.control, b.tip, b.facing, b.width, i});
    }
    out->blades.shrink_to_fit();
    out->scene = sceneOfBoxes<partBounds>(kind.device.get(), out->blades.size() * kParts, out.get(),
                                          meetClosestBlade<Query, posedMet>, meetAnyBlade<Query, posedMet>);
    return out;
}

}  // namespace

uint32_t numberOf(const PosedCell& cell, uint32_t box) { return cell.blades[box / kParts].index; }

const PosedCell* PosedCells::find(uint64_t key) const {
    std::shared_lock lock(mutex);
    const auto found = cells.find(key);
    return found == cells.end() ? nullptr : found->second.get();
}

const PosedCell* posedCell(const RayField& f, size_t kindNumber, Cell& cell, int x, int z) {
    if (cell.posed) return cell.posed;
    const Kind& kind = *f.kinds[kindNumber];
    if (++cell.asked % kLooks != 0) return nullptr;
    if ((cell.posed = kind.posed.find(cell.key))) return cell.posed;
    if (cell.mayHold == 0) cell.mayHold = bladesIn(f, kind, cell, x, z);
    if (cell.asked * kBladesWorthARay < cell.mayHold) return nullptr;
    cell.asked = 0;  // where another thread makes it, or there is no room, asked for again after as many rays
    const size_t bytes = cell.mayHold * (sizeof(PosedBlade) + kBytesOfBoxes);
    if (f.posedBytes->load() + bytes > kPosedBytes) return nullptr;
    {
        std::unique_lock lock(kind.posed.mutex);
        if (!kind.posed.cells.try_emplace(cell.key).second) return nullptr;
    }
    *f.posedBytes += bytes;
    auto made = poseCell(f, kind, cell, cell.mayHold, x, z);
    std::unique_lock lock(kind.posed.mutex);
    return cell.posed = (kind.posed.cells[cell.key] = std::move(made)).get();
}

}  // namespace sward
