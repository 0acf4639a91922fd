#include "forest/volume_bake.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "core/numerics.h"
#include "forest/leaf_depth.h"
#include "forest/stretch.h"

namespace sward {
namespace {

constexpr double kSplatShare = 0.5;  // of a bake's time
constexpr int kMostAlong = 64;       // points along an edge: leaves of enormous trees would take minutes
constexpr EdgeFamily kFamilies[] = {EdgeFamily::Row, EdgeFamily::Slant, EdgeFamily::Across};

glm::dvec2 metres(double u, double v, double edge) {
    const f64::vec2 at = f64::fromLattice({u, v}, edge);
    return {at.x, at.y};
}

struct Splat {
    ForestVolume& volume;
    std::vector<glm::vec4> sums;  // reflectance times area, and area (m2, half of the leaves': what is seen of them)

    size_t at(int u, int v, int layer) const {
        return (static_cast<size_t>(layer) * static_cast<size_t>(volume.side) + static_cast<size_t>(v)) *
                   static_cast<size_t>(volume.side) +
               static_cast<size_t>(u);
    }
    void point(const glm::dvec3& p, const glm::vec3& color, double area) {
        const f64::vec2 uv = f64::toLattice({p.x, p.z}, volume.edge);
        const auto wrap = [&](double x) {
            const int texel = static_cast<int>(std::floor(x / volume.cells * volume.side));
            return ((texel % volume.side) + volume.side) % volume.side;
        };
        const int layer = std::clamp(static_cast<int>(p.y / volume.height * volume.layers), 0, volume.layers - 1);
        const float seen = static_cast<float>(0.5 * area);
        sums[at(wrap(uv.x), wrap(uv.y), layer)] += glm::vec4(color * seen, seen);
    }
};
// Calls point(place, area) for points spread over a triangle, each for its share of the area.
template <class F>
void spread(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double spacing, F point) {
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    const int n = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, kMostAlong);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 2 * i + 1; ++k) {
            // Middles of the n * n equal triangles.
            const double third = k % 2 ? 2.0 / 3 : 1.0 / 3;
            const double s = (n - i - 1 + third) / n, t = (k / 2 + third) / n;
            point(a * s + b * t + c * (1 - s - t), area / (n * n));
        }
}

glm::vec3 imageAt(const MeshImage& image, const glm::vec2& uv, float& alpha) {
    const auto texel = [](float x, int n) {
        return std::clamp(static_cast<int>((x - std::floor(x)) * static_cast<float>(n)), 0, n - 1);
    };
    const uint8_t* p =
        &image.rgba[4 * static_cast<size_t>(texel(uv.y, image.height) * image.width + texel(uv.x, image.width))];
    alpha = static_cast<float>(p[3]) / 255;
    return f32::srgbDecode3(
        {static_cast<float>(p[0]) / 255, static_cast<float>(p[1]) / 255, static_cast<float>(p[2]) / 255});
}

// Calls body(tree, foot) for each tree of the cells that repeat: those within tiles once, those across edges at each of
// them.
template <class F>
void eachStored(const ForestTiles& tiles, F body) {
    for (int cell = 0; cell < tiles.cells(); ++cell) {
        const glm::dvec2 corner = metres(cell % tiles.colors, cell / tiles.colors, tiles.edge);
        const ForestTile up = storedTile(cell, true, tiles.colors);
        for (const bool side : {false, true})
            for (const TileTree& t : tiles.within(cell, side)) body(t, corner + t.at);
        for (const EdgeFamily f : kFamilies)
            for (const TileTree& t : tiles.across(f, up.colors[static_cast<size_t>(f)])) body(t, corner + t.at);
    }
}

// The number in its tile's list of the tree that stands nearest to a place.
uint8_t nearestSlot(const ForestTiles& tiles, double u, double v) {
    const int x = static_cast<int>(u), y = static_cast<int>(v);
    const ForestTile tile = storedTile(x + tiles.colors * y, u - x + v - y <= 1, tiles.colors);
    const glm::dvec2 at = metres(u - x, v - y, tiles.edge);
    double least = 1e30;
    uint8_t best = 255;
    const auto look = [&](const std::vector<TileTree>& list, const glm::dvec2& shift, int first) {
        for (size_t k = 0; k < list.size(); ++k) {
            const double d = glm::distance(list[k].at + shift, at);
            if (d < least) least = d, best = static_cast<uint8_t>(first + static_cast<int>(k));
        }
    };
    look(tiles.within(tile.cell, tile.up), {}, 0);
    for (const EdgeFamily f : kFamilies) {
        const glm::ivec2 owner = edgeOwner(0, 0, tile.up, f);
        look(tiles.across(f, tile.colors[static_cast<size_t>(f)]), metres(owner.x, owner.y, tiles.edge), firstSlot(f));
    }
    return best;
}

