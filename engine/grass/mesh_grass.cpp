#include "grass/mesh_grass.h"

#include "core/log.h"
#include "frame/draw_context.h"
#include "frame/gpu_mesh.h"
#include "frame/object_light.h"
#include "grass/field.h"
#include "grass/mesh_grass_settings.h"
#include "grass/mesh_planting.h"
#include "grass/mesh_shadow.h"
#include "grass/on_mesh.h"
#include "grass/raytraced_settings.h"
#include "grass/slice_gains.h"
#include "grass/slices.h"
#include "mesh/mesh_io.h"
#include "world/placement.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/mesh-grass";

// A mesh as a carrier, on the GPU.
struct GpuCarrier {
    std::string version = "?";  // of the file, as it was read
    MeshCarrier shape;          // its vertices and indices are the GPU's
    Buffer vertices, indices;
    VertexArray mesh;
    size_t indexCount = 0;      // 0: nothing can grow there
    glm::vec3 low{0}, high{0};  // of the mesh
};
struct CarrierState : EffectState {
    std::map<std::string, GpuCarrier> carriers;  // by file
    std::map<uint32_t, MeshShadow> shadows;      // by Entity::index, where objects cast shadows
};

// A mesh that carries grass, where this view has it.
struct Shell {
    GrassyMesh of;
    const GpuCarrier* carrier = nullptr;
    const Field* field = nullptr;
    MeshPlace place = {};
    bool seen = false;
    bool rays = false;  // are traced: where blades are drawn one by one as far as its end, they have nothing to show
    std::optional<CarrierVertex> below = {};  // the surface under the eye, if the eye may be within the shell
    float above = 0;                          // metres of the eye over that
    float uvLength = 1, distance = 0;
    size_t firstPart = 0;  // of its surface, among the parts of all
    MeshMaps maps = {};
    bool blades = false;  // near ones are drawn one by one
};
struct ShellView : EffectState {
    DepthCopy depth;        // the scene's, as it was before the shells
    Texture ends, leaving;  // of the nearest sides of shells that look away from the eye, where rays leave: depth;
                            // how steeply, of which part of the surfaces
    Framebuffer endsTarget;
    Buffer below;  // the surface under the eye, thrice
    VertexArray screen;
    float endsAt = 0;            // metres over the surface at which those sides are drawn
    std::vector<Shell> shells;   // nearest first
    PerSpecies<Buffer> globals;  // SliceGlobals in the patch's own cells
    Buffer casters;              // ObjectInstance, of the shells that cast shadows
};

void describe(const VertexArray& array, const Buffer& vertices) {
    const GLuint mesh = array.id();
    glVertexArrayVertexBuffer(mesh, 0, vertices.id(), 0, sizeof(CarrierVertex));
    const std::pair<int, size_t> attributes[] = {
        {3, offsetof(CarrierVertex, position)}, {3, offsetof(CarrierVertex, normal)},
        {2, offsetof(CarrierVertex, uv)},       {3, offsetof(CarrierVertex, alongU)},
        {3, offsetof(CarrierVertex, alongV)},   {3, offsetof(CarrierVertex, bend)},
        {1, offsetof(CarrierVertex, lift)},     {4, offsetof(CarrierVertex, chart)},
        {1, offsetof(CarrierVertex, part)}};
    for (GLuint i = 0; i < std::size(attributes); ++i) {
        glEnableVertexArrayAttrib(mesh, i);
        glVertexArrayAttribBinding(mesh, i, 0);
        glVertexArrayAttribFormat(mesh, i, attributes[i].first, GL_FLOAT, GL_FALSE,
                                  static_cast<GLuint>(attributes[i].second));
    }
    constexpr GLuint kOf = std::size(attributes);
    glEnableVertexArrayAttrib(mesh, kOf);
    glVertexArrayAttribBinding(mesh, kOf, 0);
    glVertexArrayAttribIFormat(mesh, kOf, 1, GL_UNSIGNED_INT, offsetof(CarrierVertex, of));
}

GpuCarrier uploadCarrier(Gpu& gpu, const Mesh& mesh) {
    GpuCarrier out;
    out.shape = carrierOf(mesh);
    if (out.shape.indices.empty()) return out;
    out.vertices =
        makeBuffer(gpu, kOwner, out.shape.vertices.size() * sizeof(CarrierVertex), out.shape.vertices.data());
    out.indices = makeBuffer(gpu, kOwner, out.shape.indices.size() * 4, out.shape.indices.data());
    out.indexCount = out.shape.indices.size();
    out.mesh = makeVertexArray(kOwner);
    out.low = mesh.low, out.high = mesh.high;
    describe(out.mesh, out.vertices);
    glVertexArrayElementBuffer(out.mesh.id(), out.indices.id());
    return out;
}

