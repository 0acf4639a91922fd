// Index: samples of a slab · drawing blades · light on a sample · texels and mips · the whole.
#include "grass/slice_bake.h"

#include <array>
#include <atomic>
#include <bit>

#include "core/hash.h"
#include "core/numerics.h"
#include "grass/mask.h"

namespace sward {
namespace {

constexpr int kSamplesAcross = 4;  // samples a texel, each way
constexpr int kStrips = 6;         // quads a blade
constexpr int kLights = 5;         // vertical: facing, behind, side +, side -, above; horizontal: x+, x-, z+, z-, above

// --- samples of a slab -----------------------------------------------------------------------------------------------
struct Sample {
    float depth;    // towards the viewer
    int32_t blade;  // the one that is seen; -1: none
    float across, along;
    float threshold;  // the least of all blades that cover it: from there on, one of them is there
};

// How a slab is seen: which coordinates are right, up and towards the viewer.
struct Slab {
    int right, up, toward;  // indices of x, y, z
    float extentRight, extentUp;
    int width, height;  // samples
    int k, n;           // the part [k/n, (k+1)/n) of the cell along `toward`; n 0: all of it
    float cellSize;
};

// A blade's copy in one of the nine cells.
struct Copy {
    uint32_t blade;
    float x, z;  // of its root
};

// --- drawing blades ----------------------------------------------------------------------------------------
struct Corner {
    glm::vec3 p;  // right and up in samples, toward in metres
    float across, along;
};

bool inSlab(const Slab& s, float toward) {
    if (s.n == 0) return true;
    const float t = toward / s.cellSize;
    return t >= 0 && t < 1 && f32::captureSlice(t, s.n) == s.k;
}

float alphaAt(const Rgba8& image, float across, float along) {
    const int x = std::clamp(static_cast<int>(across * image.width), 0, image.width - 1),
              y = std::clamp(static_cast<int>(along * image.height), 0, image.height - 1);
    return image.pixels[(static_cast<size_t>(y) * image.width + x) * 4 + 3] / 255.0f;
}

struct Canvas {
    const Slab& slab;
    const Patch& patch;
    const Rgba8& image;
    std::vector<Sample>& samples;