void fillSlots(ForestVolume& v, const ForestTiles& tiles) {
    v.slots.resize(static_cast<size_t>(v.side) * static_cast<size_t>(v.side));
    parallelFor(static_cast<size_t>(v.side), [&](size_t y) {
        for (int x = 0; x < v.side; ++x)
            v.slots[y * static_cast<size_t>(v.side) + static_cast<size_t>(x)] =
                nearestSlot(tiles, v.cells * (x + 0.5) / v.side, v.cells * (static_cast<double>(y) + 0.5) / v.side);
    });
}

void fillLevels(ForestVolume& v, const std::vector<glm::vec4>& sums) {
    const double area = v.texel() * v.texel() * 0.8660254037844386;
    std::vector<glm::vec4>& finest = v.levels.emplace_back(sums.size());
    for (size_t i = 0; i < sums.size(); ++i) {
        if (!(sums[i].w > 0)) continue;
        const float alpha = f32::oneMinusExp(-sums[i].w / static_cast<float>(area));  // extinction times the slab
        finest[i] = glm::vec4(glm::vec3(sums[i]) / sums[i].w * alpha, alpha);
    }
    const size_t slab = static_cast<size_t>(v.side) * static_cast<size_t>(v.side);
    for (int layers = v.layers / 2; layers > 0; layers /= 2) {
        const std::vector<glm::vec4>& below = v.levels.back();
        std::vector<glm::vec4> level(static_cast<size_t>(layers) * slab);
        parallelFor(static_cast<size_t>(layers), [&](size_t l) {
            for (size_t i = 0; i < slab; ++i) {
                const glm::vec4 low = below[2 * l * slab + i], high = below[(2 * l + 1) * slab + i];
                level[l * slab + i] = high + low * (1 - high.w);
            }
        });
        v.levels.push_back(std::move(level));
    }
}

// Where the tree of a slot of the tile at lattice coordinates uv has its foot, in metres.
glm::dvec2 storedFoot(const ForestTiles& tiles, const glm::dvec2& uv, int slot) {
    const int x = static_cast<int>(uv.x), y = static_cast<int>(uv.y);
    const bool up = uv.x - x + uv.y - y <= 1;
    const glm::dvec2 corner = metres(x, y, tiles.edge);
    if (slot < kMostInside) return corner + tiles.within(x + tiles.colors * y, up)[static_cast<size_t>(slot)].at;
    const int family = (slot - kMostInside) / kMostOnEdge, number = (slot - kMostInside) % kMostOnEdge;
    const EdgeFamily f = static_cast<EdgeFamily>(family);
    const int color = storedTile(x + tiles.colors * y, up, tiles.colors).colors[static_cast<size_t>(family)];
    const glm::ivec2 owner = edgeOwner(0, 0, up, f);
    return corner + metres(owner.x, owner.y, tiles.edge) + tiles.across(f, color)[static_cast<size_t>(number)].at;
}

ForestAir airOf(const ForestVolume& v, const std::vector<glm::vec4>& sums) {
    ForestAir a{
        std::max(v.side / kLightCoarser, 1), std::max(v.layers / kLightCoarser, 1), v.edge, v.height, {}, v.cells};
    const int across = v.side / a.side, up = v.layers / a.layers;
    const double area = v.texel() * v.texel() * 0.8660254037844386, part = v.height / a.layers;
    const size_t side = static_cast<size_t>(v.side);
    for (int layer = 0; layer < a.layers; ++layer)
        for (int y = 0; y < a.side; ++y)
            for (int x = 0; x < a.side; ++x) {
                const double depth = clumpedDepth(across, up, [&](int i, int k, int l) {
                    const size_t texel =
                        static_cast<size_t>(y * across + k) * side + static_cast<size_t>(x * across + i);
                    return static_cast<double>(sums[static_cast<size_t>(layer * up + l) * side * side + texel].w) /
                           area;
                });
                a.extinction.push_back(static_cast<float>(depth / part));
            }
    return a;
}

// The air by every texel of the volume.
ForestAir fineAir(const ForestVolume& v, const std::vector<glm::vec4>& sums) {
    ForestAir a{v.side, v.layers, v.edge, v.height, std::vector<float>(sums.size()), v.cells, v.air.facing};
    const double part = v.texel() * v.texel() * 0.8660254037844386 * v.height / v.layers;
    for (size_t i = 0; i < sums.size(); ++i) a.extinction[i] = sums[i].w / static_cast<float>(part);
    return a;
}