// Read again when the file changed. What cannot carry grass is told once.
const GpuCarrier& carrierIn(DrawContext& ctx, CarrierState& s, const GrassyMesh& on, const std::string& file) {
    GpuCarrier& c = s.carriers[file];
    std::string version = fileVersion(ctx.project.dir, file);
    if (c.version == version) return c;
    const Result<Mesh> mesh = readMesh(ctx.project.dir, file);
    c = mesh ? uploadCarrier(ctx.gpu, *mesh) : GpuCarrier{};
    c.version = std::move(version);
    if (mesh && !c.indexCount) logWarning(noTextureCoordinates(on.name, file).text() + "; its grass is not drawn");
    if (mesh && c.indexCount && c.shape.unmapped > 0)
        logWarning(on.name + ".MeshGrass: " + unmappedTriangles(file, c.shape));
    return c;
}

float tallest(const Field& field) {
    float top = 0;
    for (const FieldSpecies& s : field.species) top = std::max(top, s.grown->slices.top);
    return top;
}

// The eye is within a shell of this height if the nearest of the surface lies so little below it, and not beside it.
void findBelow(Shell& shell, float top) {
    glm::vec3 eye(0);  // in the mesh
    const float scale = shell.place.scale;
    for (const glm::vec4& row : shell.place.rows) eye -= glm::vec3(row) * row[3] / (scale * scale);
    const float room = top / scale;
    const glm::vec3 low = shell.carrier->low, high = shell.carrier->high;
    if (!glm::all(glm::greaterThan(eye, low - room)) || !glm::all(glm::lessThan(eye, high + room))) return;
    const CarrierVertex nearest = nearestOn(shell.carrier->shape, eye);
    const glm::vec3 over = eye - nearest.position;
    const float above = glm::dot(over, nearest.normal);
    if (above < 0.9f * glm::length(over) || above > room) return;
    shell.below = nearest, shell.above = above * scale;
}

void look(const DrawContext& ctx, Shell& shell) {
    const glm::vec3 low = shell.carrier->low, high = shell.carrier->high;
    const glm::vec3 centre = shell.place((low + high) * 0.5f);
    const float top = tallest(*shell.field), radius = glm::length(high - low) * 0.5f * shell.place.scale + top;
    shell.distance = glm::length(centre);
    shell.seen = ctx.frustum.touches(centre - radius, centre + radius);
    shell.rays = shell.seen && !(shell.blades && shell.distance + radius <= shell.field->view->tiers.blades.min);
    findBelow(shell, top);
}

void writeGlobals(DrawContext& ctx, ShellView& view) {
    view.globals.keep(ctx.shared.grass->all, Feature::GrassOnMeshes);
    eachSpecies(ctx, Feature::GrassOnMeshes, [&](const Field& field, size_t i) {
        SliceGlobals g = sliceGlobalsOf(ctx, field, i);
        g.eyeCell = g.inCell = glm::vec2(0);
        g.minGeom = field.view->tiers.blades.min, g.geomInv = field.view->tiers.blades.inv;
        const auto& images = field.view->settings<GrassSlices>();
        setGains(g, images.sliceCover == SliceCover::Conserving, field.species[i].grown->skyGains);
        writeBuffer(ctx.gpu, view.globals.at(field.number, i), kOwner, sizeof(g), &g);
    });
}

float grazedHeight(const Field& field) {
    float high = 0;
    for (const FieldSpecies& s : field.species) high = std::max(high, s.grown->look.grazed);
    return high;
}

void castShadows(DrawContext& ctx, CarrierState& state, ShellView& view) {
    std::map<uint32_t, MeshShadow> kept;
    std::vector<ObjectInstance> rows;
    std::vector<std::pair<const MeshShadow*, PlacedMesh>> casting;
    const bool maps = has(ctx.plan.features, Feature::ObjectShadows) || has(ctx.plan.features, Feature::LampShadows);
    for (const Shell& shell : view.shells) {
        if (!maps) break;
        const PlacedMesh placed = placeMesh(ctx.project, ctx.shared.ground, shell.of.entity);
        if (!placed.mesh->castShadows || !shell.field->view->settings<GrassDrawing>().groundShadows) continue;
        MeshShadow& shadow = kept[shell.of.entity.index] = std::move(state.shadows[shell.of.entity.index]);
        updateMeshShadow(ctx, shadow, kOwner, shell.carrier->shape, shell.carrier->version, shell.of.grows->density,
                         grazedHeight(*shell.field), shell.place.scale);
        rows.push_back(instanceAt(placed.at - ctx.camera.eye, placed.turn * static_cast<double>(placed.mesh->scale)));
        casting.push_back({&shadow, placed});
    }
    state.shadows = std::move(kept);
    if (rows.empty()) return void(view.casters = {});
    writeBuffer(ctx.gpu, view.casters, kOwner, rows.size() * sizeof(ObjectInstance), rows.data());
    for (size_t i = 0; i < casting.size(); ++i)
        castMeshShadow(ctx, *casting[i].first, casting[i].second, view.casters, i);
}

