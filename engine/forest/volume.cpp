#include "forest/volume.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/file.h"
#include "core/log.h"
#include "core/numerics.h"
#include "forest/stretch.h"
#include "mesh/facing.h"

namespace sward {
namespace {

void repeat(const Texture& t) {
    glTextureParameteri(t.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(t.id(), GL_TEXTURE_WRAP_T, GL_REPEAT);
}

// Slabs of all levels as layers, the finest first, with all that hardware reads of them from afar.
Texture slabTexture(Gpu& gpu, const std::string& owner, const VolumeImages& images) {
    const GLenum format = images.compressed ? GL_COMPRESSED_SRGB_ALPHA_BPTC_UNORM : GL_SRGB8_ALPHA8;
    Texture t = makeTextureArray(gpu, owner, format, images.side, images.side, 2 * images.layers - 1);
    repeat(t);
    for (size_t l = 0, first = 0; l < images.levels.size(); first += static_cast<size_t>(images.layers >> l), ++l)
        for (int m = 0; m < t.levels; ++m) {
            const std::vector<uint8_t>& bytes = images.levels[l][static_cast<size_t>(m)];
            const int size = std::max(images.side >> m, 1), layers = images.layers >> l, at = static_cast<int>(first);
            if (images.compressed)
                glCompressedTextureSubImage3D(t.id(), m, 0, 0, at, size, size, layers, format,
                                              static_cast<GLsizei>(bytes.size()), bytes.data());
            else
                glTextureSubImage3D(t.id(), m, 0, 0, at, size, size, layers, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        }
    return t;
}

Texture slotTexture(Gpu& gpu, const std::string& owner, const VolumeImages& images) {
    Texture t = makeTexture2D(gpu, owner, GL_R8UI, images.side, images.side);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(t.id(), 0, 0, 0, images.side, images.side, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                        images.slots.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureParameteri(t.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(t.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return t;
}

void upload(Gpu& gpu, const std::string& owner, Volume& v, VolumeImages&& images) {
    v.slabs = slabTexture(gpu, owner, images);
    v.levels = static_cast<int>(images.levels.size());
    v.slots = slotTexture(gpu, owner, images);
    const ForestAir& air = images.air;
    v.light = makeTexture3D(gpu, owner, GL_RGBA8, air.side, air.side, FOREST_RISES * air.layers);
    v.images = std::move(images);
    v.images.levels.clear();
    v.sun = glm::vec3(0), v.stretchedSky = {};
}

// The volume that can be shown now. Where one may wait, waits for it.
std::optional<VolumeImages> volumeThere(const DrawContext& ctx, Volume& v) {
    if (!ctx.settings.background) {
        v.bake = {};
        JobControl control;
        return std::move(*volumeOf(cacheDir(), v.spec, control));
    }
    if (auto made = v.bake.take(v.key)) {
        if (*made) return std::move(**made);
        logWarning(made->error().text() + "; a draft of the forest is drawn");
        v.shown = v.key;
        return std::nullopt;
    }
    if (v.bake.active()) return std::nullopt;
    return loadCachedVolume(cacheDir(), v.key);
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

// How much longer the sun's way through the forest around is than on level ground: on slopes that face away from it,
// trees uphill stand higher in its way.
double onSlope(const glm::dvec3& normal, const glm::dvec3& sun) {
    constexpr double kMost = 6;
    const double level = sun.y * normal.y, here = glm::dot(normal, sun);
    return level > 1e-6 ? std::clamp(level / std::max(here, level / kMost), 1 / kMost, kMost) : 1;
}

// Has the texture hold the light on ground against which the sun's comes by one of kRises.
void lightSlope(Volume& v, size_t rise) {
    const ForestAir& air = v.images.air;
    const std::vector<float> others =
        rise == FOREST_LEVEL ? std::vector<float>() : lightPastOthers(air, glm::dvec3(v.bakedSun), kRises[rise]);
    std::vector<uint8_t> bytes(4 * air.extinction.size());
    const auto byte = [](float x) { return static_cast<uint8_t>(std::lround(std::clamp(x, 0.0f, 1.0f) * 255)); };
    for (size_t i = 0; i < air.extinction.size(); ++i) {
        const float get = air.leavesGet(i), past = others.empty() ? v.past.past[i] : v.past.pastOwn[i] * others[i];
        bytes[4 * i] = byte(get * past), bytes[4 * i + 3] = byte(get * v.past.pastOwn[i]);
        bytes[4 * i + 1] = byte(get * v.sky()[0][i]), bytes[4 * i + 2] = byte(get * v.sky()[1][i]);
    }
    glTextureSubImage3D(v.light.id(), 0, 0, 0, static_cast<GLint>(rise) * air.layers, air.side, air.side, air.layers,
                        GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    v.lit[rise] = true;
}

}  // namespace

void ensureVolume(DrawContext& ctx, const std::string& owner, Volume& v, const ForestHere& here) {
    if (v.verticalScale != here.rule.verticalScale)
        v.verticalScale = here.rule.verticalScale, v.sun = glm::vec3(0), v.stretchedSky = {};
    if (v.grown != here.grown || v.voxelOf != here.rule.voxel || v.storageOf != here.rule.storage) {
        v.grown = here.grown, v.voxelOf = here.rule.voxel, v.storageOf = here.rule.storage;
        v.spec = {here.stand->tiles, std::make_shared<const std::vector<Mesh>>(here.meshes),
                  static_cast<double>(here.rule.voxel), here.rule.storage == VolumeStorage::Compressed};
        v.key = volumeKey(v.spec);
        v.bake = {};
        v.stood = 0;
    }
    if (v.shown == v.key) return;
    if (auto there = volumeThere(ctx, v)) {
        upload(ctx.gpu, owner, v, std::move(*there));
        v.shown = v.key;
        v.stood = 0;
        return;
    }
    if (v.bake.active() || v.shown == v.key) return;
    upload(ctx.gpu, owner, v, draftVolume(v.spec));
    v.shown = ~v.key;
    v.bake = Job<VolumeImages>("forest of " + here.entity, v.key,
                               [spec = v.spec](JobControl& c) { return volumeOf(cacheDir(), spec, c); });
}

bool lightVolume(Volume& v, const glm::vec3& sun) {
    if (v.sun == sun) return false;
    const double scale = static_cast<double>(v.verticalScale);
    const ForestAir& air = v.images.air;
    v.sun = sun, v.bakedSun = glm::vec3(bakedWay(glm::dvec3(sun), scale));
    if (scale != 1 && v.stretchedSky[0].empty()) v.stretchedSky = skyThrough(air, scale);
    v.foliage.clear();
    for (const TreeAir& tree : v.images.trees) v.foliage.emplace_back(tree.facing, sun, v.verticalScale);
    v.past = lightThrough(air, glm::dvec3(v.bakedSun));
    const auto lowest = [&](const std::vector<float>& shares) {
        const auto end = shares.begin() + static_cast<ptrdiff_t>(shares.size() / static_cast<size_t>(air.layers));
        return std::accumulate(shares.begin(), end, 0.0f) / static_cast<float>(end - shares.begin());
    };
    v.floorSun = lowest(v.past.past), v.floorSky = lowest(v.sky()[0]);
    v.lit.fill(false);
    lightSlope(v, FOREST_LEVEL);
    return true;
}

void lightSlopes(Volume& v) {
    for (const Prism& p : v.prisms)
        if (!v.lit[static_cast<size_t>(p.rise)]) lightSlope(v, static_cast<size_t>(p.rise));
}

void fillCanopies(Volume& v, const StandingForest& f, const glm::dvec3& sun) {
    const Stands stands(f);
    const double across = std::hypot(sun.x, sun.z), height = v.height();
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
        // The nearest rise for which light is stored, and how much longer or shorter the way is than that.
        const double longer = onSlope(v.prisms[i].normal, sun);
        const auto off = [&](double rise) { return std::abs(std::log(rise * longer)); };
        const auto rise =
            std::min_element(kRises.begin(), kRises.end(), [&](double a, double b) { return off(a) < off(b); });
        v.prisms[i].rise = static_cast<int>(rise - kRises.begin());
        v.prisms[i].canopy.x *= static_cast<float>(longer * *rise);
    });
}

}  // namespace sward
