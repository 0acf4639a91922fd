#include "grass/mesh_geometry.h"

#include <glm/gtc/packing.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/log.h"
#include "frame/draw_context.h"
#include "frame/object_light.h"
#include "grass/blade_list.h"
#include "grass/field.h"
#include "grass/mesh_planting.h"
#include "grass/on_mesh.h"
#include "mesh/mesh_io.h"
#include "shared/grass.h"
#include "world/placement.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/mesh-geometry";
constexpr size_t kPiece = 256;  // blades that are drawn or left out together

// Blades that stand side by side on a mesh; lengths are the mesh's.
struct MeshPiece {
    size_t first = 0, count = 0;                    // of the roots
    glm::vec3 low{1e30f}, high{-1e30f}, normal{0};  // of the roots
    float bend = 0;                                 // the most of them, away from the eye
    std::vector<float> chances = {};                // of its blades, ascending
    bool edged = false;                             // some stand on a part of the surface that has an edge
    float leastFacing = 1;                          // cosine that a root's normal has with the mean, at least
};
// One species on a mesh.
struct PlantedKind {
    Buffer roots;
    std::vector<MeshPiece> pieces;
};
// What a mesh's blades are planted by, but for the map of their density.
struct PlantedBy {
    std::string file, version, field;  // version: of the file, as it was read
    float uvLength = 0, scale = 0, cellSize = 0;
    int seed = 0;
    std::vector<uint64_t> patches;  // patchKey by species
    bool operator==(const PlantedBy&) const = default;
};
struct PlantedMesh {
    PlantedBy by;
    Map density;
    double uvLength = 0;  // metres that one unit of texture coordinates is
    std::vector<PlantedKind> kinds;
};
// Blades of a species' patch as the GPU holds them, and strips over those of a piece.
struct PatchMesh {
    uint64_t key = 0;  // patchKey
    int segments = 0;
    Buffer blades, indices;
};
struct PlantedMeshes : EffectState {
    std::map<std::string, PlantedMesh> meshes;  // by their entities' names
    PerSpecies<PatchMesh> patches;
};
// A species on a mesh that this view draws.
struct KindDraw {
    const Field* field;
    size_t species;
    const PlantedKind* planted;
    const PatchMesh* patch;
    MeshPlace place;
    MeshMaps maps;
    float uvLength;
    uint32_t firstLight;                                    // number of the mesh's first vertex (frame/object_light.h)
    std::map<int, std::vector<DrawCommand>> commands = {};  // by quads of the strips
};
struct MeshGeometryView : EffectState {
    std::vector<KindDraw> draws;
    Buffer commands;
    VertexArray vertices;
};

// --- planting --------------------------------------------------------------------------------------------------------
MeshBladeRoot packed(const MeshRoot& r) {
    const glm::vec3 n(glm::normalize(r.normal));
    const CarrierFrame f = carrierFrame(n, glm::vec3(r.alongU), glm::vec3(r.alongV));
    const glm::vec3 across = glm::cross(f.tangent, n);
    const glm::quat q = glm::normalize(glm::quat_cast(glm::mat3(f.tangent, n, across)));
    MeshBladeRoot out{};
    out.position = glm::vec3(r.position);
    out.blade = r.blade | (glm::dot(across, f.bitangent) < 0 ? MIRRORED_ROOT : 0);
    out.turn = {glm::packSnorm2x16({q.x, q.y}), glm::packSnorm2x16({q.z, q.w})};
    const glm::vec3 bend = glm::clamp(glm::vec3(r.bend), -6e4f, 6e4f);
    out.bend = {glm::packHalf2x16({bend.x, bend.y}), glm::packHalf2x16({bend.z, r.density})};
    out.uv = r.uv;
    out.cell = {r.cellX, r.cellZ};
    out.corners = {r.corners[0], r.corners[1], r.corners[2], glm::packUnorm2x16(r.weights)};
    return out;
}

// A blade to be sorted into a piece.
struct Rooted {
    MeshBladeRoot root;
    glm::vec3 normal;
    float bend, chance;
    bool edged;
};
// Neighbours are planted one after another. Within a piece in the order of the chances by which distance thins them.
MeshPiece pieceOf(std::span<Rooted> blades, size_t first) {
    std::stable_sort(blades.begin(), blades.end(),
                     [](const Rooted& a, const Rooted& b) { return a.chance < b.chance; });
    MeshPiece p{first, blades.size()};
    for (const Rooted& r : blades) {
        p.low = glm::min(p.low, r.root.position), p.high = glm::max(p.high, r.root.position);
        p.normal += r.normal, p.bend = std::max(p.bend, r.bend);
        p.edged = p.edged || r.edged;
    }
    p.normal /= std::max(glm::length(p.normal), 1e-6f);
    for (const Rooted& r : blades) p.chances.push_back(r.chance);
    for (const Rooted& r : blades) p.leastFacing = std::min(p.leastFacing, glm::dot(p.normal, r.normal));
    return p;
}