void selectShells(DrawContext& ctx) {
    CarrierState& state = ctx.own<CarrierState>();
    ShellView& view = ctx.ofView<ShellView>();
    view.shells.clear();
    if (!ctx.shared.grass) return;
    std::set<std::string> used;
    for (const GrassyMesh& on : grassyMeshes(ctx.project)) {
        const std::string& file = ctx.project.registry.get<StaticMesh>(on.entity)->file;
        used.insert(file);
        Shell shell{.of = on, .carrier = &carrierIn(ctx, state, on, file), .field = fieldNamed(ctx, on.field)};
        if (!shell.carrier->indexCount || !shell.field) continue;
        shell.place = placeOn(ctx, on.entity);
        const double uvLength = uvLengthOf(*on.grows, shell.carrier->shape, static_cast<double>(shell.place.scale));
        shell.uvLength = static_cast<float>(uvLength);
        shell.blades =
            drawsBladesOn(*shell.field, bladesAsked({shell.carrier->shape, on, shell.field->grows(), uvLength}));
        shell.maps = mapsOn(ctx, *shell.field, on, shell.blades);
        look(ctx, shell);
        view.shells.push_back(std::move(shell));
    }
    std::erase_if(state.carriers, [&](const auto& c) { return !used.contains(c.first); });
    std::stable_sort(view.shells.begin(), view.shells.end(),
                     [](const Shell& a, const Shell& b) { return a.distance < b.distance; });
    size_t parts = 0;
    for (Shell& shell : view.shells) shell.firstPart = std::exchange(parts, parts + shell.carrier->shape.parts);
    writeGlobals(ctx, view);
    castShadows(ctx, state, view);
}

void setPlace(const DrawContext& ctx, const Shell& shell) {
    shell.place.set();
    glUniform1ui(16, firstLightOf(ctx, shell.of.entity));
    bindObjectLight(ctx);
    glBindVertexArray(shell.carrier->mesh.id());
}

void drawIndices(DrawContext& ctx, size_t from, size_t to) {
    if (from == to) return;
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(to - from), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(4 * from));
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

void bindFar(const SliceTextures& slices) {
    glBindTextureUnit(TEX_FAR_REFLECTANCE, slices.farReflectance.id());
    glBindTextureUnit(TEX_FAR_THRESHOLD, slices.farThreshold.id());
    glBindTextureUnit(TEX_FAR_LIGHT, slices.farLight.id());
}

// Over the surface, in heights of the slices.
void setLifted(float heights) { glUniform1f(14, heights); }
void setShell(const DrawContext& ctx, const Shell& shell) {
    setPlace(ctx, shell);
    setLifted(1);
    glUniform1f(15, static_cast<float>(shell.firstPart));
}

std::string insideConstant(bool inside) { return fmt::format("const bool INSIDE = {};\n", inside); }
std::string rayConstants(bool whole, RayRest rest) {
    return fmt::format("const bool WHOLE = {};\nconst int REST = {};\n", whole, static_cast<int>(rest));
}

enum ShellProgram { kShellsOver, kShellsInside, kShellEnds };

bool begin(DrawContext& ctx, const ShellView& view, const Shell& shell, bool inside) {
    const auto& rays = shell.field->view->settings<RaytracedGrass>();
    endTransparency();
    const bool whole = !shell.maps.density && !shell.blades && isSownWhole(*shell.field);
    const std::string constants =
        fieldConstants(shell.field->view->of) + rayConstants(whole, rays.rest) + depthConstants(ctx.targets);
    if (!ctx.use(inside ? kShellsInside : kShellsOver, insideConstant(inside) + constants, &shell.maps.features))
        return false;
    bindField(*shell.field);
    bindMaps(shell.maps);
    beginTransparency(ctx, *shell.field);
    glUniform1i(0, rays.steps);
    glUniform1f(1, rays.cutOff);
    glUniform1f(2, rays.depthAt);
    glUniform1f(3, pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)));
    glUniform1f(6, rays.footprint);
    glUniform1f(4, shell.uvLength);
    glUniform1f(5, view.endsAt);
    setShell(ctx, shell);
    return true;
}