    void put(int x, int y, float depth, int32_t blade, float across, float along) {
        Sample& s = samples[static_cast<size_t>(y) * slab.width + x];
        const float threshold = patch.blades[static_cast<size_t>(blade)].threshold;
        const bool hidden = s.blade >= 0 && s.depth >= depth;
        if ((hidden && s.threshold <= threshold) || !inSlab(slab, depth) || alphaAt(image, across, along) < 0.5f)
            return;
        const float least = std::min(s.threshold, threshold);
        if (!hidden) s = {depth, blade, across, along, least};
        s.threshold = least;
    }
    // Samples whose centre lies inside; edges belong to one side by the sign of their direction, so that two triangles
    // with a common edge share no sample and leave none out.
    void triangle(const Corner& a, const Corner& b, const Corner& c, int32_t blade) {
        const float area = (b.p.x - a.p.x) * (c.p.y - a.p.y) - (b.p.y - a.p.y) * (c.p.x - a.p.x);
        if (!(std::abs(area) > 1e-12f)) return;
        if (area < 0) return triangle(a, c, b, blade);
        const int x0 = std::max(static_cast<int>(std::ceil(std::min({a.p.x, b.p.x, c.p.x}) - 0.5f)), 0),
                  y0 = std::max(static_cast<int>(std::ceil(std::min({a.p.y, b.p.y, c.p.y}) - 0.5f)), 0);
        const int x1 = std::min(static_cast<int>(std::floor(std::max({a.p.x, b.p.x, c.p.x}) - 0.5f)), slab.width - 1),
                  y1 = std::min(static_cast<int>(std::floor(std::max({a.p.y, b.p.y, c.p.y}) - 0.5f)), slab.height - 1);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
                const float u = edge(b.p, c.p, px, py), v = edge(c.p, a.p, px, py), w = edge(a.p, b.p, px, py);
                if (!inside(u, b.p, c.p) || !inside(v, c.p, a.p) || !inside(w, a.p, b.p)) continue;
                const float s = 1 / area;
                put(x, y, (a.p.z * u + b.p.z * v + c.p.z * w) * s, blade,
                    (a.across * u + b.across * v + c.across * w) * s, (a.along * u + b.along * v + c.along * w) * s);
            }
    }
    static float edge(const glm::vec3& a, const glm::vec3& b, float x, float y) {
        return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    }
    static bool inside(float e, const glm::vec3& a, const glm::vec3& b) {
        return e > 0 || (e == 0 && (b.y > a.y || (b.y == a.y && b.x < a.x)));
    }
};

Corner cornerOf(const Slab& s, const glm::vec3& p, float across, float along) {
    return {{p[s.right] / s.extentRight * static_cast<float>(s.width),
             p[s.up] / s.extentUp * static_cast<float>(s.height), p[s.toward]},
            across,
            along};
}

void drawBlade(Canvas& canvas, const Blade& b, const Copy& c) {
    Corner left, right;
    for (int i = 0; i <= kStrips; ++i) {
        const float v = static_cast<float>(i) / kStrips;
        const f32::BladeFrame f = f32::bladeFrameFacing(b.control, b.tip, b.facing, v);
        const glm::vec3 middle = glm::vec3(c.x, 0, c.z) + f.position, half = f.side * (0.5f * b.width);
        const Corner l = cornerOf(canvas.slab, middle - half, 0, v), r = cornerOf(canvas.slab, middle + half, 1, v);
        if (i > 0) {
            canvas.triangle(left, right, l, static_cast<int32_t>(c.blade));
            canvas.triangle(right, r, l, static_cast<int32_t>(c.blade));
        }
        left = l, right = r;
    }
}

// Where a copy may reach along an axis: its curve lies within its control points.
std::pair<float, float> extentOf(const Blade& b, const Copy& c, int axis) {
    const float at = axis == 0 ? c.x : c.z, half = 0.5f * b.width;
    const float p0 = 0, p1 = b.control[axis], p2 = b.tip[axis];
    return {at + std::min({p0, p1, p2}) - half, at + std::max({p0, p1, p2}) + half};
}

// The copies of all nine cells that reach into the middle one.
std::vector<Copy> copiesNear(const Patch& patch, float cellSize) {
    std::vector<Copy> out;
    for (uint32_t i = 0; i < patch.blades.size(); ++i)
        for (int n = 0; n < 9; ++n) {
            const Blade& b = patch.blades[i];
            const Copy c{i, b.root.x + static_cast<float>(n % 3 - 1) * cellSize,
                         b.root.y + static_cast<float>(n / 3 - 1) * cellSize};
            const auto [x0, x1] = extentOf(b, c, 0);
            const auto [z0, z1] = extentOf(b, c, 2);
            if (x1 >= 0 && x0 < cellSize && z1 >= 0 && z0 < cellSize) out.push_back(c);
        }
    return out;
}

// --- light on a sample -------------------------------------------------------------------------------------
struct Shaded {
    glm::vec3 color{0};  // reflectance
    float alpha = 0, threshold = 0, open = 0;
    float front[kLights] = {}, back[kLights] = {};
    void add(const Shaded& s) {
        color += s.color;
        alpha += s.alpha;
        threshold += s.threshold;
        open += s.open;
        for (int i = 0; i < kLights; ++i) front[i] += s.front[i], back[i] += s.back[i];
    }
    void scale(float k) {
        color *= k;
        alpha *= k;
        threshold *= k;
        open *= k;
        for (int i = 0; i < kLights; ++i) front[i] *= k, back[i] *= k;
    }
};

// Decoded once: linear, twice as bright, so that its mean is white (as the blades' fragment shader has it).
std::vector<glm::vec3> linearVeins(const Rgba8& image) {
    std::vector<glm::vec3> out(image.pixels.size() / 4);
    const auto linear = [](uint8_t c) {
        const float s = c / 255.0f;
        return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
    };
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = 2.0f * glm::vec3(linear(image.pixels[4 * i]), linear(image.pixels[4 * i + 1]),
                                  linear(image.pixels[4 * i + 2]));
    return out;
}

// Directions towards the lights of a slab, in the order of kLights.
std::array<glm::vec3, kLights> lightsOf(const Slab& s) {
    if (s.toward == 1) return {{{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {0, 1, 0}}};
    const glm::vec3 facing = s.toward == 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1),
                    side = s.toward == 0 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
    return {{facing, -facing, side, -side, {0, 1, 0}}};
}

struct Shader {
    const SliceSpec& spec;
    const Patch& patch;
    std::vector<glm::vec3> veins = linearVeins(spec.blade);
    BladeMask mask = spec.shadowMask > 0
                         ? makeBladeMask(spec.species, patch, spec.cellSize, spec.shadowMask, spec.blade)
                         : BladeMask{};

