#include "water/reflection.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "water/lake.h"

namespace sward {
namespace {

constexpr const char* kOwner = "water/reflection";
constexpr float kMargin = 0.08f;        // of the picture beyond each edge, for ripples that look there
constexpr float kAroundMirror = 0.15f;  // of the picture about what is seen of a water, for ripples along its shore
constexpr float kUnder = 0.04f;         // metres below the level at which the view is cut: no gap shows along the shore
constexpr float kMirroredBlades = 0.35f;  // share of the blades that is drawn where blades are; each is wider
constexpr size_t kMostMirrors = 8;        // waters that are mirrored at a time: those that take most of the picture
constexpr int kMirrorSteps = 16;          // each way: parts begin and end at such a share of a whole picture

struct ReflectionState : EffectState {
    std::vector<ViewTargets> targets;  // by mirror
};

// A water whose mirrored picture is to be drawn, and the part of the whole one that shows on it.
struct Mirror {
    size_t water = 0;            // its number among watersOf
    double level = 0;            // metres in the world
    glm::ivec2 whole{0};         // pixels of a picture of all that the view shows, with the margin
    glm::ivec2 low{0}, high{0};  // the part's: from, to
    int pixels() const { return (high.x - low.x) * (high.y - low.y); }
};

// Where a level rectangle lies in the view: low x, y and high x, y in clip units. square: as of waterInView.
std::optional<glm::vec4> onScreen(const DrawContext& ctx, const glm::vec4& square, float height) {
    constexpr float kNearest = 1e-3f;  // of what is in front of the eye, metres
    glm::vec4 corners[4], rectangle(2, 2, -2, -2);
    for (int i = 0; i < 4; ++i)  // around the rectangle
        corners[i] = ctx.globals.viewProj *
                     glm::vec4(i == 0 || i == 3 ? square.x : square.z, height, i < 2 ? square.y : square.w, 1);
    const auto add = [&](const glm::vec4& clip) {
        const glm::vec2 at = glm::clamp(glm::vec2(clip) / clip.w, glm::vec2(-2), glm::vec2(2));
        rectangle = glm::vec4(glm::min(glm::vec2(rectangle), at), glm::max(glm::vec2(rectangle.z, rectangle.w), at));
    };
    for (int i = 0; i < 4; ++i) {
        const glm::vec4 &a = corners[i], &b = corners[(i + 1) % 4];
        if (a.w > kNearest) add(a);
        if ((a.w > kNearest) != (b.w > kNearest)) add(glm::mix(a, b, (kNearest - a.w) / (b.w - a.w)));
    }
    if (!(rectangle.x < 1 && rectangle.y < 1 && rectangle.z > -1 && rectangle.w > -1)) return std::nullopt;
    return rectangle;
}

// Of pixels of the whole picture those from a to b (clip units), in whole steps.
glm::ivec2 steps(float a, float b, int whole) {
    const float shown = 1 / (1 + 2 * kMargin);
    const int step = (whole + kMirrorSteps - 1) / kMirrorSteps;
    const auto pixel = [&](float clip) { return (0.5f + 0.5f * shown * clip) * static_cast<float>(whole); };
    return {std::clamp(static_cast<int>(std::floor(pixel(a - 2 * kAroundMirror) / static_cast<float>(step))) * step, 0,
                       whole),
            std::clamp(static_cast<int>(std::ceil(pixel(b + 2 * kAroundMirror) / static_cast<float>(step))) * step, 0,
                       whole)};
}

std::optional<Mirror> mirrorOf(DrawContext& ctx, const WaterPlace& place, size_t number) {
    const Water& water = *place.water;
    const auto square = water.reflection > 0 ? waterInView(ctx, place) : std::nullopt;
    const float height = static_cast<float>(static_cast<double>(water.level) - ctx.eye.y);
    const auto seen = square ? onScreen(ctx, *square, height) : std::nullopt;
    if (!seen) return std::nullopt;
    Mirror m;
    m.water = number;
    m.level = ctx.shared.ground.origin.y + static_cast<double>(water.level);
    const float share = std::clamp(water.reflection, 0.05f, 1.0f) * (1 + 2 * kMargin);
    m.whole = glm::max(glm::ivec2(glm::round(glm::vec2(ctx.targets.width, ctx.targets.height) * share)), 8);
    const glm::ivec2 x = steps(seen->x, seen->z, m.whole.x), y = steps(seen->y, seen->w, m.whole.y);
    m.low = {x.x, y.x}, m.high = {x.y, y.y};
    return m;
}

std::vector<Mirror> mirrorsInView(DrawContext& ctx) {
    std::vector<Mirror> mirrors;
    const std::vector<WaterPlace> places = watersOf(ctx.project, ctx.shared.ground);
    for (size_t i = 0; i < places.size(); ++i)
        if (const auto m = mirrorOf(ctx, places[i], i)) mirrors.push_back(*m);
    std::stable_sort(mirrors.begin(), mirrors.end(),
                     [](const Mirror& a, const Mirror& b) { return a.pixels() > b.pixels(); });
    if (mirrors.size() > kMostMirrors) mirrors.resize(kMostMirrors);
    return mirrors;
}

// Targets that are somewhat larger stay, and more of the picture is drawn: a view that moves makes none anew.
void ensureTargets(DrawContext& ctx, ViewTargets& t, Mirror& m) {
    const glm::ivec2 wanted = m.high - m.low, had(t.width, t.height);
    const bool fit = t.samples == ctx.targets.samples && glm::all(glm::greaterThanEqual(had, wanted)) &&
                     glm::all(glm::lessThanEqual(had, glm::min(2 * wanted, m.whole)));
    if (fit) {
        m.low = glm::min(m.low, m.whole - had);
        m.high = m.low + had;
        return;
    }
    t = {};
    t = makeTargets(ctx.gpu, kOwner, {wanted.x, wanted.y, ctx.targets.samples, false, 0, false});
}

glm::dvec3 mirroredAt(const glm::dvec3& p, double height) { return {p.x, 2 * height - p.y, p.z}; }

// From clip units of the view to those of the part: scale and shift.
struct PartOfView {
    glm::vec2 scale, shift;
};
PartOfView partOf(const Mirror& m) {
    const float shown = 1 / (1 + 2 * kMargin);
    const glm::vec2 whole(m.whole), low(m.low), high(m.high);
    return {shown * whole / (high - low), (whole - low - high) / (high - low)};
}

ViewRequest requestOf(const DrawContext& ctx, const Mirror& m, ViewTargets& targets) {
    ViewRequest r;
    const PartOfView part = partOf(m);
    // Frames that add up take samples from all over a pixel of this picture, which is larger than one of the view.
    const glm::vec2 pixels =
                        glm::vec2(ctx.targets.width, ctx.targets.height) / (glm::vec2(m.whole) / (1 + 2 * kMargin)),
                    more = ctx.shared.sampleShift * (pixels - 1.0f);
    r.mirrored = true;
    r.camera = ctx.camera;
    r.camera.eye = mirroredAt(ctx.camera.eye, m.level);
    r.camera.target = mirroredAt(ctx.camera.target, m.level);
    r.viewProj = glm::translate(glm::mat4(1), {part.shift, 0}) * glm::scale(glm::mat4(1), {part.scale, 1}) *
                 glm::translate(glm::mat4(1), {more, 0}) * ctx.globals.viewProj * glm::scale(glm::mat4(1), {1, -1, 1});
    r.cutAt = static_cast<float>(m.level - r.camera.eye.y) - kUnder;
    r.settings = ctx.settings;
    r.settings.width = targets.width, r.settings.height = targets.height;
    const float shown = 1 / (1 + 2 * kMargin);
    r.settings.part = {m.low.x, m.low.y, m.whole.x,
                       static_cast<int>(std::lround(static_cast<float>(wholeHeight(ctx.settings) * m.whole.y) * shown /
                                                    static_cast<float>(ctx.targets.height)))};
    r.settings.coarse = true;
    r.settings.detail = ctx.settings.detail * kMirroredBlades;
    r.settings.decal = {};
    r.targets = &targets;
    return r;
}

void request(DrawContext& ctx, std::vector<ViewRequest>& wanted) {
    ReflectionState& s = ctx.own<ReflectionState>();
    if (ctx.settings.mode != ViewMode::Final) return;
    std::vector<Mirror> mirrors = mirrorsInView(ctx);
    if (s.targets.size() < mirrors.size()) s.targets.resize(mirrors.size());
    for (size_t i = 0; i < mirrors.size(); ++i) {
        ensureTargets(ctx, s.targets[i], mirrors[i]);
        wanted.push_back(requestOf(ctx, mirrors[i], s.targets[i]));
        const PartOfView part = partOf(mirrors[i]);
        if (ctx.shared.reflections.size() <= mirrors[i].water) ctx.shared.reflections.resize(mirrors[i].water + 1);
        ctx.shared.reflections[mirrors[i].water] = {s.targets[i].resolved.id(), 0.5f * part.scale,
                                                    0.5f + 0.5f * part.shift};
    }
}

void drawn(DrawContext& ctx) {
    for (const Reflection& r : ctx.shared.reflections)
        if (r.texture) glGenerateTextureMipmap(r.texture);
}

const ViewRow kView{kViewReflection,
                    "mirrored ",
                    {.reads = {Slot::Ground, Slot::SampleShift}, .writes = {Slot::Reflection}},
                    request,
                    drawn};

}  // namespace

const EffectRow& reflectionEffect() {
    static const EffectRow row{
        "water/reflection",
        featureSet(Feature::Water, Feature::WaterReflection, Feature::Terrain),
        {},
        {},
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<ReflectionState>(); },
        "water mirrors the scene: sky, ground, objects and grass are drawn once more, coarsely, where it is seen",
        nullptr,
        &kView};
    return row;
}

}  // namespace sward