float chanceOf(const MeshRoot& r, const Patch& patch) {
    return f32::shadowChance(std::bit_cast<uint32_t>(patch.blades[r.blade].dither), r.cellX, r.cellZ);
}
PlantedKind plantKind(DrawContext& ctx, const MeshPlanting& p, std::span<const CellPart> cells, const Species& species,
                      const Patch& patch) {
    PlantedKind out;
    std::vector<Rooted> blades;
    plantOn(p, cells, species, patch, JobControl{}, [&](const MeshRoot& r) {
        const double most = std::max(std::abs(r.bend.x), std::abs(r.bend.z)) + std::abs(r.bend.y);
        blades.push_back(
            {packed(r), glm::vec3(glm::normalize(r.normal)), static_cast<float>(most), chanceOf(r, patch), r.edged});
    });
    for (size_t first = 0; first < blades.size(); first += kPiece)
        out.pieces.push_back(pieceOf(std::span(blades).subspan(first, std::min(kPiece, blades.size() - first)), first));
    std::vector<MeshBladeRoot> roots;
    roots.reserve(blades.size());
    for (const Rooted& b : blades) roots.push_back(b.root);
    if (!roots.empty()) out.roots = makeBuffer(ctx.gpu, kOwner, roots.size() * sizeof(MeshBladeRoot), roots.data());
    return out;
}

PlantedBy plantedBy(const DrawContext& ctx, const GrassyMesh& on, const Field& field, const StaticMesh& mesh) {
    const GrassField& grows = field.grown->grows();
    PlantedBy by{mesh.file,  fileVersion(ctx.project.dir, mesh.file),
                 on.field,   on.grows->uvLength,
                 mesh.scale, grows.cellSize,
                 grows.seed, {}};
    for (const FieldSpecies& s : field.species) by.patches.push_back(s.grown->key);
    return by;
}
bool isPlanted(const PlantedMesh& m, const PlantedBy& by, const Map& density) {
    return m.by == by && m.density.sameTiles(density);
}

// On a mesh that can be read and carry grass; else nothing is planted, which grass/mesh-grass tells.
void plant(DrawContext& ctx, PlantedMesh& m, const GrassyMesh& on, const Field& field) {
    m.kinds.clear();
    const Result<Mesh> read = readMesh(ctx.project.dir, m.by.file);
    if (!read) return;
    const MeshCarrier carrier = carrierOf(*read);
    if (carrier.surface == 0) return;
    m.uvLength = uvLengthOf(*on.grows, carrier, static_cast<double>(m.by.scale));
    const MeshPlanting planting{carrier, on, field.grown->grows(), m.uvLength};
    if (const double asked = bladesAsked(planting); asked > kMostDrawnOnMesh)
        return logWarning(
            fmt::format("{}.MeshGrass: {:.1f} million blades would stand there: above {:.0f} million they "
                        "are drawn by rays alone",
                        on.name, asked / 1e6, kMostDrawnOnMesh / 1e6));
    const auto cells = cellsOf(planting);
    if (!cells) return logWarning(cells.error().text() + "; until then no blade is drawn there where it is near");
    for (size_t i = 0; i < field.species.size(); ++i)
        m.kinds.push_back(
            plantKind(ctx, planting, *cells, field.grown->grows().species[i], field.species[i].grown->patch));
}

// Strips of 1, 2... quads of a piece's blades.
std::vector<uint32_t> pieceIndices(int segments) {
    std::vector<uint32_t> out;
    for (int n = 1; n <= segments; ++n)
        for (size_t b = 0; b < kPiece; ++b) addStrip(out, static_cast<uint32_t>(b), n, segments);
    return out;
}
void updatePatch(DrawContext& ctx, PatchMesh& m, const GrownSpecies& species, int segments) {
    if (m.key == species.key && m.segments == segments && m.blades.id()) return;
    m.key = species.key, m.segments = segments;
    const std::vector<Blade>& blades = species.patch.blades;
    const auto indices = pieceIndices(segments);
    m.blades = makeBuffer(ctx.gpu, kOwner, blades.size() * sizeof(Blade), blades.data());
    m.indices = makeBuffer(ctx.gpu, kOwner, indices.size() * 4, indices.data());
}