    // Share of light that passes the neighbours to a point of a blade.
    float passes(const Blade& b, const f32::BladeFrame& f, const glm::vec3& light, float open) const {
        if (mask.pixels.empty()) return open;
        const glm::vec3 raised =
            light.y > 0 ? light : glm::vec3(0.8191520f * light.x, 0.5735764f, 0.8191520f * light.z);
        const f32::MaskPoint p = f32::maskPointOf(f.position, b.facing, raised, mask.radius, mask.top);
        const int x = static_cast<int>(std::floor(p.turn * mask.width)),
                  y = std::min(static_cast<int>(p.height * mask.height), mask.height - 1),
                  layer = std::min(static_cast<int>(p.rise * kMaskLayers), kMaskLayers - 1);
        return static_cast<float>(mask.at(layer, y, (x % mask.width + mask.width) % mask.width)[3]) / 255.0f;
    }

    Shaded shade(const Slab& slab, const std::array<glm::vec3, kLights>& lights, const Sample& s) const {
        Shaded out;
        if (s.blade < 0) return out;
        const Blade& b = patch.blades[static_cast<size_t>(s.blade)];
        const f32::BladeFrame f = f32::bladeFrameFacing(b.control, b.tip, b.facing, s.along);
        const glm::vec3 n = f.normal[slab.toward] < 0 ? -f.normal : f.normal;
        const int x = std::clamp(static_cast<int>(s.across * spec.blade.width), 0, spec.blade.width - 1),
                  y = std::clamp(static_cast<int>(s.along * spec.blade.height), 0, spec.blade.height - 1);
        const float open = glm::mix(spec.species.rootOcclusion, 1.0f, s.along);
        out.color = f32::bladeTint(f32::bladeGradient(spec.species.rootColor, spec.species.midColor,
                                                      spec.species.tipColor, s.along),
                                   b.hue, b.lightness) *
                    veins[static_cast<size_t>(y) * spec.blade.width + x];
        out.open = open;
        out.alpha = 1;
        out.threshold = s.threshold;
        for (int i = 0; i < kLights; ++i) {
            const glm::vec3& light = lights[static_cast<size_t>(i)];
            const float toward = glm::dot(n, light) * passes(b, f, light, open);
            out.front[i] = std::max(toward, 0.0f);
            out.back[i] = std::max(-toward, 0.0f);
        }
        // From behind, the light that faces the viewer is the other one of the pair.
        if (slab.toward != 1) std::swap(out.back[0], out.back[1]);
        return out;
    }
};

// --- texels and mips ---------------------------------------------------------------------------------------
struct Layer {
    int width, height;
    std::vector<Shaded> texels;  // premultiplied means
};

Layer resolve(const Shader& shader, const Slab& slab, const std::vector<Sample>& samples) {
    Layer out{slab.width / kSamplesAcross, slab.height / kSamplesAcross, {}};
    out.texels.resize(static_cast<size_t>(out.width) * out.height);
    const auto lights = lightsOf(slab);
    for (int y = 0; y < slab.height; ++y)
        for (int x = 0; x < slab.width; ++x) {
            const Sample& s = samples[static_cast<size_t>(y) * slab.width + x];
            if (s.blade >= 0)
                out.texels[static_cast<size_t>(y / kSamplesAcross) * out.width + x / kSamplesAcross].add(
                    shader.shade(slab, lights, s));
        }
    for (Shaded& t : out.texels) t.scale(1.0f / (kSamplesAcross * kSamplesAcross));
    return out;
}

// Means of 2 x 2, of premultiplied values: opacity keeps its mean on every level (B-26).
Layer halve(const Layer& l) {
    Layer out{std::max(l.width / 2, 1), std::max(l.height / 2, 1), {}};
    out.texels.resize(static_cast<size_t>(out.width) * out.height);
    const int sx = l.width / out.width, sy = l.height / out.height;
    for (int y = 0; y < out.height * sy; ++y)
        for (int x = 0; x < out.width * sx; ++x)
            out.texels[static_cast<size_t>(y / sy) * out.width + x / sx].add(
                l.texels[static_cast<size_t>(y) * l.width + x]);
    for (Shaded& t : out.texels) t.scale(1.0f / static_cast<float>(sx * sy));
    return out;
}

std::vector<Layer> mipsOf(Layer finest) {
    std::vector<Layer> out{std::move(finest)};
    while (out.back().width > 1 || out.back().height > 1) out.push_back(halve(out.back()));
    return out;
}

uint8_t byteOf(float v) { return static_cast<uint8_t>(std::clamp(v * 255.0f + 0.5f, 0.0f, 255.0f)); }

// Writes one layer of one level.
void quantise(const Layer& l, float reflectScale, size_t layer, SliceLevel& out) {
    const size_t base = layer * l.texels.size();
    for (size_t i = 0; i < l.texels.size(); ++i) {
        const Shaded& t = l.texels[i];
        const size_t to = base + i;
        const float k = t.alpha > 0 ? 1 / t.alpha : 0;
        for (int c = 0; c < 3; ++c) out.reflectance[4 * to + c] = byteOf(t.color[c] * k / reflectScale);
        out.reflectance[4 * to + 3] = byteOf(t.open * k);
        out.threshold[4 * to] = byteOf(t.threshold);
        out.threshold[4 * to + 1] = byteOf(t.alpha);
        out.threshold[4 * to + 2] = byteOf(t.front[4] * k);
        out.threshold[4 * to + 3] = byteOf(t.back[4] * k);
        for (int c = 0; c < 4; ++c)
            out.front[4 * to + c] = byteOf(t.front[c] * k), out.back[4 * to + c] = byteOf(t.back[c] * k);
    }
}

// Texels that no blade covers take colour and light of the first coarser level that has some, so that filtering draws
// no dark edge.
void fillEmpty(std::vector<Layer>& mips) {
    for (size_t i = mips.size() - 1; i-- > 0;)
        for (int y = 0; y < mips[i].height; ++y)
            for (int x = 0; x < mips[i].width; ++x) {
                Shaded& t = mips[i].texels[static_cast<size_t>(y) * mips[i].width + x];
                if (t.alpha > 0) continue;
                const Layer& c = mips[i + 1];
                const Shaded& from = c.texels[static_cast<size_t>(y * c.height / mips[i].height) * c.width +
                                              x * c.width / mips[i].width];
                const float k = 1e-6f / std::max(from.alpha, 1e-20f);  // too little to be seen; enough to be divided by
                t = from;
                t.scale(std::min(k, 1.0f));
            }
}

std::vector<SliceLevel> emptyLevels(int width, int height, size_t layers) {
    std::vector<SliceLevel> out;
    for (int w = width, h = height;; w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
        const size_t n = static_cast<size_t>(w) * h * layers;
        out.push_back({w, h, std::vector<uint8_t>(4 * n), std::vector<uint8_t>(4 * n), std::vector<uint8_t>(4 * n),
                       std::vector<uint8_t>(4 * n)});
        if (w == 1 && h == 1) return out;
    }
}

void store(Layer finest, float reflectScale, size_t layer, std::vector<SliceLevel>& out) {
    std::vector<Layer> mips = mipsOf(std::move(finest));
    fillEmpty(mips);
    for (size_t i = 0; i < mips.size(); ++i) quantise(mips[i], reflectScale, layer, out[i]);
}

// The brightest that any sample can be: 8 bits then reach as far as they must and no farther.
float brightest(const SliceSpec& spec, const Patch& patch) {
    float most = 1e-3f;
    for (const glm::vec3& c : {spec.species.rootColor, spec.species.midColor, spec.species.tipColor})
        most = std::max({most, c.x, c.y, c.z});
    float lightness = 1, veins = 1;
    for (const Blade& b : patch.blades) lightness = std::max(lightness, b.lightness);
    for (const glm::vec3& v : linearVeins(spec.blade)) veins = std::max({veins, v.x, v.y, v.z});
    return std::min(most * lightness * veins * 1.05f, 4.0f);
}

// A power of two, so that every level is the mean of the one before.
int texels(int wanted) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(wanted, 1, 2048)))); }

}  // namespace

