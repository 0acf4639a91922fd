#include "forest/volume_images.h"

#include <algorithm>
#include <cmath>

#include "core/hash.h"
#include "core/numerics.h"
#include "forest/leaf_depth.h"
#include "gpu/bc7.h"
#include "mesh/tree_shapes.h"

namespace sward {
namespace {

constexpr uint64_t kVersion = 8;     // of what is baked from the same trees
constexpr double kFilled = 0.6;      // of a bake's time, once the volume is there
constexpr float kDraftKeep = 0.12f;  // of leaves
constexpr double kDraftCoarser = 4;

std::vector<glm::vec4> halved(const std::vector<glm::vec4>& texels, int side) {
    const size_t half = static_cast<size_t>(std::max(side / 2, 1)), s = static_cast<size_t>(side);
    std::vector<glm::vec4> out(half * half);
    for (size_t y = 0; y < half; ++y)
        for (size_t x = 0; x < half; ++x)
            out[y * half + x] = 0.25f * (texels[2 * y * s + 2 * x] + texels[2 * y * s + 2 * x + 1] +
                                         texels[(2 * y + 1) * s + 2 * x] + texels[(2 * y + 1) * s + 2 * x + 1]);
    return out;
}

// sRGB of what a linear share from 0 to 1 is, by a table: exact to the byte for shares of 12 bits.
uint8_t srgbByte(float linear) {
    static const std::vector<uint8_t> table = [] {
        std::vector<uint8_t> t;
        for (int i = 0; i <= 4095; ++i)
            t.push_back(static_cast<uint8_t>(std::lround(255 * f32::srgbEncode(static_cast<float>(i) / 4095))));
        return t;
    }();
    return table[static_cast<size_t>(std::lround(std::clamp(linear, 0.0f, 1.0f) * 4095))];
}

std::vector<uint8_t> encoded(const std::vector<glm::vec4>& texels) {
    std::vector<uint8_t> out(4 * texels.size(), 0);
    for (size_t i = 0; i < texels.size(); ++i) {
        if (!(texels[i].w > 0)) continue;
        for (int c = 0; c < 3; ++c) out[4 * i + static_cast<size_t>(c)] = srgbByte(texels[i][c]);
        out[4 * i + 3] = static_cast<uint8_t>(std::lround(std::clamp(texels[i].w, 0.0f, 1.0f) * 255));
    }
    return out;
}

// A slab's image and its mips. Each size is rounded once.
std::vector<std::vector<uint8_t>> mipsOf(std::vector<glm::vec4> texels, int side, bool compressed) {
    std::vector<std::vector<uint8_t>> out;
    for (;; side /= 2) {
        std::vector<uint8_t> rgba = encoded(texels);
        out.push_back(compressed ? bc7Image(rgba.data(), side, side) : std::move(rgba));
        if (side == 1) return out;
        texels = halved(texels, side);
    }
}

std::vector<std::vector<uint8_t>> levelOf(const std::vector<glm::vec4>& level, int side, int layers, bool compressed) {
    const size_t slab = static_cast<size_t>(side) * static_cast<size_t>(side);
    std::vector<std::vector<std::vector<uint8_t>>> slabs(static_cast<size_t>(layers));
    parallelFor(slabs.size(), [&](size_t l) {
        slabs[l] = mipsOf(
            {level.begin() + static_cast<ptrdiff_t>(l * slab), level.begin() + static_cast<ptrdiff_t>((l + 1) * slab)},
            side, compressed);
    });
    std::vector<std::vector<uint8_t>> out(slabs[0].size());
    for (const auto& s : slabs)
        for (size_t m = 0; m < s.size(); ++m) out[m].insert(out[m].end(), s[m].begin(), s[m].end());
    return out;
}

template <class T>
void add(Hasher& h, const std::vector<T>& values) {
    h.add(values.data(), values.size() * sizeof(T));
}
void add(Hasher& h, const TileTree& t) {
    h.add(&t.at, sizeof t.at), h.add(&t.species, sizeof t.species), h.add(&t.size, sizeof t.size);
    h.add(&t.headingDeg, sizeof t.headingDeg);
}
void add(Hasher& h, const Mesh& m) {
    add(h, m.vertices), add(h, m.indices);
    for (const MeshPart& p : m.parts) {
        h.add(&p.first, sizeof p.first), h.add(&p.count, sizeof p.count), h.add(&p.color, sizeof p.color);
        h.add(&p.image, sizeof p.image), h.add(&p.cutoff, sizeof p.cutoff);
    }
    for (const MeshImage& i : m.images) h.add(&i.width, sizeof i.width), add(h, i.rgba);
}

}  // namespace

uint64_t volumeKey(const VolumeSpec& spec) {
    Hasher h;
    const ForestTiles& t = spec.tiles;
    const uint64_t flags = kVersion * 2 + (spec.compressed ? 1 : 0);
    h.add(&flags, sizeof flags), h.add(&spec.voxel, sizeof spec.voxel);
    h.add(&t.edge, sizeof t.edge), h.add(&t.highest, sizeof t.highest), h.add(&t.colors, sizeof t.colors);
    const auto list = [&](const std::vector<TileTree>& trees) {
        const uint64_t n = trees.size();
        h.add(&n, sizeof n);
        for (const TileTree& tree : trees) add(h, tree);
    };
    for (const auto& family : t.onEdge)
        for (const auto& color : family) list(color);
    for (const auto& cell : t.inside)
        for (const auto& tile : cell) list(tile);
    for (const Mesh& m : *spec.meshes) add(h, m);
    return h.value();
}

size_t VolumeImages::bytes() const {
    size_t sum = 0;
    for (const auto& level : levels)
        for (const auto& mip : level) sum += mip.size();
    return sum;
}

Result<VolumeImages> bakeVolume(const VolumeSpec& spec, JobControl& control) {
    ForestVolume v = bakeForest(spec.tiles, *spec.meshes, spec.voxel, &control);
    VolumeImages out{v.side, v.layers, v.cells, v.edge, v.height, spec.compressed, {}, std::move(v.slots), {}, {}, {}};
    for (size_t l = 0; l < v.levels.size(); ++l) {
        if (control.cancelled()) return interruption("the bake of a forest was cancelled");
        out.levels.push_back(levelOf(v.levels[l], v.side, v.layers >> l, spec.compressed));
        control.setProgress(1 - (1 - kFilled) / static_cast<double>(1 << (l + 1)));
    }
    out.sky = skyThrough(v.air);
    out.air = std::move(v.air);
    for (const Mesh& m : *spec.meshes) {
        out.trees.push_back(treeAir(m));
        out.trees.back().litFacing = litFacing(m, out.trees.back());
    }
    if (control.cancelled()) return interruption("the bake of a forest was cancelled");
    return out;
}

VolumeImages draftVolume(const VolumeSpec& spec) {
    VolumeSpec draft = spec;
    draft.voxel *= kDraftCoarser;
    std::vector<Mesh> meshes;
    for (const Mesh& m : *spec.meshes) meshes.push_back(thinned(m, kDraftKeep));
    draft.meshes = std::make_shared<const std::vector<Mesh>>(std::move(meshes));
    JobControl control;
    return std::move(*bakeVolume(draft, control));
}

Result<VolumeImages> volumeOf(const std::filesystem::path& folder, const VolumeSpec& spec, JobControl& control) {
    const uint64_t key = volumeKey(spec);
    if (auto cached = loadCachedVolume(folder, key)) return std::move(*cached);
    Result<VolumeImages> made = bakeVolume(spec, control);
    if (made) cacheVolume(folder, key, *made);
    return made;
}

}  // namespace sward