// --- what a view draws ---------------------------------------------------------------------------------------------
// Whether blades of a piece may be seen past the surface on which they stand: one that looks away from the eye shows
// them only where it bends so that they look over it, or ends.
bool looksHere(const MeshPiece& p, const MeshPlace& place, const glm::vec3& centre, float radius, float height) {
    const float distance = glm::length(centre);
    if (p.edged || distance <= radius) return true;
    const float away = std::acos(std::clamp(glm::dot(place.turned(p.normal), -centre / distance), -1.0f, 1.0f)),
                spread = std::acos(std::clamp(p.leastFacing, -1.0f, 1.0f)) + std::asin(radius / distance);
    return std::cos(std::max(away - spread, 0.0f)) > -(0.2f + std::sqrt(2 * height * p.bend / place.scale));
}

// As many of a piece's blades as some are wide enough for (numerics/shadow.h), at this distance.
uint32_t shownOf(const MeshPiece& p, float width, float pixel) {
    const float most = 1 / f32::shadowsOfOne(width, pixel);
    return static_cast<uint32_t>(std::upper_bound(p.chances.begin(), p.chances.end(), most) - p.chances.begin());
}

void choosePieces(const DrawContext& ctx, KindDraw& d) {
    const Field& field = *d.field;
    const Patch& patch = field.species[d.species].grown->patch;
    const int segments = field.grows().species[d.species].segments;
    float widest = 0;
    for (const Blade& b : patch.blades) widest = std::max(widest, b.width);
    const float pixels = pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)), sagitta = bladeSagitta(patch),
                reach = bladeReach(field.grows().species[d.species], patch), to = field.view->tiers.blades.max;
    for (const MeshPiece& p : d.planted->pieces) {
        const glm::vec3 centre = d.place((p.low + p.high) * 0.5f);
        const float radius = 0.5f * glm::length(p.high - p.low) * d.place.scale + reach,
                    nearest = std::max(glm::length(centre) - radius, 0.0f);
        if (!(nearest < to) || !ctx.frustum.touches(centre - radius, centre + radius) ||
            !looksHere(p, d.place, centre, radius, reach))
            continue;
        const int quads = std::max(f32::chordQuads(sagitta * pixels, nearest, segments), 1);
        CellDraw cell{};
        cell.first = static_cast<uint32_t>(p.first), cell.last = cell.first + shownOf(p, widest, nearest / pixels);
        d.commands[quads].push_back(drawCommand(cell, quads, static_cast<uint32_t>(kPiece), ctx.settings.detail, 0,
                                                2 * static_cast<uint32_t>(segments + 1)));
    }
}

void chooseOn(DrawContext& ctx, const PlantedMesh& m, const GrassyMesh& on, const Field& field,
              std::vector<KindDraw>& draws) {
    const MeshPlace place = placeOn(ctx, on.entity);
    const MeshMaps maps = mapsOn(ctx, field, on, true);
    for (size_t i = 0; i < m.kinds.size(); ++i) {
        if (m.kinds[i].pieces.empty()) continue;
        PatchMesh& patch = ctx.own<PlantedMeshes>().patches.at(field.number, i);
        updatePatch(ctx, patch, *field.species[i].grown, field.grows().species[i].segments);
        draws.push_back({&field, i, &m.kinds[i], &patch, place, maps, static_cast<float>(m.uvLength),
                         firstLightOf(ctx, on.entity)});
        choosePieces(ctx, draws.back());
    }
}

void uploadCommands(DrawContext& ctx, MeshGeometryView& view) {
    std::vector<DrawCommand> all;
    for (const KindDraw& d : view.draws)
        for (const auto& [quads, commands] : d.commands) {
            all.insert(all.end(), commands.begin(), commands.end());
            for (const DrawCommand& c : commands)
                ctx.stats.bladesGeometry += c.count / (6 * static_cast<uint32_t>(quads));
        }
    if (all.empty())
        view.commands = {};
    else
        writeBuffer(ctx.gpu, view.commands, kOwner, all.size() * sizeof(DrawCommand), all.data());
}

