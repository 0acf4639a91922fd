#include "forest/texcells.h"

#include <algorithm>
#include <cmath>

#include "core/numerics.h"
#include "forest/stand.h"
#include "forest/volume_bake.h"
#include "shared/forest.h"

namespace sward {
namespace {

static_assert(sizeof(TileInView) % 16 == 0, "as std430 strides it");
constexpr const char* kOwner = "forest/texcells";
constexpr double kSlabPixels = 2;  // of a slab's height, where it lies at its tile's distance
constexpr double kFadeDeg = 4;     // to both sides of Forest::silhouetteDeg
constexpr int kMostSlices = 512;   // of a tile
constexpr float kNoTree = 1e30f;   // as high as a foot may lie
static_assert(kTreeSlots == FOREST_SLOTS);

// What of a triangle does not change with the view.
struct Prism {
    std::array<glm::dvec3, 3> corner;  // on the ground, in the world
    glm::dvec3 centre{0};
    glm::dvec3 normal{0, 1, 0};  // unit
    double slope = 0;            // metres a metre
    glm::vec2 canopy{1};         // TileInView::canopy
};
// A forest's volume on the GPU.
struct Volume {
    uint64_t grown = 0, stood = 0;  // as ForestHere
    float voxelOf = 0;              // Forest::voxel
    std::vector<Texture> levels;
    Texture slots, light, canopies;
    Buffer globals;           // of its light, for meshes
    glm::ivec2 firstCell{0};  // of canopies
    ForestVolume baked;       // its levels are dropped once they are textures
    std::array<std::vector<float>, 2> sky;
    glm::vec3 sun{0};           // that the light is of
    std::vector<Prism> prisms;  // of StandingForest::triangles
};
struct TexcellsState : EffectState {
    std::map<std::string, Volume> volumes;  // by entity
    VertexArray noVertices = makeVertexArray(kOwner);
};
// Tiles of one level, drawn by one call.
struct Run {
    const ForestHere* here;
    const Volume* volume;
    int level;
    size_t first, count;
    int slices;
};
struct TexcellsView : EffectState {
    Buffer tileBuffer, feetBuffer, globals;
    std::vector<TileInView> inView;
    std::vector<float> feet;  // FOREST_SLOTS of each tile in view
    std::vector<Run> runs;
    Buffer nodes;  // of the ground, as many as one draw has
};

// --- textures ------------------------------------------------------------------------------------------------------

std::vector<glm::vec4> halved(const std::vector<glm::vec4>& texels, int side) {
    const size_t half = static_cast<size_t>(std::max(side / 2, 1));
    const size_t s = static_cast<size_t>(side);
    std::vector<glm::vec4> out(half * half);
    for (size_t y = 0; y < half; ++y)
        for (size_t x = 0; x < half; ++x)
            out[y * half + x] = 0.25f * (texels[2 * y * s + 2 * x] + texels[2 * y * s + 2 * x + 1] +
                                         texels[(2 * y + 1) * s + 2 * x] + texels[(2 * y + 1) * s + 2 * x + 1]);
    return out;
}

std::vector<uint8_t> encoded(const std::vector<glm::vec4>& texels) {
    const auto byte = [](float x) { return static_cast<uint8_t>(std::lround(std::clamp(x, 0.0f, 1.0f) * 255)); };
    std::vector<uint8_t> out(4 * texels.size(), 0);
    for (size_t i = 0; i < texels.size(); ++i) {
        if (!(texels[i].w > 0)) continue;
        for (int c = 0; c < 3; ++c) out[4 * i + static_cast<size_t>(c)] = byte(f32::srgbEncode(texels[i][c]));
        out[4 * i + 3] = byte(texels[i].w);
    }
    return out;
}

// Slabs of one level as layers, with all that hardware reads of them from afar. Each size is rounded once.
Texture slabTexture(Gpu& gpu, const std::vector<glm::vec4>& level, int side, int layers) {
    Texture t = makeTextureArray(gpu, kOwner, GL_SRGB8_ALPHA8, side, side, layers);
    glTextureParameteri(t.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(t.id(), GL_TEXTURE_WRAP_T, GL_REPEAT);
    const size_t slab = static_cast<size_t>(side) * static_cast<size_t>(side);
    std::vector<std::vector<std::vector<uint8_t>>> bytes(static_cast<size_t>(layers));
    parallelFor(static_cast<size_t>(layers), [&](size_t l) {
        std::vector<glm::vec4> texels(level.begin() + static_cast<ptrdiff_t>(l * slab),
                                      level.begin() + static_cast<ptrdiff_t>((l + 1) * slab));
        int size = side;
        for (int m = 0; m < t.levels; ++m) {
            bytes[l].push_back(encoded(texels));
            if (size > 1) texels = halved(texels, size), size /= 2;
        }
    });
    for (size_t l = 0; l < bytes.size(); ++l)
        for (size_t m = 0; m < bytes[l].size(); ++m) {
            const int size = std::max(side >> m, 1);
            glTextureSubImage3D(t.id(), static_cast<GLint>(m), 0, 0, static_cast<GLint>(l), size, size, 1, GL_RGBA,
                                GL_UNSIGNED_BYTE, bytes[l][m].data());
        }
    return t;
}

void bake(DrawContext& ctx, Volume& v, const ForestHere& here) {
    v.baked = bakeForest(here.stand->tiles, here.meshes, static_cast<double>(here.rule.voxel));
    v.levels.clear();
    for (size_t l = 0; l < v.baked.levels.size(); ++l)
        v.levels.push_back(slabTexture(ctx.gpu, v.baked.levels[l], v.baked.side, v.baked.layers >> l));
    v.baked.levels.clear();
    v.slots = makeTexture2D(ctx.gpu, kOwner, GL_R8UI, v.baked.side, v.baked.side);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(v.slots.id(), 0, 0, 0, v.baked.side, v.baked.side, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                        v.baked.slots.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureParameteri(v.slots.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(v.slots.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    v.sky = skyThrough(v.baked.air);
    const ForestAir& air = v.baked.air;
    v.light = makeTextureArray(ctx.gpu, kOwner, GL_RGBA8, air.side, air.side, air.layers);
    glTextureParameteri(v.light.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(v.light.id(), GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTextureParameteri(v.light.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    v.sun = glm::vec3(0);
}

void light(Volume& v, const glm::vec3& sun) {
    if (v.sun == sun) return;
    v.sun = sun;
    const ForestAir& air = v.baked.air;
    const std::vector<float> seen = lightThrough(air, glm::dvec3(sun));
    std::vector<uint8_t> bytes(4 * seen.size());
    const auto byte = [](float x) { return static_cast<uint8_t>(std::lround(std::clamp(x, 0.0f, 1.0f) * 255)); };
    for (size_t i = 0; i < seen.size(); ++i) {
        bytes[4 * i] = byte(seen[i]);
        bytes[4 * i + 1] = byte(v.sky[0][i]);
        bytes[4 * i + 2] = byte(v.sky[1][i]);
        bytes[4 * i + 3] = 255;
    }
    glTextureSubImage3D(v.light.id(), 0, 0, 0, 0, air.side, air.side, air.layers, GL_RGBA, GL_UNSIGNED_BYTE,
                        bytes.data());
}

// --- tiles ---------------------------------------------------------------------------------------------------------

// A triangle's corner k in its cell, in the order of the tile's.
glm::ivec2 cornerOf(bool up, int k) { return up ? glm::ivec2(k == 1, k == 2) : glm::ivec2(k != 1, k != 2); }

void makePrisms(Volume& v, const ForestHere& here) {
    v.prisms.clear();
    const StandingForest& f = *here.stand;
    for (const ForestTriangle& t : f.triangles) {
        Prism p;
        for (size_t k = 0; k < 3; ++k) {
            const glm::ivec2 at = t.cell + cornerOf(t.tile.up, static_cast<int>(k));
            const f64::vec2 place = f64::fromLattice({at.x, at.y}, f.tiles.edge);
            p.corner[k] = f.origin + glm::dvec3(place.x, terrainHeight(*here.terrain, place.x, place.y), place.y);
            p.centre += p.corner[k] / 3.0;
        }
        const glm::dvec3 n = glm::cross(p.corner[2] - p.corner[0], p.corner[1] - p.corner[0]);
        p.normal = glm::normalize(n);
        p.slope = std::hypot(n.x, n.z) / std::max(std::abs(n.y), 1e-9);
        v.prisms.push_back(p);
    }
}

// The share of its tile's trees that stand in a triangle, by its cell.
class Stands {
  public:
    explicit Stands(const StandingForest& f) : edge_(f.tiles.edge), origin_(f.origin) {
        for (const ForestTriangle& t : f.triangles) {
            size_t all = f.tiles.within(t.tile.cell, t.tile.up).size(), there = 0;
            for (size_t k = 0; k < 3; ++k) all += f.tiles.onEdge[k][static_cast<size_t>(t.tile.colors[k])].size();
            for (const int32_t n : t.trees) there += n >= 0;
            shares_[{t.cell.x, t.cell.y, t.tile.up}] = static_cast<float>(there) / static_cast<float>(all);
        }
    }
    // At a place of the world; 0 where none stands.
    float at(const glm::dvec2& place) const {
        const f64::vec2 uv = f64::toLattice({place.x - origin_.x, place.y - origin_.z}, edge_);
        const double i = std::floor(uv.x), j = std::floor(uv.y);
        const auto found = shares_.find({static_cast<int>(i), static_cast<int>(j), uv.x - i + uv.y - j <= 1});
        return found == shares_.end() ? 0 : found->second;
    }

  private:
    double edge_;
    glm::dvec3 origin_;
    std::map<std::tuple<int, int, bool>, float> shares_;
};

// Canopies as an image, a texel a vertex of the lattice: the mean of the six triangles around it, so that shade on the
// ground has no edges where tiles have.
void drawCanopies(DrawContext& ctx, Volume& v, const StandingForest& f) {
    glm::ivec2 first = f.triangles[0].cell, last = first;
    for (const ForestTriangle& t : f.triangles) first = glm::min(first, t.cell), last = glm::max(last, t.cell);
    const glm::ivec2 size = last - first + 2;
    std::vector<glm::vec2> sums(static_cast<size_t>(size.x) * static_cast<size_t>(size.y), glm::vec2(0));
    for (size_t i = 0; i < f.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const glm::ivec2 at = f.triangles[i].cell - first + cornerOf(f.triangles[i].tile.up, k);
            sums[static_cast<size_t>(at.y * size.x + at.x)] += v.prisms[i].canopy / 6.0f;
        }
    std::vector<uint8_t> bytes;
    for (const glm::vec2& s : sums)
        for (int c = 0; c < 2; ++c)
            bytes.push_back(static_cast<uint8_t>(std::lround(std::clamp(s[c], 0.0f, 1.0f) * 255)));
    if (v.canopies.width != size.x || v.canopies.height != size.y)
        v.canopies = makeTexture2D(ctx.gpu, kOwner, GL_RG8, size.x, size.y);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(v.canopies.id(), 0, 0, 0, size.x, size.y, GL_RG, GL_UNSIGNED_BYTE, bytes.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    v.firstCell = first;
}

// What trees' meshes need to be lit by the same air.
void publish(DrawContext& ctx, Volume& v, ForestHere& here, const ForestGlobals& g) {
    writeBuffer(ctx.gpu, v.globals, kOwner, sizeof(g), &g);
    here.light = v.light.id();
    here.lightGlobals = v.globals.id();
    here.around.assign(here.stand->trees.size(), 0);
    for (size_t i = 0; i < v.prisms.size(); ++i)
        for (const int32_t n : here.stand->triangles[i].trees)
            if (n >= 0) here.around[static_cast<size_t>(n)] = v.prisms[i].canopy.y;
}

// How full the forest stands along the way to the sun, and all around as far as it is high.
void fillCanopies(Volume& v, const StandingForest& f, const glm::dvec3& sun) {
    const Stands stands(f);
    const double across = std::hypot(sun.x, sun.z), height = v.baked.height;
    const double reach = std::min(height * across / std::max(sun.y, 0.05), 4 * f.tiles.edge);
    const glm::dvec2 way = across > 1e-9 ? glm::dvec2(sun.x, sun.z) / across : glm::dvec2(0);
    parallelFor(v.prisms.size(), [&](size_t i) {
        const glm::dvec2 at(v.prisms[i].centre.x, v.prisms[i].centre.z);
        glm::vec2 sum(0);
        constexpr int kSteps = 8;
        for (int k = 0; k < kSteps; ++k) {
            const double turn = k * 2.399963229728653, out = std::sqrt((k + 0.5) / kSteps);
            sum.x += stands.at(at + way * (reach * (k + 0.5) / kSteps));
            sum.y += stands.at(at + glm::dvec2(std::cos(turn), std::sin(turn)) * (height * out));
        }
        v.prisms[i].canopy = sum / static_cast<float>(kSteps);
    });
}

// Height of the prism's ground over or under a place of the world.
double planeAt(const Prism& p, const glm::dvec3& at) {
    const glm::dvec3 to = at - p.corner[0];
    return p.corner[0].y - (p.normal.x * to.x + p.normal.z * to.z) / p.normal.y;
}

// What a tile's slices have to hold: metres over its plane.
struct Reach {
    double low = 1e30, high = -1e30;
};

// Feet of those trees that are drawn as volumes, relative to the eye; and what they reach.
Reach feetOf(const DrawContext& ctx, const ForestHere& here, const ForestTriangle& t, const Prism& p, bool near,
             std::vector<float>& out) {
    Reach r;
    for (const int32_t number : t.trees) {
        out.push_back(kNoTree);
        if (number < 0) continue;
        const StandingTree& tree = here.stand->trees[static_cast<size_t>(number)];
        if (near && isMesh(here.rule, tree, glm::distance(tree.at, ctx.camera.eye))) continue;
        const double foot = tree.at.y - planeAt(p, tree.at), aside = p.slope * here.stand->tiles.circle;
        r.low = std::min(r.low, foot - aside);
        r.high =
            std::max(r.high, foot + aside + static_cast<double>(here.rule.species[tree.species].height * tree.size));
        out.back() = static_cast<float>(tree.at.y - ctx.camera.eye.y);
    }
    return r;
}

struct Choice {
    uint32_t triangle;
    double distance;
};

std::vector<Choice> inView(const DrawContext& ctx, const ForestHere& here, const Volume& v) {
    std::vector<Choice> out;
    const double circle = here.stand->tiles.edge * 0.5774;  // around a triangle
    const double begin = volumesBegin(here.rule) - circle;
    for (uint32_t i = 0; i < v.prisms.size(); ++i) {
        const Prism& p = v.prisms[i];
        const glm::dvec3 at = p.centre - ctx.camera.eye;
        const double distance = glm::length(at);
        if (distance < begin) continue;
        glm::dvec3 low = p.corner[0], high = p.corner[0];
        for (const glm::dvec3& c : p.corner) low = glm::min(low, c), high = glm::max(high, c);
        const double aside = p.slope * circle;
        low.y -= aside, high.y += v.baked.height + aside;
        if (ctx.frustum.touches(glm::vec3(low - ctx.camera.eye), glm::vec3(high - ctx.camera.eye)))
            out.push_back({i, distance});
    }
    std::sort(out.begin(), out.end(), [](const Choice& a, const Choice& b) {
        return std::pair(-a.distance, a.triangle) < std::pair(-b.distance, b.triangle);
    });
    return out;
}

float pixelAt1m(const DrawContext& ctx) {
    return static_cast<float>(2 * std::tan(glm::radians(double(ctx.camera.fovDeg)) / 2)) * ctx.globals.pixelShare.y;
}

// How a tile's slices lie.
struct Slicing {
    std::array<double, 3> begin{};  // metres from each corner up to where slices begin
    double reach = 0;               // metres that they span, upwards
    int count = 0, under = 0;
    double weight = 1;  // share of the light's path that they stand for
};

// Parallel to the ground.
Slicing regular(const DrawContext& ctx, const Prism& p, const Reach& r, double slab) {
    Slicing s;
    s.begin.fill(r.low);
    s.count = std::max(static_cast<int>(std::ceil((r.high - r.low) / slab)), 1);
    s.reach = s.count * slab;
    const double above = ctx.camera.eye.y - planeAt(p, ctx.camera.eye) - r.low;
    s.under = std::clamp(static_cast<int>(std::floor(above / slab)), 0, s.count);
    return s;
}

// Tilted towards the eye (section 6, in the forms of numerics/tilt.h).
Slicing tilted(const Prism& p, const Reach& r, const glm::dvec3& view, double slant, double slab) {
    const auto upwards = [](const glm::dvec3& v) { return f64::vec3(v.x, v.z, v.y); };
    const double high = r.high - r.low;
    const glm::dvec3 o = p.corner[0];
    const f64::Tilt t = f64::tiltOf(upwards(p.corner[0] - o), upwards(p.corner[1] - o), upwards(p.corner[2] - o),
                                    upwards(view), slant * high, high, 1 / slab);
    Slicing s;
    for (int k = 0; k < 3; ++k) s.begin[static_cast<size_t>(k)] = r.low + t.offset[k];
    s.reach = high + t.rise;
    s.count = f64::sliceCount(t.count, kMostSlices);
    s.under = view.y < 0 ? s.count : 0;
    return s;
}

// Share of silhouette slices where the ground is seen at an angle of this sine: both are there over some degrees.
double silhouetteShare(const Forest& f, double sine) {
    const double angle = glm::degrees(std::asin(std::min(sine, 1.0)));
    return glm::smoothstep(-kFadeDeg, kFadeDeg, static_cast<double>(f.silhouetteDeg) - angle);
}

// The level at a distance: where a slab is kSlabPixels high.
double levelAt(const DrawContext& ctx, const Volume& v, double distance) {
    const double slab = v.baked.height / v.baked.layers, last = std::max(static_cast<double>(v.levels.size()) - 2, 0.0);
    const double pixels = distance * static_cast<double>(pixelAt1m(ctx)) * kSlabPixels / slab;
    return std::clamp(std::log2(std::max(pixels, 1e-9)), 0.0, last + 0.999);
}

void addSlices(TexcellsView& view, const glm::dvec3& eye, const ForestHere& here, const Volume& v,
               const ForestTriangle& t, const Prism& p, double level, const Slicing& s) {
    const int whole = static_cast<int>(level);
    const double slab = v.baked.height / v.baked.layers * (1 << whole);
    TileInView tile{};
    for (size_t k = 0; k < 3; ++k)
        tile.corner[k] = glm::vec4(glm::vec3(p.corner[k] - eye), static_cast<float>(s.begin[k]));
    tile.spacing = static_cast<float>(s.reach / s.count);
    tile.path = static_cast<float>(s.weight * s.reach / s.count / slab);
    tile.coarser = static_cast<float>(level - whole);
    tile.canopy = p.canopy;
    tile.stored = {static_cast<float>(t.tile.cell & 1), static_cast<float>(t.tile.cell >> 1)};
    tile.up = t.tile.up;
    tile.slices = s.count;
    tile.under = s.under;
    if (view.runs.empty() || view.runs.back().volume != &v || view.runs.back().level != whole)
        view.runs.push_back({&here, &v, whole, view.inView.size(), 0, 0});
    view.runs.back().count += 1;
    view.runs.back().slices = std::max(view.runs.back().slices, s.count);
    view.inView.push_back(tile);
}

void addTile(const DrawContext& ctx, TexcellsView& view, const ForestHere& here, const Volume& v, const Choice& c) {
    const ForestTriangle& t = here.stand->triangles[c.triangle];
    const Prism& p = v.prisms[c.triangle];
    std::vector<float> feet;
    const Reach reach = feetOf(ctx, here, t, p, c.distance < meshesEnd(here.rule) + here.stand->tiles.edge, feet);
    if (!(reach.low < reach.high)) return;
    const glm::dvec3 way = (p.centre - ctx.camera.eye) / std::max(c.distance, 1e-6);
    const double level = levelAt(ctx, v, c.distance),
                 share = silhouetteShare(here.rule, std::abs(glm::dot(p.normal, way)));
    const double slab = v.baked.height / v.baked.layers * (1 << static_cast<int>(level));
    const auto add = [&](Slicing s, double weight) {
        if (!(weight > 0)) return;
        s.weight = weight;
        addSlices(view, ctx.camera.eye, here, v, t, p, level, s);
        view.feet.insert(view.feet.end(), feet.begin(), feet.end());
    };
    add(regular(ctx, p, reach, slab), 1 - share);
    add(tilted(p, reach, way, static_cast<double>(here.rule.slant), slab), share);
}

ForestGlobals globalsOf(const DrawContext& ctx, const Volume& v, const ForestHere& here) {
    ForestGlobals g{};
    g.height = static_cast<float>(v.baked.height);
    g.voxel = static_cast<float>(2 * v.baked.edge / v.baked.side);
    g.pixel = pixelAt1m(ctx);
    g.lightSlabs = static_cast<float>(v.baked.air.layers);
    g.firstCell = v.firstCell;
    g.edge = static_cast<float>(v.baked.edge);
    g.seed = here.stand->seed;
    const bool meshesCast = here.rule.castShadows && here.rule.meshesTo > 0;
    g.shadeFrom = meshesCast ? static_cast<float>(volumesBegin(here.rule)) : -2;
    g.shadeTo = meshesCast ? static_cast<float>(meshesEnd(here.rule)) : -1;
    return g;
}

void place(DrawContext& ctx) {
    TexcellsState& s = ctx.own<TexcellsState>();
    TexcellsView& view = ctx.ofView<TexcellsView>();
    view.inView.clear(), view.feet.clear(), view.runs.clear();
    const auto drawn = [](const ForestHere& h) { return h.rule.meshesTo < std::numeric_limits<float>::infinity(); };
    std::erase_if(s.volumes, [&](const auto& f) {
        return std::none_of(ctx.shared.forests->all.begin(), ctx.shared.forests->all.end(),
                            [&](const auto& h) { return h->entity == f.first && drawn(*h); });
    });
    for (const auto& here : ctx.shared.forests->all) {
        if (!drawn(*here) || here->stand->trees.empty()) continue;
        Volume& v = s.volumes[here->entity];
        if (v.grown != here->grown || v.voxelOf != here->rule.voxel) bake(ctx, v, *here);
        const bool stale = v.stood != here->stood || v.grown != here->grown;
        if (stale) makePrisms(v, *here);
        v.grown = here->grown, v.stood = here->stood, v.voxelOf = here->rule.voxel;
        const glm::vec3 sun = ctx.globals.sunIsUp > 0 ? ctx.globals.sunDirection : glm::vec3(0, 1, 0);
        if (stale || v.sun != sun) {
            fillCanopies(v, *here->stand, glm::dvec3(sun));
            drawCanopies(ctx, v, *here->stand);
        }
        light(v, sun);
        publish(ctx, v, *here, globalsOf(ctx, v, *here));
        for (const Choice& c : inView(ctx, *here, v)) addTile(ctx, view, *here, v, c);
    }
    writeBuffer(ctx.gpu, view.tileBuffer, kOwner, view.inView.size() * sizeof(TileInView), view.inView.data());
    writeBuffer(ctx.gpu, view.feetBuffer, kOwner, view.feet.size() * sizeof(float), view.feet.data());
}

void bindGlobals(DrawContext& ctx, TexcellsView& view, const ForestGlobals& g) {
    writeBuffer(ctx.gpu, view.globals, kOwner, sizeof(g), &g);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FOREST, view.globals.id());
}

void bind(DrawContext& ctx, TexcellsView& view, const Run& run) {
    const Volume& v = *run.volume;
    const size_t level = static_cast<size_t>(run.level), next = std::min(level + 1, v.levels.size() - 1);
    ForestGlobals g = globalsOf(ctx, v, *run.here);
    g.fineSlabs = static_cast<float>(v.baked.layers >> level);
    g.coarseSlabs = static_cast<float>(v.baked.layers >> next);
    bindGlobals(ctx, view, g);
    glBindTextureUnit(TEX_FOREST_FINE, v.levels[level].id());
    glBindTextureUnit(TEX_FOREST_COARSE, v.levels[next].id());
    glBindTextureUnit(TEX_FOREST_LIGHT, v.light.id());
    glBindTextureUnit(TEX_FOREST_SLOTS, v.slots.id());
}

// The shade below volumes, on the ground.
void drawShade(DrawContext& ctx) {
    TexcellsView& view = ctx.ofView<TexcellsView>();
    if (ctx.settings.mode != ViewMode::Final || !ctx.use()) return;
    if (!view.nodes.id()) view.nodes = makeBuffer(ctx.gpu, kOwner, NODES_PER_DRAW * sizeof(TerrainNode), nullptr);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    for (const auto& here : ctx.shared.forests->all) {
        const auto v = ctx.own<TexcellsState>().volumes.find(here->entity);
        if (v == ctx.own<TexcellsState>().volumes.end() || here->stand->trees.empty()) continue;
        bindGlobals(ctx, view, globalsOf(ctx, v->second, *here));
        glBindTextureUnit(TEX_FOREST_LIGHT, v->second.light.id());
        glBindTextureUnit(TEX_FOREST_CANOPY, v->second.canopies.id());
        ctx.pass->draws += drawNodes(ctx.shared.groundMesh, ctx.shared.groundMesh.nodes, view.nodes);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void draw(DrawContext& ctx) {
    TexcellsView& view = ctx.ofView<TexcellsView>();
    if (!ctx.use() || view.runs.empty()) return;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_FOREST_TILES, view.tileBuffer.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_FOREST_FEET, view.feetBuffer.id());
    glBindVertexArray(ctx.own<TexcellsState>().noVertices.id());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, ctx.settings.mode == ViewMode::Overdraw ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    for (const Run& run : view.runs) {
        bind(ctx, view, run);
        glUniform1i(0, static_cast<GLint>(run.first));
        glDrawArraysInstanced(GL_TRIANGLES, 0, 3 * run.slices, static_cast<GLsizei>(run.count));
        ctx.pass->draws += 1;
        ctx.pass->instances += run.count;
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

const System kSystems[] = {
    {"forest/texcells/place", {.reads = {Slot::Forests, Slot::Sun, Slot::Ground}, .writes = {Slot::Forests}}, place}};
const ProgramRow kPrograms[] = {{"forest/texcells", "forest/texcells.vert.glsl", "forest/texcells.frag.glsl", nullptr}};
const ProgramRow kShadePrograms[] = {{"forest/shade", "terrain/ground.vert.glsl", "forest/shade.frag.glsl", nullptr}};
const Pass kPasses[] = {{"forest/shade",
                         Stage::GroundShadow,
                         kViewMain,
                         {.reads = {Slot::GroundNodes, Slot::Shadows}, .appends = {Slot::SceneColor}},
                         kShadePrograms,
                         drawShade},
                        {"forest/texcells",
                         Stage::Canopy,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::SceneDepth, Slot::Shadows}, .appends = {Slot::SceneColor}},
                         kPrograms,
                         draw}};

}  // namespace

const EffectRow& texcellsEffect() {
    static const EffectRow row{
        "forest/texcells",
        featureSet(Feature::ForestVolumes, Feature::Terrain),
        kSystems,
        kPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<TexcellsState>(); },
        "far trees of a forest are drawn as volumes",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<TexcellsView>(); }};
    return row;
}

}  // namespace sward