// By u and v of the air: the number of the tree that its middle belongs to, by where that tree's foot lies.
std::vector<uint16_t> ownersOf(const ForestVolume& v, const ForestTiles& tiles) {
    std::map<std::pair<int64_t, int64_t>, uint16_t> numbers;
    std::vector<uint16_t> out;
    const int side = v.air.side, across = v.side / side;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int tx = x * across + across / 2, ty = y * across + across / 2;
            const uint8_t slot =
                v.slots[static_cast<size_t>(ty) * static_cast<size_t>(v.side) + static_cast<size_t>(tx)];
            const glm::dvec2 uv = (glm::dvec2(tx, ty) + 0.5) * (static_cast<double>(v.cells) / v.side);
            std::pair<int64_t, int64_t> foot{0, 0};
            if (slot < kTreeSlots) {
                const glm::dvec2 at = storedFoot(tiles, uv, slot);
                foot = {std::llround(at.x * 1000), std::llround(at.y * 1000)};
            }
            out.push_back(numbers.emplace(foot, static_cast<uint16_t>(numbers.size())).first->second);
        }
    return out;
}

// Of all trees of the tiles, by the area of their leaves.
Facing facingOfAll(const ForestTiles& tiles, const std::vector<Mesh>& meshes) {
    std::vector<double> areas(meshes.size());
    for (size_t i = 0; i < meshes.size(); ++i)
        spreadPoints(meshes[i], glm::dmat3(1), 1e9,
                     [&](const glm::dvec3&, const glm::vec3&, double a) { areas[i] += a; });
    std::vector<double> shares(meshes.size());
    double all = 0;
    eachStored(tiles, [&](const TileTree& t, const glm::dvec2&) {
        const double area = areas[t.species] * static_cast<double>(t.size * t.size);
        shares[t.species] += area, all += area;
    });
    if (!(all > 0)) return evenFacing();
    Facing out{};
    for (size_t i = 0; i < meshes.size(); ++i) {
        const Facing f = facingOf(meshes[i]);
        for (size_t b = 0; b < f.size(); ++b) out[b] += static_cast<float>(shares[i] / all) * f[b];
    }
    return out;
}

// Optical depths on a way out of the air: through the part's own tree, and through the others.
struct Depths {
    double own = 0, others = 0;
};
// Calls body(part, depths) for each part of the air, on many threads. steeper: as in lightPastOthers.
template <class F>
void eachPart(const ForestAir& air, const glm::dvec3& towards, double steeper, F body) {
    glm::dvec3 way = towards;
    if (std::abs(way.y) < 0.01) way.y = way.y < 0 ? -0.01 : 0.01;
    way = glm::normalize(way);
    const double part = air.height / air.layers, across = air.cells * air.edge / air.side;
    const double step = 0.5 * std::min(part, across), rise = way.y * steeper;
    const f64::vec2 perMetre = f64::toLattice({way.x, way.z}, air.edge);
    const double seen = static_cast<double>(seenFrom(air.facing, static_cast<float>(way.y)));
    const size_t slab = static_cast<size_t>(air.side) * static_cast<size_t>(air.side);
    const auto wrap = [&](double x) {
        const int i = static_cast<int>(std::floor(x / air.cells * air.side));
        return static_cast<size_t>(((i % air.side) + air.side) % air.side);
    };
    const auto owner = [&](size_t i) { return air.owners.empty() ? 0 : air.owners[i]; };
    parallelFor(static_cast<size_t>(air.layers), [&](size_t layer) {
        size_t i = layer * slab;
        for (int y = 0; y < air.side; ++y)
            for (int x = 0; x < air.side; ++x, ++i) {
                const double u = air.cells * (x + 0.5) / air.side, v = air.cells * (y + 0.5) / air.side;
                const double h = (static_cast<double>(layer) + 0.5) * part;
                const int mine = owner(i % slab);
                Depths d;
                for (double t = 0.5 * step; d.own + d.others < 7; t += step) {
                    const int l = static_cast<int>(std::floor((h + rise * t) / part));
                    if (l < 0 || l >= air.layers) break;
                    const size_t c =
                        wrap(v + perMetre.y * t) * static_cast<size_t>(air.side) + wrap(u + perMetre.x * t);
                    (owner(c) == mine ? d.own : d.others) +=
                        seen * step * static_cast<double>(air.extinction[static_cast<size_t>(l) * slab + c]);
                }
                body(i, d);
            }
    });
}

}  // namespace

