#include "grass/mask.h"

#include "core/hash.h"
#include "core/numerics.h"
#include "frame/draw_context.h"
#include "grass/drawing.h"
#include "grass/grass_fields.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/mask";
constexpr int kFine = 4;             // rasterised finer by this, each way
constexpr int kSteps = 8;            // pieces of a blade's curve
constexpr double kMostBlades = 2e4;  // more than that hide everything

float meanTip(const Patch& patch) {
    float sum = 0;
    for (const Blade& b : patch.blades) sum += b.tip.y;
    return patch.blades.empty() ? 0 : sum / static_cast<float>(patch.blades.size());
}
float highestTip(const Patch& patch) {
    float most = 0;
    for (const Blade& b : patch.blades) most = std::max(most, b.tip.y);
    return most;
}

// The section, finely: in every place the lowest threshold of the blades that cover it, 2 where none does.
struct Section {
    int width, height;
    float metre;  // places a metre
    std::vector<float> lowest;
    Section(int w, int h, float perMetre)
        : width(w), height(h), metre(perMetre), lowest(static_cast<size_t>(w) * static_cast<size_t>(h), 2.0f) {}

    // Marks places from `from` to `to` in a row (both in places); columns wrap.
    void mark(int row, float from, float to, float threshold) {
        if (row < 0 || row >= height) return;
        const int first = static_cast<int>(std::ceil(from - 0.5f)),
                  last = std::min(static_cast<int>(std::ceil(to - 0.5f)), first + width);
        for (int x = first; x < last; ++x) {
            float& place = lowest[static_cast<size_t>(row) * static_cast<size_t>(width) +
                                  static_cast<size_t>((x % width + width) % width)];
            place = std::min(place, threshold);
        }
    }
    // One piece of a blade between two points, with their half widths.
    void piece(const glm::vec2& a, const glm::vec2& b, float halfA, float halfB, float threshold) {
        const int steps = 1 + static_cast<int>(2 * std::min(glm::length(b - a), 1e4f));
        for (int i = 0; i < steps; ++i) {
            const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(steps);
            const glm::vec2 p = glm::mix(a, b, t);
            const float half = glm::mix(halfA, halfB, t);
            mark(static_cast<int>(std::floor(p.y)), p.x - half, p.x + half, threshold);
        }
    }
    // A blade seen along z, with its root at x metres. Its strip tapers as its texture's alpha does.
    void blade(const Blade& b, float threshold, float x) {
        const float seenWidth = 0.5f * b.width * std::abs(b.facing.y) * metre;
        glm::vec2 before(x * metre, 0);
        for (int i = 1; i <= kSteps; ++i) {
            const float v0 = static_cast<float>(i - 1) / kSteps, v1 = static_cast<float>(i) / kSteps;
            const glm::vec3 p = f32::bladePosition(b.control, b.tip, v1);
            const glm::vec2 now((x + p.x) * metre, p.y * metre);
            piece(before, now, seenWidth * (1 - v0 * v0), seenWidth * (1 - v1 * v1), threshold);
            before = now;
        }
    }
};

// All blades whose roots lie in [0, length) x [0, thickness) of the field that repeats the patch, each with its
// threshold there.
void drawSection(Section& s, const Patch& patch, float cellSize, float length, float thickness) {
    int row = 0;
    for (float z0 = 0; z0 < thickness; z0 += cellSize, ++row) {
        int column = 0;
        for (float x0 = 0; x0 < length; x0 += cellSize, ++column) {
            const float chance = f32::cellChance(column, row, 0);
            for (const Blade& b : patch.blades)
                if (x0 + b.root.x < length && z0 + b.root.y < thickness)
                    s.blade(b, f32::thresholdIn(b.threshold, patch.sown, chance), x0 + b.root.x);
        }
    }
}

// Share of a texel's places that are free at a density.
uint8_t freeShare(const Section& s, int x, int y, float density) {
    int open = 0;
    for (int j = 0; j < kFine; ++j)
        for (int i = 0; i < kFine; ++i)
            open += s.lowest[static_cast<size_t>((y * kFine + j) * s.width + x * kFine + i)] > density;
    return static_cast<uint8_t>((open * 255 + kFine * kFine / 2) / (kFine * kFine));
}

}  // namespace

struct MaskState : EffectState {
    struct One {
        uint64_t key = 0;
        Texture texture;
        BladeShade shade;
    };
    std::map<std::string, std::vector<One>> fields;  // by name, each by species
};

