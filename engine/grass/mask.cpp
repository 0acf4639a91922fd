#include "grass/mask.h"

#include "core/hash.h"
#include "core/numerics.h"
#include "frame/draw_context.h"
#include "grass/blade_cover.h"
#include "grass/drawing.h"
#include "grass/grass_fields.h"
#include "grass/grown.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/mask";
constexpr int kFineMask = 2;         // rasterised finer by this, each way
constexpr int kMaskSteps = 12;       // pieces of a blade's curve
constexpr double kMostBlades = 2e4;  // in a section: more than that hide everything
constexpr int kMaskTries = 6;        // sections, of which the one that lets through most nearly their mean is taken
constexpr float kDepths = 24;        // optical depths of full density that a section is thick, at most

float spacingOf(const Species& s) { return 1 / std::sqrt(std::max(s.bladesPerM2, 1e-3f)); }
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

// How wide a blade is seen from the side, over all azimuths and along it. alpha: of its pieces.
float meanWidth(const Patch& patch, const std::vector<float>& alpha) {
    float sum = 0, seen = 0;
    for (const Blade& b : patch.blades) sum += b.width;
    for (const float a : alpha) seen += a / static_cast<float>(alpha.size());
    return patch.blades.empty() ? 0 : 0.63662f * seen * sum / static_cast<float>(patch.blades.size());
}

// The section of one layer, finely: in every place the lowest threshold of the blades that cover it, 2 where none does.
struct Section {
    int width, height;
    glm::vec2 metre;                  // places a metre, across and up
    float slope;                      // metres that light rises over one
    const std::vector<float>& alpha;  // of a blade's pieces: it is as much narrower
    std::vector<float> lowest;
    Section(int w, int h, const glm::vec2& perMetre, float rises, const std::vector<float>& pieces)
        : width(w),
          height(h),
          metre(perMetre),
          slope(rises),
          alpha(pieces),
          lowest(static_cast<size_t>(w) * static_cast<size_t>(h), 2.0f) {}

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
    // One piece of a blade between two places.
    void piece(const glm::vec2& a, const glm::vec2& b, float half, float threshold) {
        const float high = static_cast<float>(height);
        if (std::max(a.y, b.y) < 0 || std::min(a.y, b.y) >= high) return;
        const int steps = 1 + static_cast<int>(2 * std::min(glm::length(b - a), static_cast<float>(width + height)));
        for (int i = 0; i < steps; ++i) {
            const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(steps);
            const glm::vec2 p = glm::mix(a, b, t);
            mark(static_cast<int>(std::floor(p.y)), p.x - half, p.x + half, threshold);
        }
    }
    // A blade seen along z, with its root so far across and off; what of it lies before the section does not count.
    void blade(const Blade& b, float threshold, float across, float off) {
        const float seenWidth = 0.5f * b.width * std::abs(b.facing.y) * metre.x;
        glm::vec3 before(0);
        for (int i = 1; i <= kMaskSteps; ++i) {
            const glm::vec3 now = f32::bladePosition(b.control, b.tip, static_cast<float>(i) / kMaskSteps);
            const auto place = [&](const glm::vec3& p) {
                return glm::vec2(across + p.x, p.y - slope * (off + p.z)) * metre;
            };
            if (off + 0.5f * (before.z + now.z) > 0)
                piece(place(before), place(now), seenWidth * alpha[static_cast<size_t>(i - 1)], threshold);
            before = now;
        }
    }
};

