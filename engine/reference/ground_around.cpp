#include "reference/ground_around.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "core/numerics.h"
#include "mesh/mesh.h"
#include "shared/objects.h"

namespace sward {
namespace {

constexpr int kFine = AROUND_SIDE - 1;          // steps a square
constexpr int kCoarse = 4;                      // likewise
constexpr double kFootHeight = 1;               // metres above the ground
constexpr double kReach = 2, kMostReach = 24;   // of an object: of its height; metres
constexpr double kAbout = 1, kAboutFoot = 0.3;  // metres around an object that get half-metre steps; and fine ones
constexpr double kLargeFoot = 8;                // metres across: points half a metre apart find a larger one
constexpr float kSeen = 0.015f;                 // change of the share of light that counts as one
constexpr float kRough = 0.12f;                 // difference between points half a metre apart that asks for more

using GridPlace = std::pair<int, int>;  // z, x: of a cell, or of a point in steps of the finest grid

// Points of the ground, each traced once.
class GroundPoints {
  public:
    GroundPoints(const AroundTracer& tracer, const JobControl& control) : tracer_(tracer), control_(control) {}
    // Marks those of a cell for trace(); steps: a side.
    void want(const GridPlace& cell, int steps) {
        eachOf(cell, steps, [&](const GridPlace& at) {
            if (found_.try_emplace(at).second) wanted_.push_back(at);
        });
    }
    void trace() {
        std::vector<std::optional<AroundFactors>> traced(wanted_.size());
        parallelFor(wanted_.size(), [&](size_t i) {
            if (control_.cancelled()) return;
            constexpr double step = AROUND_CELL / kFine;
            traced[i] =
                tracer_.changeOnGround(wanted_[i].second * step + kGroundAside, wanted_[i].first * step + kGroundAside);
        });
        for (size_t i = 0; i < wanted_.size(); ++i) found_[wanted_[i]] = traced[i];
        wanted_.clear();
    }
    // Whether all of a cell's corners lie within objects.
    bool isHidden(const GridPlace& cell) const {
        bool hidden = true;
        eachOf(cell, 1, [&](const GridPlace& at) { hidden = hidden && !found_.at(at); });
        return hidden;
    }
    // What was found at a cell's points; what lies within objects is as its neighbours are.
    std::vector<AroundFactors> of(const GridPlace& cell, int steps) const {
        std::vector<std::optional<AroundFactors>> points;
        eachOf(cell, steps, [&](const GridPlace& at) { points.push_back(found_.at(at)); });
        return filled(std::move(points), steps + 1);
    }

  private:
    template <class F>
    static void eachOf(const GridPlace& cell, int steps, F f) {
        const int step = kFine / steps;
        for (int z = 0; z <= steps; ++z)
            for (int x = 0; x <= steps; ++x) f({cell.first * kFine + z * step, cell.second * kFine + x * step});
    }
    // Each round gives those beside known ones the mean of these.
    static std::vector<AroundFactors> filled(std::vector<std::optional<AroundFactors>> points, int side) {
        const auto meanAround = [&](int x, int z) -> std::optional<AroundFactors> {
            AroundFactors sum;
            float n = 0;
            for (int j = std::max(z - 1, 0); j <= std::min(z + 1, side - 1); ++j)
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, side - 1); ++i)
                    if (const auto& p = points[static_cast<size_t>(j * side + i)])
                        sum.sky += p->sky, sum.sun += p->sun, sum.ground += p->ground, n += 1;
            if (n == 0) return std::nullopt;
            return AroundFactors{sum.sky / n, sum.sun / n, sum.ground / n};
        };
        for (int round = 0; round < side; ++round) {
            std::vector<std::optional<AroundFactors>> next = points;
            for (int z = 0; z < side; ++z)
                for (int x = 0; x < side; ++x)
                    if (auto& p = next[static_cast<size_t>(z * side + x)]; !p) p = meanAround(x, z);
            if (std::equal(next.begin(), next.end(), points.begin(),
                           [](const auto& a, const auto& b) { return a.has_value() == b.has_value(); }))
                break;
            points = std::move(next);
        }
        std::vector<AroundFactors> out;
        for (const auto& p : points) out.push_back(p.value_or(AroundFactors{}));
        return out;
    }

