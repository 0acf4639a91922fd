#include "grass/gpu_cells.h"

namespace sward {
namespace {

constexpr uint32_t kCellsInNode = f32::kNodeSide * f32::kNodeSide;

CullGlobals globalsOf(const CellWish& w) {
    const CellQuery& q = w.query;
    const f32::CellGrid grid = cellGrid(q);
    const f32::CellRule rule = cellRule(q);
    const glm::ivec2 cells = fieldCells(q);
    CullGlobals g;
    for (size_t i = 0; i < 6; ++i) g.planes[i] = q.frustum.planes[i];
    g.eye = glm::vec4(grid.eyeCell, grid.inCell);
    g.grid = {grid.edge, grid.size, q.reach};
    g.field = {static_cast<float>(cells.x), static_cast<float>(cells.y), std::min(q.range.max * q.range.max, 3e38f), q.shadow};
    g.rule = {rule.fade, rule.thinning, rule.rangeMin, rule.rangeInv};
    g.levels = {static_cast<float>(q.levels.smoothness), q.levels.maxDistance, q.levels.quadsAtOneMetre, q.levels.reach};
    g.strips = {q.sagitta * q.pixelsPerMetre, static_cast<float>(q.segments), std::clamp(w.detail, 0.01f, 1.0f), w.plainFrom};
    g.texels = {0, 0, static_cast<float>(q.seed), static_cast<float>(w.pieceBlades)};
    if (q.density) g.texels.x = texelsPerCell(q).x, g.texels.y = texelsPerCell(q).y;
    return g;
}

uint32_t piecesOf(uint32_t blades, const CellWish& w) { return (blades + w.pieceBlades - 1) / w.pieceBlades; }

void addBounds(ChosenCells& c, const CellWish& w, uint32_t cells, uint32_t blades, int quads) {
    c.blades = std::max(c.blades, blades);
    c.pieces += static_cast<uint64_t>(cells) * piecesOf(blades, w);
    c.vertices += static_cast<uint64_t>(cells) * blades * 2 * static_cast<uint64_t>(quads + 1);
}

uint32_t lookOf(const CellDraw& c, const CellWish& w) {
    const bool plain = c.segments == 1 && c.nearest > w.plainFrom;
    return bladesDrawn(c, w.detail) | static_cast<uint32_t>(c.segments) << CHOSEN_LEVEL | static_cast<uint32_t>(c.whole) << CHOSEN_WHOLE |
           static_cast<uint32_t>(c.seen) << CHOSEN_SEEN | (plain ? 1u : 0u) << CHOSEN_PLAIN;
}

void chooseHere(DrawContext& ctx, ChosenCells& c, const CellWish& w, const char* owner) {
    std::vector<ChosenCell> chosen;
    for (const CellDraw& d : selectCells(w.query)) {
        chosen.push_back({{d.cellX, d.cellZ}, d.first, lookOf(d, w)});
        addBounds(c, w, 1, bladesDrawn(d, w.detail), d.segments);
    }
    c.count = static_cast<uint32_t>(chosen.size());
    writeBuffer(ctx.gpu, c.chosen, owner, chosen.size() * sizeof(ChosenCell), chosen.data());
    c.nodes = {}, c.upTo = {};
    c.upToOf = 0;
}

void nodesForGpu(DrawContext& ctx, ChosenCells& c, const CellWish& w, const char* owner) {
    static_assert(sizeof(CellNode) == sizeof(NodeOfCells));
    const std::vector<CellNode> nodes = selectNodes(w.query);
    for (const CellNode& n : nodes) {
        const NodeBounds most = nodeBounds(w.query, n);
        addBounds(c, w, kCellsInNode, static_cast<uint32_t>(std::ceil(static_cast<float>(most.blades) * std::clamp(w.detail, 0.01f, 1.0f))), most.quads);
    }
    c.count = static_cast<uint32_t>(nodes.size()) * kCellsInNode;
    writeBuffer(ctx.gpu, c.nodes, owner, nodes.size() * sizeof(CellNode), nodes.data());
    writeBuffer(ctx.gpu, c.chosen, owner, c.count * sizeof(ChosenCell), nullptr);
    if (c.upToOf == w.patchKey && c.upTo.id()) return;
    c.upToOf = w.patchKey;
    c.upTo = makeBuffer(ctx.gpu, owner, sizeof(w.query.patch.upTo), w.query.patch.upTo.data());
}

}  // namespace

bool gpuChooses(const GrassField& field, const Gpu&) { return static_cast<Culling>(field.culling) != Culling::Cpu; }

void chooseCells(DrawContext& ctx, ChosenCells& c, const CellWish& w, const char* owner) {
    c.byGpu = gpuChooses(*firstOf<GrassField>(ctx.project), ctx.gpu);
    c.blades = 0, c.vertices = 0, c.pieces = 0;
    const CullGlobals globals = globalsOf(w);
    writeBuffer(ctx.gpu, c.globals, owner, sizeof(globals), &globals);
    if (c.byGpu) nodesForGpu(ctx, c, w, owner);
    else chooseHere(ctx, c, w, owner);
}

void runChoice(const ChosenCells& c, GLuint density) {
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_CULL, c.globals.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_CHOSEN, c.chosen.id());
    if (!c.byGpu || c.count == 0) return;
    if (density) glBindTextureUnit(TEX_DENSITY, density);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_NODES, c.nodes.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_UP_TO, c.upTo.id());
    glDispatchCompute(c.count / kCellsInNode, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace sward