void selectMeshGeometry(DrawContext& ctx) {
    PlantedMeshes& state = ctx.own<PlantedMeshes>();
    MeshGeometryView& view = ctx.ofView<MeshGeometryView>();
    view.draws.clear();
    if (!ctx.shared.grass) return;
    state.patches.keep(ctx.shared.grown->all, Feature::GrassMeshGeometry);
    std::set<std::string> used;
    for (const GrassyMesh& on : grassyMeshes(ctx.project)) {
        const Field* field = fieldNamed(ctx, on.field);
        if (!field || !field->grown->draws(Feature::GrassMeshGeometry)) continue;
        used.insert(on.name);
        PlantedMesh& m = state.meshes[on.name];
        PlantedBy by = plantedBy(ctx, on, *field, *ctx.project.registry.get<StaticMesh>(on.entity));
        if (!isPlanted(m, by, on.grows->density.map)) {
            m.by = std::move(by), m.density = on.grows->density.map;
            plant(ctx, m, on, *field);
        }
        if (field->draws(Feature::GrassMeshGeometry)) chooseOn(ctx, m, on, *field, view.draws);
    }
    std::erase_if(state.meshes, [&](const auto& m) { return !used.contains(m.first); });
    uploadCommands(ctx, view);
}

bool begin(DrawContext& ctx, const MeshGeometryView& view, const KindDraw& d) {
    endTransparency();
    if (!ctx.use(0, fieldConstants(d.field->view->of), &d.maps.features)) return false;
    const GrownSpecies& grown = *d.field->species[d.species].grown;
    bindField(*d.field);
    bindMaps(d.maps);
    beginTransparency(ctx, *d.field);
    glBindTextureUnit(TEX_BLADE, grown.bladeTexture.id());
    if (grown.shade.texture) glBindTextureUnit(TEX_MASK, grown.shade.texture);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_BLADES, d.patch->blades.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_CELLS, d.planted->roots.id());
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SPECIES, grown.globals.id());
    glVertexArrayElementBuffer(view.vertices.id(), d.patch->indices.id());
    glUniform1f(4, d.uvLength);
    glUniform1f(6, pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)));
    d.place.set();
    glUniform1ui(14, d.firstLight);
    bindObjectLight(ctx);
    return true;
}

void drawMeshGeometry(DrawContext& ctx) {
    MeshGeometryView& view = ctx.ofView<MeshGeometryView>();
    if (!view.vertices.id()) view.vertices = makeVertexArray(kOwner);
    size_t offset = 0;
    for (const KindDraw& d : view.draws) {
        if (!begin(ctx, view, d)) break;
        glBindVertexArray(view.vertices.id());
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, view.commands.id());
        for (const auto& [quads, commands] : d.commands) {
            glUniform1i(5, quads);
            glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset),
                                        static_cast<GLsizei>(commands.size()), 0);
            offset += commands.size() * sizeof(DrawCommand);
            ctx.pass->draws += 1;
            ctx.pass->instances += commands.size();
        }
    }
    endTransparency();
}

const System kSystems[] = {{"grass/mesh-geometry/select",
                            {.reads = {Slot::Grown, Slot::Grass, Slot::Ground, Slot::Masks, Slot::ObjectLight}},
                            selectMeshGeometry}};
const ProgramRow kPrograms[] = {
    {"grass/mesh-geometry", "grass/mesh_geometry.vert.glsl", "grass/blade.frag.glsl", nullptr, fieldVariants}};
// After the rays (Stage::Slices), which take what stands in the depth for the surface.
const Pass kPasses[] = {{"grass/mesh-geometry",
                         Stage::Far,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::Grass, Slot::Masks, Slot::Shadows, Slot::Lamps, Slot::ObjectLight},
                          .appends = {Slot::SceneColor, Slot::SceneDepth}},
                         kPrograms,
                         drawMeshGeometry,
                         featureSet(Feature::GrassBlended),
                         false,
                         true}};
const Follows kFollows[] = {{Feature::Wind, "blades bend and quiver each by itself"},
                            {Feature::Forces, "grass on meshes is not pressed"},
                            {Feature::ForceMap, "grass on meshes is not pressed"}};

}  // namespace

const EffectRow& meshGeometryEffect() {
    static const EffectRow row{
        .name = kOwner,
        .needs = featureSet(Feature::GrassMeshGeometry, Feature::Objects, Feature::Grass, Feature::Terrain),
        .systems = kSystems,
        .passes = kPasses,
        .makeState = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<PlantedMeshes>(); },
        .help = "near blades on objects are drawn one by one",
        .makeView = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<MeshGeometryView>(); },
        .follows = kFollows};
    return row;
}

}  // namespace sward