    struct PlaceHash {
        size_t operator()(const GridPlace& p) const {
            return f32::hash2(static_cast<uint32_t>(p.first), static_cast<uint32_t>(p.second));
        }
    };
    const AroundTracer& tracer_;
    const JobControl& control_;
    std::unordered_map<GridPlace, std::optional<AroundFactors>, PlaceHash> found_;
    std::vector<GridPlace> wanted_;
};

// Adds the terrain's cells that a rectangle touches, as long as they are not too many.
void addCells(std::set<GridPlace>& out, const Terrain& t, const glm::dvec2& low, const glm::dvec2& high) {
    constexpr double kCell = AROUND_CELL, kMostCells = 65536;  // along an axis: a key has 16 bits for each
    const glm::dvec2 last = glm::min(glm::ceil(t.size / kCell), glm::dvec2(kMostCells)) - 1.0;
    if (!(low.x <= high.x && low.y <= high.y)) return;
    const glm::ivec2 from(glm::clamp(glm::floor(low / kCell), glm::dvec2(0), last + 1.0)),
        to(glm::clamp(glm::floor(high / kCell), glm::dvec2(-1), last));
    for (int z = from.y; z <= to.y; ++z)
        for (int x = from.x; x <= to.x && out.size() < kMostGroundTiles; ++x) out.insert({z, x});
}

float offOpen(const AroundFactors& change, const AroundLights& lights) {
    const glm::vec3 off = glm::abs(shareAfter(change, lights) - 1.0f);
    return std::max(off.x, std::max(off.y, off.z));
}
bool hasChange(const std::vector<AroundFactors>& points, const AroundLights& lights) {
    return std::any_of(points.begin(), points.end(), [&](const auto& p) { return offOpen(p, lights) > kSeen; });
}
bool isRough(const std::vector<AroundFactors>& points, int side, const AroundLights& lights, float rough) {
    const auto share = [&](int x, int z) { return shareAfter(points[static_cast<size_t>(z * side + x)], lights).y; };
    for (int z = 0; z < side; ++z)
        for (int x = 0; x < side; ++x) {
            if (x > 0 && std::abs(share(x, z) - share(x - 1, z)) > rough) return true;
            if (z > 0 && std::abs(share(x, z) - share(x, z - 1)) > rough) return true;
        }
    return false;
}

}  // namespace

StandingBox standingBox(const Ground& ground, const PlacedMesh& placed, const Mesh& mesh) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    StandingBox box{glm::dvec2(kNone), glm::dvec2(-kNone), glm::dvec2(kNone), glm::dvec2(-kNone), 0};
    for (const MeshVertex& v : mesh.vertices) {
        const glm::dvec3 at = placed.at - ground.origin +
                              placed.turn * (static_cast<double>(placed.mesh->scale) * glm::dvec3(v.position));
        const glm::dvec2 place(at.x, at.z);
        const double above = at.y - (ground.terrain ? terrainHeight(*ground.terrain, at.x, at.z) : 0);
        box.low = glm::min(box.low, place), box.high = glm::max(box.high, place);
        box.top = std::max(box.top, above);
        if (above > kFootHeight) continue;
        box.footLow = glm::min(box.footLow, place), box.footHigh = glm::max(box.footHigh, place);
    }
    return box;
}

