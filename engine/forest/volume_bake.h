// A forest's tiles as a volume: what fills each part of the air over the cells that repeat (Decaudin and
// Neyret 2004, sections 4 and 5), from the very meshes that are drawn near the eye. Stored is what leaves are, not how
// they are lit: premultiplied reflectance and opacity. Opacity follows from the leaves' area in a part by Beer's law,
// as of leaves in all directions. A pyramid joins slabs by pairs, in float, each level from the one below (D-7). Does
// not: touch GL or files. Cost: 1 us a leaf, 0.1 s for a million parts.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/jobs.h"
#include "mesh/facing.h"
#include "mesh/mesh.h"
#include "world/forest_stand.h"

namespace sward {

inline constexpr int kMostVolumeSide = 512, kMostVolumeLayers = 128;
inline constexpr int kLightCoarser = 4;  // parts of light are so many times larger along each axis

// Opacity (1/m) over the cells that repeat, on a grid coarser than the volume's: what light goes through.
struct ForestAir {
    int side = 1, layers = 1;        // parts along u and v, and upwards
    double edge = 1, height = 1;     // metres, of a cell and of all parts
    std::vector<float> extinction;   // u fastest, then v, then upwards; of leaves that lie in all directions
    int cells = 2;                   // along each side
    Facing facing = evenFacing();    // of all that it holds
    std::vector<uint16_t> owners{};  // by u and v: another number for another tree; empty: one owns all
    // Optical depth by which leaves of a part lie deeper than its middle (leaf_depth.h); empty: none does.
    std::vector<float> deeper{};
    // Of the leaves of a part that are seen from a side, how many more are lit from that side than of all: a logarithm.
    float litSeen = 0;
    // Of the light in the middle of a part, the share that its leaves get; above 1 where they lie before it.
    float leavesGet(size_t part) const { return deeper.empty() ? 1 : std::exp(-deeper[part]); }
};
struct ForestVolume {
    int side = 0, layers = 0;                             // texels along u and v of all cells; slabs, a power of two
    int cells = 2;                                        // along each side
    double edge = 0;                                      // metres of a cell's edge
    double height = 0;                                    // metres that all slabs reach
    double texel() const { return cells * edge / side; }  // metres
    // By level; level l has layers >> l slabs of side x side texels, the lowest first; premultiplied.
    std::vector<std::vector<glm::vec4>> levels;
    std::vector<uint8_t> slots;  // side x side: where its tile's list has the tree that a texel belongs to; 255: none
    ForestAir air;
};
// meshes: by species; empty ones are left out. voxel: metres, taken larger where the volume would exceed its limits.
// control, if given, is told how far it is and may end it early; the volume is then not whole.
ForestVolume bakeForest(const ForestTiles& tiles, const std::vector<Mesh>& meshes, double voxel,
                        JobControl* control = nullptr);

// What a part of across x across columns of `up` texels takes of light along them, as an optical depth: the mean is
// over what columns let through, which leaves in clumps make less than leaves that are spread. depth(i, k, l): a
// texel's.
template <class F>
double clumpedDepth(int across, int up, F depth) {
    double through = 0;
    for (int k = 0; k < across; ++k)
        for (int i = 0; i < across; ++i) {
            double sum = 0;
            for (int l = 0; l < up; ++l) sum += depth(i, k, l);
            through += std::exp(-sum) / (across * across);
        }
    return -std::log(std::max(through, 1e-9));
}

// Calls point(place, reflectance, area) for points spread over a mesh's triangles, at most `spacing` metres apart, each
// for its share of their area (m2), counted as of leaves (mesh/facing.h): of a trunk half of it; what an image's alpha
// cuts out is left out.
void spreadPoints(const Mesh& mesh, const glm::dmat3& turn, double spacing,
                  const std::function<void(const glm::dvec3&, const glm::vec3&, double)>& point);

// Shares of light that reach each part of the air: past all that it holds, and past the part's own tree alone.
struct LightShares {
    std::vector<float> past, pastOwn;
};
// From a direction (unit, y up, above the horizon or below); where it is level it is taken to rise by a hundredth.
LightShares lightThrough(const ForestAir& air, const glm::dvec3& towards);
// Of a direction above the horizon, past all but the part's own tree, on a slope: its ground bears all trees up with
// it, so that light comes through the others' air as if it came down so many times as steeply (steeper, above 0),
// though by a way as long. At 1: what is past divided by what is past the own tree.
std::vector<float> lightPastOthers(const ForestAir& air, const glm::dvec3& towards, double steeper);
// Shares of the sky's light, and of the ground's, that reach each part: means over directions above and below.
// verticalScale: Forest's, by which the air is stretched.
std::array<std::vector<float>, 2> skyThrough(const ForestAir& air, double verticalScale = 1);

}  // namespace sward