// All blades whose roots lie in a piece of the field that repeats the patch, each with its threshold there; and those
// before it, as far as they may lean. Roots are stratified: about a blade's own, where the piece begins, is a gap.
struct MaskPiece {
    float length, thickness;  // metres
    float lean;               // how far blades may lean into it, metres
    float gap;                // without roots, to either side of its beginning, metres
    glm::vec2 from;           // its corner in the field
};
void drawSection(Section& s, const Patch& patch, float cellSize, const MaskPiece& piece) {
    const auto cells = [&](float metres) { return static_cast<int>(std::floor(metres / cellSize)); };
    for (int row = cells(piece.from.y - piece.lean); row <= cells(piece.from.y + piece.thickness); ++row)
        for (int column = cells(piece.from.x); column <= cells(piece.from.x + piece.length); ++column) {
            const float chance = f32::cellChance(column, row, 0);
            const glm::vec2 corner = glm::vec2(column, row) * cellSize - piece.from;
            for (const Blade& b : patch.blades) {
                const glm::vec2 root = corner + b.root;
                if (root.x >= 0 && root.x < piece.length && root.y < piece.thickness && std::abs(root.y) >= piece.gap &&
                    root.y + std::max(b.control.z, b.tip.z) > 0)
                    s.blade(b, f32::thresholdIn(b.threshold, patch.sown, chance), root.x, root.y);
            }
        }
}