void spreadPoints(const Mesh& mesh, const glm::dmat3& turn, double spacing,
                  const std::function<void(const glm::dvec3&, const glm::vec3&, double)>& point) {
    std::vector<glm::dvec3> at;
    for (const MeshVertex& v : mesh.vertices) at.push_back(turn * glm::dvec3(v.position));
    const std::vector<float> shares = leafShares(mesh);
    for (const MeshPart& part : mesh.parts)
        for (uint32_t i = part.first; i + 2 < part.first + part.count; i += 3) {
            const uint32_t* t = &mesh.indices[i];
            glm::vec3 color = part.color;
            if (part.image >= 0) {
                float alpha = 1;
                const glm::vec2 uv = (mesh.vertices[t[0]].uv + mesh.vertices[t[1]].uv + mesh.vertices[t[2]].uv) / 3.0f;
                color *= imageAt(mesh.images[static_cast<size_t>(part.image)], uv, alpha);
                if (alpha < part.cutoff) continue;
            }
            const double share = static_cast<double>(shares[i / 3]);
            spread(at[t[0]], at[t[1]], at[t[2]], spacing,
                   [&](const glm::dvec3& p, double area) { point(p, color, share * area); });
        }
}

ForestVolume bakeForest(const ForestTiles& tiles, const std::vector<Mesh>& meshes, double voxel, JobControl* control) {
    ForestVolume v;
    v.edge = tiles.edge;
    v.cells = tiles.colors;
    v.height = std::max(static_cast<double>(tiles.highest), 0.1);
    const int wanted = static_cast<int>(std::ceil(v.cells * tiles.edge / voxel / kLightCoarser)) * kLightCoarser;
    v.side = std::clamp(wanted, kLightCoarser, kMostVolumeSide);
    v.layers = static_cast<int>(std::bit_ceil(static_cast<unsigned>(
        std::clamp(std::ceil(v.height / voxel), double(kLightCoarser), double(kMostVolumeLayers)))));
    Splat splat{v, {}};
    splat.sums.resize(static_cast<size_t>(v.side) * static_cast<size_t>(v.side) * static_cast<size_t>(v.layers));
    const double spacing = 0.5 * std::min(v.texel(), v.height / v.layers);
    double done = 0;
    eachStored(tiles, [&](const TileTree& t, const glm::dvec2& foot) {
        if (meshes[t.species].parts.empty() || (control && control->cancelled())) return;
        spreadPoints(meshes[t.species], turnOf(StandingTree{{}, t.species, t.size, t.headingDeg, {}, 0}), spacing,
                     [&](const glm::dvec3& p, const glm::vec3& color, double area) {
                         splat.point(p + glm::dvec3(foot.x, 0, foot.y), color, area);
                     });
        if (control) control->setProgress(kSplatShare * ++done / std::max(tiles.placed, 1.0));
    });
    fillLevels(v, splat.sums);
    fillSlots(v, tiles);
    v.air = airOf(v, splat.sums);
    v.air.owners = ownersOf(v, tiles);
    v.air.facing = facingOfAll(tiles, meshes);
    LeafDepths depths = leafDepths(fineAir(v, splat.sums), v.air);
    v.air.deeper = std::move(depths.deeper), v.air.litSeen = depths.litSeen;
    return v;
}

LightShares lightThrough(const ForestAir& air, const glm::dvec3& towards) {
    LightShares out{std::vector<float>(air.extinction.size()), std::vector<float>(air.extinction.size())};
    eachPart(air, towards, 1, [&](size_t i, const Depths& d) {
        out.past[i] = static_cast<float>(std::exp(-d.own - d.others));
        out.pastOwn[i] = static_cast<float>(std::exp(-d.own));
    });
    return out;
}

std::vector<float> lightPastOthers(const ForestAir& air, const glm::dvec3& towards, double steeper) {
    std::vector<float> out(air.extinction.size());
    eachPart(air, towards, steeper,
             [&](size_t i, const Depths& d) { out[i] = static_cast<float>(std::exp(-d.others)); });
    return out;
}

std::array<std::vector<float>, 2> skyThrough(const ForestAir& air, double verticalScale) {
    constexpr int kDirections = 24;  // on each half
    std::array<std::vector<float>, 2> out;
    for (size_t half = 0; half < 2; ++half) {
        out[half].assign(air.extinction.size(), 0);
        for (int k = 0; k < kDirections; ++k) {
            const double y = (k + 0.5) / kDirections, turn = k * 2.399963229728653, r = std::sqrt(1 - y * y);
            const glm::dvec3 way(r * std::cos(turn), half == 0 ? y : -y, r * std::sin(turn));
            const std::vector<float> seen = lightThrough(air, bakedWay(way, verticalScale)).past;
            for (size_t i = 0; i < seen.size(); ++i) out[half][i] += seen[i] / kDirections;
        }
    }
    return out;
}

}  // namespace sward