// The lifted surface from both sides: in dents narrower than the grass is high it is turned over, and where it looks
// away rays end at once.
void drawShell(DrawContext& ctx, const GpuCarrier& carrier) {
    drawIndices(ctx, 0, carrier.shape.surface);
    glEnable(GL_CULL_FACE);
    drawIndices(ctx, carrier.shape.surface, carrier.indexCount);
    glDisable(GL_CULL_FACE);
}

// For an eye within the shell: the whole picture.
void drawAround(DrawContext& ctx, ShellView& view, const Shell& shell, float top) {
    if (shell.above > top) return;
    setLifted(shell.above / top);
    const CarrierVertex corners[3] = {*shell.below, *shell.below, *shell.below};
    if (!view.screen.id()) {
        view.screen = makeVertexArray(kOwner);
        view.below = makeBuffer(ctx.gpu, kOwner, sizeof(corners), nullptr);
        describe(view.screen, view.below);
    }
    glNamedBufferSubData(view.below.id(), 0, sizeof(corners), corners);
    glBindVertexArray(view.screen.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

void fitEnds(DrawContext& ctx, ShellView& view) {
    const ViewTargets& t = ctx.targets;
    if (view.ends.width == t.width && view.ends.height == t.height) return;
    view.ends = makeTexture2D(ctx.gpu, kOwner, GL_DEPTH_COMPONENT32F, t.width, t.height);
    view.leaving = makeTexture2D(ctx.gpu, kOwner, GL_RG32F, t.width, t.height);
    view.endsTarget = makeFramebuffer(view.leaving.id(), view.ends.id(), kOwner);
}

// The tallest species of all: of the others it is known how far below they end.
struct Tallest {
    const Field* field = nullptr;
    size_t species = 0;
    float top = 0;
};
Tallest tallestOf(const ShellView& view) {
    Tallest out;
    for (const Shell& shell : view.shells)
        for (size_t i = 0; i < shell.field->species.size(); ++i)
            if (const float top = shell.field->species[i].grown->slices.top; shell.rays && top > out.top)
                out = {shell.field, i, top};
    return out;
}

void drawEnds(DrawContext& ctx, ShellView& view) {
    const Tallest highest = tallestOf(view);
    view.endsAt = highest.top;
    if (!ctx.use(kShellEnds, insideConstant(false)) || !highest.field) return;
    glBindFramebuffer(GL_FRAMEBUFFER, view.endsTarget.id());
    const float nothing = 0;
    glClearNamedFramebufferfv(view.endsTarget.id(), GL_DEPTH, 0, &nothing);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SLICES, view.globals.at(highest.field->number, highest.species).id());
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    for (const Shell& shell : view.shells) {
        if (!shell.rays) continue;
        setShell(ctx, shell);
        drawIndices(ctx, 0, shell.carrier->shape.surface);
    }
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
    glBindFramebuffer(GL_FRAMEBUFFER, ctx.targets.scene.id());
    glBindTextureUnit(TEX_SHELL_ENDS, view.ends.id());
    glBindTextureUnit(TEX_SHELL_LEAVING, view.leaving.id());
}

// Also while it is not seen: no halt when it comes into view.
bool drawOn(DrawContext& ctx, ShellView& view, const Shell& shell, bool inside) {
    if (!begin(ctx, view, shell, inside)) return false;
    for (size_t i = 0; shell.rays && i < shell.field->species.size(); ++i) {
        bindVerticalSlices(ctx, *shell.field, i, SliceLevels::One);
        bindFar(shell.field->species[i].grown->slices);
        glBindTextureUnit(TEX_SUN_GAINS, shell.field->species[i].grown->sunGains.id());
        if (shell.maps.density) glBindTextureUnit(TEX_DENSITY, shell.maps.density);
        glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SLICES, view.globals.at(shell.field->number, i).id());
        if (inside)
            drawAround(ctx, view, shell, shell.field->species[i].grown->slices.top);
        else
            drawShell(ctx, *shell.carrier);
    }
    return true;
}

void drawShells(DrawContext& ctx) {
    ShellView& view = ctx.ofView<ShellView>();
    if (std::any_of(view.shells.begin(), view.shells.end(), [](const Shell& s) { return s.rays; }))
        copyDepth(ctx, kOwner, view.depth), fitEnds(ctx, view);
    else
        view.depth = {}, view.endsTarget = {}, view.ends = {}, view.leaving = {};
    drawEnds(ctx, view);
    for (const Shell& shell : view.shells) {
        if (shell.below && !drawOn(ctx, view, shell, true)) break;
        if (!drawOn(ctx, view, shell, false)) break;
    }
    endTransparency();
}