// Share of a texel's places that are free at a density.
uint8_t freeShare(const Section& s, int x, int y, float density) {
    int open = 0;
    for (int j = 0; j < kFineMask; ++j)
        for (int i = 0; i < kFineMask; ++i)
            open += s.lowest[static_cast<size_t>((y * kFineMask + j) * s.width + x * kFineMask + i)] > density;
    return static_cast<uint8_t>((open * 255 + kFineMask * kFineMask / 2) / (kFineMask * kFineMask));
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

// Of half a mask's rows and layers, each row the mean around.
std::vector<uint8_t> meansAround(const BladeMask& m) {
    const int width = m.width / 2, height = m.height / 2;
    std::vector<uint8_t> out;
    for (int layer = 0; layer < kMaskLayers; layer += 2)
        for (int row = 0; row < 2 * height; row += 2) {
            std::array<int, 4> sum{};
            for (int i = 0; i < 4 * m.width; ++i)
                for (int c = 0; c < 4; ++c)
                    sum[static_cast<size_t>(c)] += m.at(layer + i % 2, row + i / 2 % 2, i / 4)[c];
            for (int x = 0; x < width; ++x)
                for (const int s : sum) out.push_back(static_cast<uint8_t>(s / (4 * m.width)));
        }
    return out;
}
// Level 1 is no smaller picture, but its rows' means (lib/mask.glsl); there is none beyond: a thin blade's coordinates
// leap from pixel to pixel, and the mean over all heights that they would ask for is the dark of the roots, where what
// is seen of dense grass are its tips.
Texture uploadMask(Gpu& gpu, const BladeMask& m) {
    Texture t = makeTexture3D(gpu, kOwner, GL_RGBA8, m.width, m.height, kMaskLayers, 2);
    glTextureSubImage3D(t.id(), 1, 0, 0, 0, m.width / 2, m.height / 2, kMaskLayers / 2, GL_RGBA, GL_UNSIGNED_BYTE,
                        meansAround(m).data());
    glTextureParameteri(t.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTextureSubImage3D(t.id(), 0, 0, 0, 0, m.width, m.height, kMaskLayers, GL_RGBA, GL_UNSIGNED_BYTE, m.pixels.data());
    return t;
}

void updateMask(DrawContext& ctx, MaskState::One& one, const Species& species, const FieldEntity& field) {
    const GrassField& f = field.grows;
    const int width = field.settings<GrassDrawing>().shadowMask;
    const uint32_t seed = static_cast<uint32_t>(f.seed);
    const uint64_t parts[] = {patchKey(species, f.cellSize, seed), static_cast<uint64_t>(width),
                              hashBytes(species.texture.data(), species.texture.size())},
                   key = hashBytes(parts, sizeof(parts));
    if (one.key == key && one.texture.id()) return;
    one.key = key;
    const BladeMask mask = makeBladeMask(species, makePatch(species, f.cellSize, seed), f.cellSize, width,
                                         bladeImage(ctx.project, species));
    one.texture = uploadMask(ctx.gpu, mask);
    one.shade = shadeBy(mask);
    one.shade.texture = one.texture.id();
}

void updateMasks(DrawContext& ctx) {
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

const System kSystems[] = {{"grass/mask", {.writes = {Slot::Masks}}, updateMasks, true}};

// Draws all layers; from: the corner of what they show, in metres of the field.
void drawLayers(BladeMask& m, const Species& species, const Patch& patch, float cellSize,
                const std::vector<float>& alpha, const glm::vec2& from) {
    m.pixels.assign(static_cast<size_t>(m.width) * static_cast<size_t>(m.height) * kMaskLayers * 4, 255);
    const float girth = 6.2831853f * m.radius, wide = std::max(meanWidth(patch, alpha), 1e-9f);
    const double blades = std::max(double(species.bladesPerM2), 1e-9),
                 most = std::min(kMostBlades / double(girth), double(kDepths / wide)) / blades;
    for (int layer = 0; layer < kMaskLayers; ++layer) {
        const float slope = f32::maskSlope((static_cast<float>(layer) + 0.5f) / kMaskLayers);
        Section s(m.width * kFineMask, m.height * kFineMask,
                  glm::vec2(m.width, m.height) * float(kFineMask) / glm::vec2(girth, m.top), slope, alpha);
        const auto thickness = static_cast<float>(std::min(double(m.top / slope), most));
        drawSection(s, patch, cellSize,
                    {girth, thickness, std::min(m.top, 4 * cellSize), 0.5f * spacingOf(species), from});
        for (int y = 0; y + 1 < m.height; ++y)
            for (int x = 0; x < m.width; ++x)
                for (int c = 0; c < 4; ++c)
                    m.pixels[static_cast<size_t>(((layer * m.height + y) * m.width + x) * 4 + c)] =
                        freeShare(s, x, y, 0.25f * static_cast<float>(c + 1));
    }
}

// A section is as long as some blades are wide: by chance it lets through a tenth more or less than the field.
BladeMask mostNearlyMean(std::vector<BladeMask>& tries) {
    std::vector<std::vector<float>> rows;
    for (const BladeMask& m : tries) rows.push_back(shadeBy(m).rows);
    const auto off = [&](size_t of) {
        float sum = 0;
        for (size_t row = 0; row < rows[of].size(); ++row) {
            float mean = 0;
            for (const auto& one : rows) mean += one[row] / static_cast<float>(rows.size());
            sum += (rows[of][row] - mean) * (rows[of][row] - mean);
        }
        return sum;
    };
    size_t best = 0;
    float least = off(0);
    for (size_t i = 1; i < tries.size(); ++i)
        if (const float here = off(i); here < least) best = i, least = here;
    return std::move(tries[best]);
}

}  // namespace

BladeMask makeBladeMask(const Species& species, const Patch& patch, float cellSize, int width, const Rgba8& image) {
    BladeMask m;
    const std::vector<float> alpha = alphaAlong(image, kMaskSteps);
    const float wide = meanWidth(patch, alpha);
    m.reach = std::max({0.5f * meanTip(patch), 1.5f * spacingOf(species), 1e-3f});
    m.top = std::max(1.05f * highestTip(patch), 1e-3f);
    m.width = std::max(width, 4);
    m.height = std::max(m.width, 4);
    m.radius = std::clamp(0.5f * static_cast<float>(m.width) * wide / 6.2831853f, 1e-3f, m.reach);
    std::vector<BladeMask> tries(kMaskTries, m);
    for (int i = 0; i < kMaskTries; ++i)
        drawLayers(tries[static_cast<size_t>(i)], species, patch, cellSize, alpha,
                   glm::vec2(0.381966f, 0.618034f) * float(i));
    return mostNearlyMean(tries);
}

BladeShade shadeBy(const BladeMask& m) {
    BladeShade shade{0, m.radius, m.top, m.reach, kMaskLayers, {}};
    for (int layer = 0; layer < kMaskLayers; ++layer)
        for (int y = 0; y < m.height; ++y) {
            float sum = 0;
            for (int x = 0; x < m.width; ++x) sum += m.at(layer, y, x)[3];
            shade.rows.push_back(sum / (255.0f * static_cast<float>(m.width)));
        }
    return shade;
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
