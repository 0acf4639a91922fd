#include "grass/gpu_cells.h"

namespace sward {
namespace {

constexpr uint32_t kCountEvery = 16;  // frames
constexpr uint32_t kCellsInNode = f32::kNodeSide * f32::kNodeSide;

bool isPlain(int quads, float nearest, const CellWish& w) { return quads == 1 && nearest > w.plainFrom; }

uint32_t piecesOf(uint32_t blades, const CellWish& w) { return (blades + w.pieceBlades - 1) / w.pieceBlades; }

void addBounds(ChosenCells& c, const CellWish& w, uint32_t cells, uint32_t blades, int quads, bool plain) {
    c.blades = std::max(c.blades, blades);
    c.pieces += static_cast<uint64_t>(cells) * piecesOf(blades, w);
    c.allBlades += static_cast<uint64_t>(cells) * blades;
    c.vertices += static_cast<uint64_t>(cells) * blades * (plain ? 3 : 2 * static_cast<uint64_t>(quads + 1));
}

uint32_t bitsOf(const CellDraw& c, const CellWish& w) {
    return bladesDrawn(c, w.detail) | static_cast<uint32_t>(c.segments) << CHOSEN_LEVEL |
           static_cast<uint32_t>(c.whole) << CHOSEN_WHOLE | static_cast<uint32_t>(c.seen) << CHOSEN_SEEN |
           (isPlain(c.segments, c.nearest, w) ? 1u : 0u) << CHOSEN_PLAIN;
}

void chooseHere(DrawContext& ctx, ChosenCells& c, const CellWish& w, const char* owner) {
    std::vector<ChosenCell> chosen;
    c.last = {};
    for (const CellDraw& d : selectCells(w.query)) {
        chosen.push_back({{d.cellX, d.cellZ}, d.first, bitsOf(d, w)});
        c.last.cells += d.seen ? 1 : 0;
        c.last.blades += d.seen ? bladesDrawn(d, w.detail) : 0;
        addBounds(c, w, 1, bladesDrawn(d, w.detail), d.segments, isPlain(d.segments, d.nearest, w));
    }
    c.count = static_cast<uint32_t>(chosen.size());
    writeBuffer(ctx.gpu, c.chosen, owner, chosen.size() * sizeof(ChosenCell), chosen.data());
    c.nodes = {}, c.upTo = {}, c.counts = {};
    c.counted.reset();
    c.upToOf = 0;
}

// Now and then, and where counts are to be this frame's; never while those of a frame before are still to be read.
bool countsNow(const ChosenCells& c, const ViewSettings& s) {
    return !c.counted && (countsThisFrame(s) || c.frame % kCountEvery == 0);
}

// Cells of a node that the field has.
uint32_t inField(const CellNode& n, const glm::ivec2& cells) {
    return static_cast<uint32_t>(std::min(f32::kNodeSide, cells.x - n.x) * std::min(f32::kNodeSide, cells.y - n.z));
}

void readCounts(ChosenCells& c) {
    glGetNamedBufferSubData(c.counts.id(), 0, sizeof(c.last), &c.last);
    c.counted.reset();
}

void nodesForGpu(DrawContext& ctx, ChosenCells& c, const CellWish& w, const char* owner) {
    static_assert(sizeof(CellNode) == sizeof(NodeOfCells));
    if (c.counted && (countsThisFrame(ctx.settings) || glClientWaitSync(c.counted.get(), 0, 0) != GL_TIMEOUT_EXPIRED))
        readCounts(c);
    if (!c.counts.id()) c.counts = makeBuffer(ctx.gpu, owner, sizeof(ChosenCounts), nullptr);
    const std::vector<CellNode> nodes = selectNodes(w.query);
    for (const CellNode& n : nodes) {
        const NodeBounds most = nodeBounds(w.query, n);
        addBounds(c, w, inField(n, fieldCells(w.query)),
                  static_cast<uint32_t>(
                      std::ceil(static_cast<float>(most.blades) * std::clamp(w.detail, kLeastDetail, 1.0f))),
                  most.quads, isPlain(most.quads, most.nearest, w));
    }
    c.count = static_cast<uint32_t>(nodes.size()) * kCellsInNode;
    writeBuffer(ctx.gpu, c.nodes, owner, nodes.size() * sizeof(CellNode), nodes.data());
    writeBuffer(ctx.gpu, c.chosen, owner, c.count * sizeof(ChosenCell), nullptr);
    if (c.upToOf == w.patchKey && c.upTo.id()) return;
    c.upToOf = w.patchKey;
    c.upTo = makeBuffer(ctx.gpu, owner, sizeof(w.query.patch.upTo), w.query.patch.upTo.data());
}

}  // namespace

CullGlobals cullGlobals(const CellWish& w) {
    const CellQuery& q = w.query;
    const f32::CellGrid grid = cellGrid(q);
    const f32::CellRule rule = cellRule(q);
    CullGlobals g{};
    for (size_t i = 0; i < 6; ++i) g.planes[i] = q.frustum.planes[i];
    g.eyeCell = grid.eyeCell, g.inCell = grid.inCell, g.edge = grid.edge, g.cellSize = grid.size;
    g.reach = q.reach;
    g.cells = fieldCells(q);
    g.farthest2 = std::min(q.range.max * q.range.max, 3e38f);
    g.shadowReach = q.shadow;
    g.fade = rule.fade, g.missing = rule.thinning.missing, g.allTo = rule.thinning.allTo, g.rangeMin = rule.rangeMin,
    g.rangeInv = rule.rangeInv;
    g.unspread = rule.unspread, g.unstep = rule.unstep, g.sowSeed = q.sowSeed;
    g.smoothness = static_cast<float>(q.levels.smoothness);
    g.maxDistance = q.levels.maxDistance;
    g.quadsAtOneMetre = q.levels.quadsAtOneMetre;
    g.levelReach = q.levels.reach;
    g.sagittaPixels = q.sagitta * q.pixelsPerMetre;
    g.mostQuads = q.segments;
    g.detail = std::clamp(w.detail, kLeastDetail, 1.0f);
    g.plainFrom = w.plainFrom;
    if (q.density) g.texels = texelsPerCell(q);
    g.seed = q.seed;
    g.pieceBlades = w.pieceBlades;
    g.drawn = w.drawn;
    g.unique = q.unique != nullptr;
    return g;
}

void chooseCells(DrawContext& ctx, ChosenCells& c, const CellWish& w, const char* owner) {
    c.byGpu = w.byGpu;
    c.patchBlades = static_cast<uint32_t>(w.query.patch.blades.size());
    c.blades = 0, c.vertices = 0, c.pieces = 0, c.allBlades = 0;
    if (c.byGpu)
        nodesForGpu(ctx, c, w, owner);
    else
        chooseHere(ctx, c, w, owner);
    CullGlobals globals = cullGlobals(w);
    c.counting = countsNow(c, ctx.settings);
    ++c.frame;
    globals.counts = c.counting;
    writeBuffer(ctx.gpu, c.globals, owner, sizeof(globals), &globals);
    ctx.stats.cells += c.last.cells;
    ctx.stats.bladesGeometry += c.last.blades;
}

void runChoice(ChosenCells& c, GLuint density) {
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_CULL, c.globals.id());
    if (!c.byGpu || c.count == 0) return glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_CHOSEN, c.chosen.id());
    if (density) glBindTextureUnit(TEX_DENSITY, density);
    if (c.counting) glClearNamedBufferData(c.counts.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    static_assert(SSBO_NODES == SSBO_COUNTS + 1 && SSBO_CHOSEN == SSBO_COUNTS + 2 && SSBO_UP_TO == SSBO_COUNTS + 3);
    const GLuint buffers[] = {c.counts.id(), c.nodes.id(), c.chosen.id(), c.upTo.id()};
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, SSBO_COUNTS, 4, buffers);
    glDispatchCompute(c.count / kCellsInNode, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    if (c.counting) c.counted.reset(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
}

bool countsThisFrame(const ViewSettings& s) { return s.measure || s.counted; }

void recount(DrawContext& ctx, ChosenCells& c) {
    if (!countsThisFrame(ctx.settings) || !c.byGpu || c.count == 0) return;
    const ChosenCounts before = c.last;
    readCounts(c);
    ctx.stats.cells = ctx.stats.cells + c.last.cells - before.cells;
    ctx.stats.bladesGeometry = ctx.stats.bladesGeometry + c.last.blades - before.blades;
}

}  // namespace sward