namespace {

// Two levels and no more: a thin blade's coordinates leap from pixel to pixel, and the mean over all heights that they
// would ask for is the dark of the roots, where what is seen of dense grass are its tips.
Texture uploadMask(Gpu& gpu, const BladeMask& m) {
    Texture t = makeTexture2D(gpu, kOwner, GL_RGBA8, m.width, m.height, 2, true);
    glTextureParameteri(t.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTextureSubImage2D(t.id(), 0, 0, 0, m.width, m.height, GL_RGBA, GL_UNSIGNED_BYTE, m.pixels.data());
    glGenerateTextureMipmap(t.id());
    return t;
}

void updateMask(DrawContext& ctx, MaskState::One& one, const Species& species, const FieldEntity& field) {
    const GrassField& f = field.grows;
    const int width = field.settings<GrassDrawing>().shadowMask;
    const uint32_t seed = static_cast<uint32_t>(f.seed);
    const uint64_t parts[] = {patchKey(species, f.cellSize, seed), static_cast<uint64_t>(width)},
                   key = hashBytes(parts, sizeof(parts));
    if (one.key == key && one.texture.id()) return;
    one.key = key;
    const BladeMask mask = makeBladeMask(species, makePatch(species, f.cellSize, seed), f.cellSize, width);
    one.texture = uploadMask(ctx.gpu, mask);
    one.shade = {one.texture.id(), mask.radius, mask.top, maskRows(mask)};
}

void update(DrawContext& ctx) {
    MaskState& state = ctx.own<MaskState>();
    std::map<std::string, std::vector<MaskState::One>> now;
    for (const auto& [name, field] : fieldsOf(ctx.project)) {
        if (!has(fieldFeatures(ctx.tables.techniques, field), Feature::BladeShadows)) continue;
        std::vector<MaskState::One>& species = now[name] = std::move(state.fields[name]);
        species.resize(field.grows.species.size());
        for (size_t i = 0; i < species.size(); ++i) updateMask(ctx, species[i], field.grows.species[i], field);
    }
    state.fields = std::move(now);
    ctx.shared.masks = &state;
}

const System kSystems[] = {{"grass/mask", {.writes = {Slot::Masks}}, update, true}};

}  // namespace

BladeMask makeBladeMask(const Species& species, const Patch& patch, float cellSize, int width) {
    BladeMask m;
    const float spacing = 1 / std::sqrt(std::max(species.bladesPerM2, 1e-3f));
    m.radius = std::max({0.5f * meanTip(patch), 1.5f * spacing, 1e-3f});
    m.top = std::max(1.05f * highestTip(patch), 1e-3f);
    const float girth = 6.2831853f * m.radius;
    m.width = std::max(width, 4);
    m.height = std::clamp(static_cast<int>(std::lround(static_cast<float>(m.width) * m.top / girth)), 4, 4 * m.width);
    Section s(m.width * kFine, m.height * kFine, static_cast<float>(m.width * kFine) / girth);
    const double most = kMostBlades / std::max(double(species.bladesPerM2) * girth, 1e-9);
    drawSection(s, patch, cellSize, girth, static_cast<float>(std::min(2.0 * m.radius, most)));
    m.pixels.assign(static_cast<size_t>(m.width) * static_cast<size_t>(m.height) * 4, 255);
    for (int y = 0; y + 1 < m.height; ++y)
        for (int x = 0; x < m.width; ++x)
            for (int c = 0; c < 4; ++c)
                m.pixels[static_cast<size_t>((y * m.width + x) * 4 + c)] =
                    freeShare(s, x, y, 0.25f * static_cast<float>(c + 1));
    return m;
}

std::vector<float> maskRows(const BladeMask& m) {
    std::vector<float> rows(static_cast<size_t>(m.height), 0.0f);
    for (int y = 0; y < m.height; ++y)
        for (int x = 0; x < m.width; ++x)
            rows[static_cast<size_t>(y)] +=
                static_cast<float>(m.pixels[static_cast<size_t>((y * m.width + x) * 4 + 3)]) /
                (255.0f * static_cast<float>(m.width));
    return rows;
}

BladeShade shadeOf(const DrawContext& ctx, const std::string& field, size_t species) {
    if (!ctx.shared.masks) return {};
    const auto found = ctx.shared.masks->fields.find(field);
    if (found == ctx.shared.masks->fields.end() || species >= found->second.size()) return {};
    return found->second[species].shade;
}

const EffectRow& maskEffect() {
    static const EffectRow row{
        "grass/mask",
        featureSet(Feature::Grass, Feature::Terrain, Feature::BladeShadows, Feature::CastingLights),
        kSystems,
        {},
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<MaskState>(); },
        "blades stand in each other's light"};
    return row;
}

}  // namespace sward