// --- the whole ---------------------------------------------------------------------------------------------
uint64_t sliceKey(const SliceSpec& s) {
    const Species& p = s.species;
    const uint64_t patch = patchKey(p, s.cellSize, s.seed);
    const float read[] = {p.rootColor.x,
                          p.rootColor.y,
                          p.rootColor.z,
                          p.midColor.x,
                          p.midColor.y,
                          p.midColor.z,
                          p.tipColor.x,
                          p.tipColor.y,
                          p.tipColor.z,
                          p.rootOcclusion,
                          static_cast<float>(s.slices),
                          static_cast<float>(s.width),
                          static_cast<float>(s.height),
                          static_cast<float>(s.farSize),
                          static_cast<float>(s.shadowMask),
                          static_cast<float>(s.blade.width)};
    uint64_t parts[] = {patch, hashBytes(read, sizeof(read)), hashBytes(s.blade.pixels.data(), s.blade.pixels.size())};
    return hashBytes(parts, sizeof(parts));
}

Result<SliceImages> bakeSlices(const SliceSpec& spec, JobControl& control) {
    const Patch patch = makePatch(spec.species, spec.cellSize, spec.seed);
    const std::vector<Copy> copies = copiesNear(patch, spec.cellSize);
    SliceImages out;
    out.slices = std::clamp(spec.slices, 1, kMaxSlices);
    for (const Blade& b : patch.blades) out.top = std::max({out.top, b.tip.y, b.control.y});
    out.top = std::max(out.top, 1e-3f);
    out.reflectScale = brightest(spec, patch);
    const int width = texels(spec.width), height = texels(spec.height), farSize = texels(spec.farSize), n = out.slices;
    out.vertical = emptyLevels(width, height, 2 * static_cast<size_t>(n));
    out.far = emptyLevels(farSize, farSize, 1);
    const Shader shader{spec, patch};
    std::atomic<int> done = 0;
    const auto drawSlab = [&](const Slab& slab, size_t layer, std::vector<SliceLevel>& to) {
        if (control.cancelled()) return;
        std::vector<Sample> samples(static_cast<size_t>(slab.width) * slab.height, {0, -1, 0, 0, 2});
        Canvas canvas{slab, patch, spec.blade, samples};
        const float low = slab.n ? spec.cellSize * static_cast<float>(slab.k) / static_cast<float>(slab.n) : 0,
                    high = slab.n ? spec.cellSize * static_cast<float>(slab.k + 1) / static_cast<float>(slab.n)
                                  : spec.cellSize;
        for (const Copy& c : copies) {
            const Blade& b = patch.blades[c.blade];
            const auto [from, upTo] = slab.n ? extentOf(b, c, slab.toward) : std::pair{low, high};
            if (upTo >= low && from <= high) drawBlade(canvas, b, c);
        }
        store(resolve(shader, slab, samples), out.reflectScale, layer, to);
        control.setProgress(static_cast<double>(++done) / (2 * n + 1));
    };
    parallelFor(2 * static_cast<size_t>(n) + 1, [&](size_t i) {
        if (i == 0)
            return drawSlab({0, 2, 1, spec.cellSize, spec.cellSize, farSize * kSamplesAcross, farSize * kSamplesAcross,
                             0, 0, spec.cellSize},
                            0, out.far);
        const int layer = static_cast<int>(i) - 1, axis = layer < n ? 0 : 2;
        drawSlab({2 - axis, 1, axis, spec.cellSize, out.top, width * kSamplesAcross, height * kSamplesAcross, layer % n,
                  n, spec.cellSize},
                 static_cast<size_t>(layer), out.vertical);
    });
    if (control.cancelled()) return interruption("the slices were cancelled");
    control.setProgress(1);  // threads may have told theirs out of order
    return out;
}

}  // namespace sward
