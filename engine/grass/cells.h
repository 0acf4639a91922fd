// Which cells draw blades, and which of each cell's blades: the implicit quadtree, culled by frustum, distance and
// density. Source: Boulanger, Pattanaik and Bouatouch 2006, sections 3.4 and 4.1; Jahrmann and Wimmer 2013,
// section 6.1; B-12, B-23. Pure; nothing is stored per cell, but for the density of those in view. All decisions are
// formulas of numerics/cells.h, by which the GPU may choose the same cells (gpu_cells.h).
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "core/numerics.h"
#include "frame/draw_context.h"
#include "grass/density_ranges.h"
#include "scene/population.h"
#include "scene/technique.h"
#include "scene/unique.h"
#include "shared/grass.h"

namespace sward {

// One species' share of a cell: blades [first, last) of its patch, sorted by threshold.
struct CellDraw {
    int32_t cellX, cellZ;
    float x, z;               // the cell's corner relative to the eye
    glm::vec2 mirror, shift;  // numerics/population.h, CellVersion
    uint32_t first, last;
    int32_t segments;  // enough for this distance: no blade's strip leaves its curve by more than half a pixel
    int32_t seen;      // 1: its blades may be in view; 0: only their shadows
    float nearest;     // distance from the eye, metres
    int32_t whole;     // 1: all that its blades reach is in view
};

// As OpenGL's DrawElementsIndirectCommand.
struct DrawCommand {
    uint32_t count, instances, firstIndex;
    int32_t baseVertex;
    uint32_t baseInstance;
};
// Where the indices of strips with n quads begin, per blade of the patch: those with fewer stand before.
uint32_t firstStrip(int n);
// How many of a cell's blades are drawn at a detail in ]0, 1]: in the order of thresholds, a prefix is an even choice.
uint32_t bladesDrawn(const CellDraw& c, float detail);
// Draws a cell's blades with strips of n quads; `instance` is its place among the cells. strips: blades that the
// indices hold of each number of quads. verticesABlade: 0 if they hold all blades; else they are those of a cell's own
// blades, which begin at its first one's vertices.
DrawCommand drawCommand(const CellDraw& c, int quads, uint32_t strips, float detail, uint32_t instance,
                        uint32_t verticesABlade = 0);

// Quads of a shadow on the ground, at most; one would lose a quarter of its area.
inline constexpr int kShadowQuads = SHADOW_QUADS;
// The farthest that a blade's middle is from its chord, metres: |tip - 2 control| / 4.
float bladeSagitta(const Patch& patch);
// How far a species' blades rise above and reach beyond their cell, metres.
float bladeReach(const Species& species, const Patch& patch);

// How finely blades are tessellated (numerics/tess.h, tessMost).
struct BladeLevels {
    int smoothness = 0;     // the greatest level; 0: blades are not tessellated
    float maxDistance = 0;  // m
    float quadsAtOneMetre =
        0;            // quads of the tallest blade in the middle of the picture at 1 m; 0: the distance decides
    float reach = 0;  // of a blade from its root, m
};

// Blades that no distance thins.
inline constexpr f32::Thinning kAllBlades{0, 1e30f};

struct CellQuery {
    const Terrain& terrain;
    const HeightBounds& bounds;
    const Map* density;  // null: 1 everywhere
    Tiling densityTiling;
    const Patch& patch;
    double cellSize;
    float reach;           // bladeReach
    float sagitta;         // bladeSagitta
    FadeRange range;       // where blades are drawn one by one
    float fade;            // omega
    uint32_t seed;         // the field's
    uint32_t sowSeed;      // sowingSeed
    int segments;          // the species': the most that are drawn
    float pixelsPerMetre;  // at a distance of 1 m
    glm::dvec3 eye;        // relative to the terrain's corner
    const Frustum& frustum;
    f32::Thinning thinning = kAllBlades;
    BladeLevels levels{};  // where blades are tessellated: CellDraw.segments is then the greatest level in the cell
    const UniqueBlades* unique =
        nullptr;  // each cell's own blades, of which `patch` is then all: CellDraw's first and last are theirs
    float shadow =
        0;  // how far shadows on the ground reach beyond `reach`: cells of which only those are seen count too
    DensityRanges* ranges = nullptr;  // of `density`, where they are kept
};
// What a cell query is of: a species of a field, as it is drawn (scene/technique.h), over ground.
struct QueryOf {
    const Terrain& terrain;
    const HeightBounds& bounds;
    const GrassField& field;
    const Species& species;
    const Patch& patch;
    FadeRange blades;  // FieldTiers::blades
    float fade;        // GrassDrawing::fade
};
// The eye's and the view's part of a query.
struct QueryFrom {
    glm::dvec3 eye;  // relative to the terrain's corner
    const Frustum& frustum;
    float pixelsPerMetre;  // at a distance of 1 m
};
CellQuery cellQuery(const QueryOf& of, const QueryFrom& from);

// A node of f32::kNodeSide x kNodeSide cells of which some may be chosen: where its first cell is, and between which
// heights relative to the eye its ground lies.
struct CellNode {
    int32_t x, z;
    float low, high;
};
f32::CellGrid cellGrid(const CellQuery& q);
f32::CellRule cellRule(const CellQuery& q);
// A cell's chance (numerics/sowing.h), and the threshold that a blade of the patch has there.
float chanceOf(const CellQuery& q, int x, int z);
float thresholdIn(const CellQuery& q, const CellDraw& c, const Blade& b);
// Whether the GPU knows how to choose these cells: not blades of each cell's own, nor by a density map that repeats.
bool gpuMayChoose(const CellQuery& q);
// Cells along x and z of the whole field.
glm::ivec2 fieldCells(const CellQuery& q);
// Nodes that are in view and begin before the range's end, nearest first. `looked`, if given, counts the nodes that
// were looked at.
std::vector<CellNode> selectNodes(const CellQuery& q, uint64_t* looked = nullptr);
// What no cell of a node has more of: blades (at full detail) and quads a strip.
struct NodeBounds {
    uint32_t blades;
    int quads;
    float nearest;  // m
};
NodeBounds nodeBounds(const CellQuery& q, const CellNode& n);
// Of the density map, along x and z.
glm::vec2 texelsPerCell(const CellQuery& q);
// Cells node by node, each from the side of the eye (f32::nodeCell).
std::vector<CellDraw> selectCells(const CellQuery& q, uint64_t* looked = nullptr);

// A cell whose vertical slices are drawn.
struct SliceCell {
    int32_t cellX, cellZ;
    float x, z;               // the cell's corner relative to the eye
    glm::vec2 mirror, shift;  // numerics/population.h, CellVersion
};
// The cells that vertical slices are drawn for, nearest first: those that reach beyond `near` and begin before `far`
// (m).
std::vector<SliceCell> selectSliceCells(const CellQuery& q, float near, float far);

// Lowest and highest density that bilinear sampling can give over terrain-relative [x0, x1] x [z0, z1].
std::pair<float, float> densityRange(const Map& density, const Tiling& tiling, double x0, double z0, double x1,
                                     double z1);

// Blades of one species that a view draws: opacity above 0 and root within the frustum. The shader's own rule, on the
// CPU.
uint64_t countVisible(const CellQuery& q);

}  // namespace sward