Result<std::vector<GroundTile>> traceGround(const AroundTracer& tracer, const Project& p,
                                            const std::vector<StandingBox>& boxes, const JobControl& control) {
    std::vector<GroundTile> out;
    const Ground ground = findGround(p);
    if (!ground.terrain) return out;
    std::set<GridPlace> reached, beside, feet;
    for (const StandingBox& b : boxes) {
        const double reach = std::min(kReach * b.top, kMostReach);
        addCells(reached, *ground.terrain, b.low - reach, b.high + reach);
        addCells(beside, *ground.terrain, b.low - kAbout, b.high + kAbout);
        const glm::dvec2 foot = b.footHigh - b.footLow;
        if (std::max(foot.x, foot.y) < kLargeFoot)
            addCells(feet, *ground.terrain, b.footLow - kAboutFoot, b.footHigh + kAboutFoot);
    }
    const AroundLights& lights = tracer.lights();
    GroundPoints points(tracer, control);
    for (const GridPlace& c : reached) points.want(c, 1);
    points.trace();
    std::map<GridPlace, int> steps;
    const auto refine = [&](const GridPlace& c, int to) { points.want(c, steps[c] = to); };
    const auto isRoughOf = [&](const GridPlace& c, float rough) {
        return isRough(points.of(c, steps.at(c)), steps.at(c) + 1, lights, rough);
    };
    for (const GridPlace& c : reached) steps[c] = 1;
    for (const GridPlace& c : reached)
        if (feet.contains(c))
            refine(c, kFine);
        else if (!points.isHidden(c) && (beside.contains(c) || isRoughOf(c, kRough / 2)))
            refine(c, kCoarse);
    points.trace();
    for (const GridPlace& c : reached)
        if (steps.at(c) == kCoarse && isRoughOf(c, kRough)) refine(c, kFine);
    points.trace();
    if (control.cancelled()) return failed("cancelled");
    for (const GridPlace& c : reached) {
        std::vector<AroundFactors> change = points.of(c, steps.at(c));
        if (out.size() < kMostGroundTiles && hasChange(change, lights))
            out.push_back({{c.second, c.first}, steps.at(c) + 1, std::move(change)});
    }
    return out;
}

namespace {

// A tile's share at a point of the finest grid, between its own points.
glm::vec3 shareAt(const GroundTile& t, const std::vector<glm::vec3>& shares, int x, int z) {
    const int steps = t.side - 1, step = kFine / steps;
    const int i = std::min(x / step, steps - 1), j = std::min(z / step, steps - 1);
    const float u = static_cast<float>(x - i * step) / static_cast<float>(step),
                v = static_cast<float>(z - j * step) / static_cast<float>(step);
    const auto at = [&](int a, int b) { return shares[static_cast<size_t>((j + b) * t.side + i + a)]; };
    return glm::mix(glm::mix(at(0, 0), at(1, 0), u), glm::mix(at(0, 1), at(1, 1), u), v);
}

// Less by what does not count, so that no step shows where tiles end.
glm::vec3 shownShare(const glm::vec3& share) {
    const glm::vec3 off = share - 1.0f;
    return glm::min(1.0f + glm::sign(off) * glm::max(glm::abs(off) - kSeen, glm::vec3(0)), glm::vec3(65504.0f));
}

void addToTable(std::vector<glm::uvec2>& table, const glm::ivec2& cell, uint32_t tile) {
    const auto last = static_cast<uint32_t>(table.size()) - 1;
    uint32_t slot = f32::hash2(static_cast<uint32_t>(cell.x), static_cast<uint32_t>(cell.y)) & last;
    while (table[slot].x != AROUND_EMPTY) slot = (slot + 1) & last;
    table[slot] = {static_cast<uint32_t>(cell.x) | static_cast<uint32_t>(cell.y) << 16, tile};
}

}  // namespace

PackedGround packGround(const std::vector<GroundTile>& tiles, const AroundLights& lights) {
    PackedGround out;
    if (tiles.empty()) return out;
    constexpr size_t side = AROUND_SIDE, width = AROUND_ACROSS * side;
    out.share.resize((tiles.size() + AROUND_ACROSS - 1) / AROUND_ACROSS * side * width, glm::vec4(1));
    size_t slots = AROUND_TABLE;
    while (slots < 2 * tiles.size()) slots *= 2;
    out.table.resize(slots, glm::uvec2(AROUND_EMPTY, 0));
    out.from = out.to = tiles.front().cell;
    for (size_t n = 0; n < tiles.size(); ++n) {
        const GroundTile& t = tiles[n];
        std::vector<glm::vec3> shares;
        for (const AroundFactors& f : t.change) shares.push_back(shownShare(shareAfter(f, lights)));
        const size_t corner = n / AROUND_ACROSS * side * width + n % AROUND_ACROSS * side;
        for (size_t z = 0; z < side; ++z)
            for (size_t x = 0; x < side; ++x)
                out.share[corner + z * width + x] =
                    glm::vec4(shareAt(t, shares, static_cast<int>(x), static_cast<int>(z)), 1);
        addToTable(out.table, t.cell, static_cast<uint32_t>(n));
        out.from = glm::min(out.from, t.cell), out.to = glm::max(out.to, t.cell + 1);
    }
    return out;
}

}  // namespace sward
