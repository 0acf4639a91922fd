#include "grass/blade_list.h"

#include <atomic>
#include <bit>

#include "core/jobs.h"
#include "core/numerics.h"

namespace sward {
namespace {

constexpr float kSlack = 1e-4f;  // of densities, weights and metres: the GPU rounds otherwise

// The four bytes of x, each with `shift` added to it and what it carries dropped.
uint32_t bytesShifted(uint32_t x, uint32_t shift) {
    uint32_t out = 0;
    for (int bit = 0; bit < 32; bit += 8) out |= (((x >> bit) + shift) & 255) << bit;
    return out;
}

// The least opacity at which one of the samples is covered: their chances, of 256, are those of coveredAlpha in
// lib/transparency.glsl.
float leastCovered(const Blade& b, const PixelCoverage& c) {
    const uint32_t low = bytesShifted(f32::hash3(std::bit_cast<uint32_t>(b.dither), 1, 0), c.shift),
                   high = f32::hashMix(low);
    uint32_t least = 255;
    for (int i = 0; i < std::clamp(c.samples, 1, 8); ++i)
        least = std::min(least, (i < 4 ? low : high) >> (8 * (i % 4)) & 255);
    return (static_cast<float>(least) + 0.5f) / 256;
}

struct CellList {
    std::vector<uint32_t> indices;
    uint32_t blades = 0;
};

struct Lister {
    const BladeListQuery& q;
    const CellDraw& cell;
    float low = 0, high = 0;  // of the cell's ground, relative to the eye

    Lister(const BladeListQuery& query, const CellDraw& c) : q(query), cell(c) {
        const double x = c.cellX * q.cells.cellSize, z = c.cellZ * q.cells.cellSize, size = q.cells.cellSize;
        const auto [lowest, highest] = q.cells.bounds.over(q.cells.terrain.size, x, z, x + size, z + size);
        low = static_cast<float>(lowest - q.cells.eye.y), high = static_cast<float>(highest - q.cells.eye.y);
    }

    // place: its root, terrain-relative metres. Where a map repeats often, the GPU's coordinates are off by more.
    float mostOpacity(const Blade& b, const glm::vec2& place, float distance) const {
        const Tiling& tiling = q.cells.densityTiling;
        const float density = q.cells.density ? tiledSample(*q.cells.density, tiling, place.x, place.y) : 1.0f;
        const float slack = q.cells.density ? kSlack + (tiling.repeats ? tiledSlack(place) : 0) : 0;
        const float weight = f32::lodRamp(distance * (1 - kSlack) - kSlack, q.cells.range.min, q.cells.range.inv);
        const float threshold = thresholdIn(q.cells, cell, b);
        const float slices = f32::sliceOpacity(std::max(density - slack, 0.0f), std::max(weight - kSlack, 0.0f),
                                               threshold, q.cells.fade);
        return f32::opacityConserving(std::min(density + slack, 1.0f), threshold, q.cells.fade) - slices;
    }

    // Four roundings of the place's coordinates, in texels: densities of neighbours differ by at most 1.
    float tiledSlack(const glm::vec2& place) const {
        const MapInfo& info = q.cells.density->info();
        const glm::vec2 texels = place / glm::vec2(q.cells.densityTiling.metres) * glm::vec2(info.width, info.height);
        return (std::abs(texels.x) + std::abs(texels.y)) * 4 * std::numeric_limits<float>::epsilon();
    }

    // Whether it has a shadow of its own, and is not one of those that others stand for.
    bool shades(const Blade& b, float distance) const {
        const float pixel = std::max(distance * (1 - kSlack) - kSlack, 0.0f) / q.cells.pixelsPerMetre;
        const float chance = f32::shadowChance(std::bit_cast<uint32_t>(b.dither), cell.cellX, cell.cellZ);
        return f32::shadowWidening(f32::shadowsOfOne(b.width, pixel), chance) > 0;
    }

    bool inView(const glm::vec2& at) const {
        const float r = q.beyond;
        return q.cells.frustum.touches({at.x - r, low - r, at.y - r}, {at.x + r, high + r, at.y + r});
    }