// The surface itself lies exactly where the mesh was drawn.
void shadeByShells(DrawContext& ctx) {
    ShellView& view = ctx.ofView<ShellView>();
    if (ctx.settings.mode != ViewMode::Final) return;
    beginDimming();
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, 16);  // by no slope: that would bring the shade before grass in wide pixels
    for (const Shell& shell : view.shells) {
        if (!ctx.use(0, {}, &shell.maps.features)) break;
        bindField(*shell.field);
        bindMaps(shell.maps);
        setPlace(ctx, shell);
        glUniform1f(4, shell.uvLength);
        for (size_t i = 0; shell.seen && i < shell.field->species.size(); ++i) {
            glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SLICES, view.globals.at(shell.field->number, i).id());
            drawIndices(ctx, 0, shell.carrier->shape.surface);
        }
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    endDimming();
}

void bake(DrawContext& ctx) { makeSlices(ctx, Feature::GrassOnMeshes); }

std::vector<std::string> shellVariants(bool inside) {
    std::vector<std::string> out;
    const std::vector<std::string> depths = depthVariants();
    for (const std::string& field : fieldVariants())
        for (const bool whole : {false, true})
            out.push_back(insideConstant(inside) + field + rayConstants(whole, RayRest::Mean) + depths[1]);
    for (const RayRest rest : {RayRest::Opaque, RayRest::Nothing})
        out.push_back(insideConstant(inside) + fieldConstants(GrassDrawing{}, {}) + rayConstants(false, rest) +
                      depths[0]);
    return out;
}

const System kSystems[] = {{"grass/mesh-grass/bake",
                            {.reads = {Slot::Grown, Slot::Sun, Slot::SkyLight}, .appends = {Slot::Slices}},
                            bake,
                            true},
                           {"grass/mesh-grass/select",
                            {.reads = {Slot::Grass, Slot::Ground, Slot::Sun, Slot::Slices}, .appends = {Slot::Casters}},
                            selectShells}};
const ProgramRow kPrograms[] = {{"grass/mesh-grass", "grass/mesh_grass.vert.glsl", "grass/mesh_grass.frag.glsl",
                                 nullptr, [] { return shellVariants(false); }},
                                {"grass/mesh-grass/inside", "grass/mesh_grass.vert.glsl", "grass/mesh_grass.frag.glsl",
                                 nullptr, [] { return shellVariants(true); }},
                                {"grass/mesh-grass/ends", "grass/mesh_grass.vert.glsl", "grass/mesh_ends.frag.glsl",
                                 nullptr, [] { return std::vector<std::string>{insideConstant(false)}; }}};
const ProgramRow kShadePrograms[] = {
    {"grass/mesh-grass/shade", "grass/mesh_shade.vert.glsl", "grass/mesh_shade.frag.glsl", nullptr}};
const Pass kPasses[] = {
    {"grass/mesh-grass",
     Stage::Slices,
     kViewMain | kViewReflection,
     {.reads = {Slot::Grass, Slot::Slices, Slot::Shadows, Slot::Lamps, Slot::ObjectLight},
      .appends = {Slot::SceneColor, Slot::SceneDepth}},
     kPrograms,
     drawShells,
     featureSet(Feature::GrassBlended),
     false,
     true},
    {"grass/mesh-grass/shade",
     Stage::GroundShadow,
     kViewMain | kViewReflection,
     {.reads = {Slot::Grass, Slot::Slices, Slot::Shadows, Slot::ObjectLight}, .appends = {Slot::SceneColor}},
     kShadePrograms,
     shadeByShells}};
const Follows kFollows[] = {
    {Feature::GrassOnMeshes, "rays through slices, but for blades that are drawn one by one"},
    {Feature::Wind, "rays lean against the gust where it blows along the surface"},
    {Feature::Forces, "grass on meshes is not pressed"},
    {Feature::ForceMap, "grass on meshes is not pressed"},
    {Feature::GrassUnique, "slices are images of one patch: grass that is drawn by them repeats it"}};

}  // namespace

const EffectRow& meshGrassEffect() {
    static const EffectRow row{
        .name = kOwner,
        .needs = featureSet(Feature::GrassOnMeshes, Feature::Objects, Feature::Grass, Feature::Terrain),
        .systems = kSystems,
        .passes = kPasses,
        .makeState = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<CarrierState>(); },
        .help = "grass grows on objects",
        .makeView = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<ShellView>(); },
        .follows = kFollows};
    return row;
}

}  // namespace sward