    void add(CellList& out, uint32_t i) const {
        const Blade& b = q.cells.patch.blades[i];
        const float size = static_cast<float>(q.cells.cellSize);
        const glm::vec2 root = f32::rootInCell(b.root, cell.mirror, cell.shift, size),
                        at = glm::vec2(cell.x, cell.z) + root;
        const glm::vec2 place = glm::vec2(cell.cellX, cell.cellZ) * size + root;
        const glm::vec2 share = place / glm::vec2(q.cells.terrain.size);
        if (std::max(share.x, share.y) > 1 + kSlack || !inView(at)) return;
        const float distance = glm::length(glm::vec3(at.x, std::clamp(0.0f, low, high), at.y));
        if (q.shadows && !shades(b, distance)) return;
        const float least = q.shadows ? b.dither : leastShown(b, q.shown);
        if (mostOpacity(b, place, distance) < std::max(least - 10 * kSlack, 1e-6f)) return;
        addStrip(out.indices, i, q.shadows ? std::min(q.cells.segments, kShadowQuads) : cell.segments, q.cells.segments,
                 q.shadows);
        ++out.blades;
    }
};

CellList listCell(const BladeListQuery& q, const CellDraw& c) {
    CellList out;
    if (!c.seen && q.beyond <= q.cells.reach) return out;
    const Lister lister(q, c);
    const uint32_t last = c.first + bladesDrawn(c, q.share);
    for (uint32_t i = c.first; i < last; ++i) lister.add(out, i);
    return out;
}

// Cells hold at most so many indices. Where that is far more than can be listed, looking at each blade would only show
// it once a gigabyte is full.
size_t mostIndices(const BladeListQuery& q, std::span<const CellDraw> cells) {
    size_t sum = 0;
    for (const CellDraw& c : cells)
        sum += size_t{bladesDrawn(c, q.share)} * 6 * static_cast<size_t>(q.shadows ? 1 : c.segments);
    return sum;
}

}  // namespace

float leastShown(const Blade& b, const PixelCoverage& c) {
    switch (c.way) {
        case Transparency::Coverage:
            return leastCovered(b, c);
        case Transparency::Both:
            return 0.1f;
        case Transparency::Test:
            return 0.5f;
        default:
            return 0.004f;
    }
}

void addStrip(std::vector<uint32_t>& indices, uint32_t blade, int quads, int segments, bool pointed) {
    const uint32_t base = blade * 2 * static_cast<uint32_t>(segments + 1);
    for (int s = 0; s < quads; ++s) {
        const uint32_t a = base + 2 * static_cast<uint32_t>(s), c = a + 2;
        indices.insert(indices.end(), {a, a + 1, c});
        if (!pointed || s + 1 < quads) indices.insert(indices.end(), {c, a + 1, c + 1});
    }
}

BladeList listBlades(const BladeListQuery& q, std::span<const CellDraw> cells) {
    constexpr size_t kHopeless = 4 * kMostListed;
    if (mostIndices(q, cells) > kHopeless) {
        BladeList none;
        none.tooMany = true;
        return none;
    }
    std::vector<CellList> lists(cells.size());
    std::atomic<size_t> indices = 0;
    parallelFor(cells.size(), [&](size_t i) {
        if (indices > kMostListed) return;
        lists[i] = listCell(q, cells[i]);
        indices += lists[i].indices.size();
    });
    BladeList out;
    if (indices > kMostListed) return out.tooMany = true, out;
    out.indices.reserve(indices);
    for (size_t i = 0; i < lists.size(); ++i) {
        const CellList& l = lists[i];
        if (l.blades == 0) continue;
        out.commands.push_back({static_cast<uint32_t>(l.indices.size()), 1, static_cast<uint32_t>(out.indices.size()),
                                0, static_cast<uint32_t>(i)});
        out.indices.insert(out.indices.end(), l.indices.begin(), l.indices.end());
        out.blades += l.blades;
    }
    return out;
}

}  // namespace sward
