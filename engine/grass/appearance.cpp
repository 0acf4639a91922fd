#include "grass/appearance.h"

#include <algorithm>
#include <map>

#include "core/hash.h"
#include "core/numerics.h"
#include "scene/components.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr int kBlades = 64, kPoints = 4;
constexpr float kLeast = 0.03f;  // sine of the flattest view: flatter ones look like it

// Share of a strip's width that the blade's texture covers at v.
float opaqueShareAt(const Rgba8& image, float v) {
    const int y = std::clamp(static_cast<int>(v * image.height), 0, image.height - 1);
    int sum = 0;
    for (int x = 0; x < image.width; ++x) sum += image.pixels[(static_cast<size_t>(y) * image.width + x) * 4 + 3];
    return static_cast<float>(sum) / (255.0f * image.width);
}

// Length of a blade's quarter p of kPoints: its curve is not run through evenly.
float lengthOfPart(const Blade& b, int p) {
    constexpr int kPieces = 4;
    const auto at = [&](int i) {
        return f32::bladePosition(b.control, b.tip, static_cast<float>(kPieces * p + i) / (kPieces * kPoints));
    };
    float sum = 0;
    for (int i = 0; i < kPieces; ++i) sum += glm::length(at(i + 1) - at(i));
    return sum;
}

// A point as it stands in a cell: mirrored, leant by paint.
struct Posed {
    glm::vec3 color, normal;
    float height, area, open;
};
// `clumps`: by how much clumps lean them, each another way; `press`: how far they are laid down, each its own way.
std::vector<Posed> posed(const Look& look, const glm::vec2& lean, float clumps, float press = 0) {
    std::vector<Posed> out;
    out.reserve(look.points.size() * 4);
    for (size_t i = 0; i < look.points.size(); ++i)
        for (int m = 0; m < 4; ++m) {
            const LookPoint& p = look.points[i];
            const float turn = 2.399963f * static_cast<float>(4 * (i / kPoints) + m), most = 1.414214f * clumps;
            const glm::vec2 mirror(m & 1 ? -1.0f : 1.0f, m & 2 ? -1.0f : 1.0f);
            const glm::vec2 along = f32::forcedLean(lean + most * glm::vec2(std::cos(turn), std::sin(turn)),
                                                    glm::vec2(0), press, p.facing * mirror);
            const f32::BladePose pose = f32::poseBlade(p.control, p.tip, p.facing, mirror, along, 1);
            const f32::BladeFrame f = f32::bladeFrameFacing(pose.control, pose.tip, pose.facing, p.along);
            out.push_back({p.color, f.normal, f.position.y, p.area / 4, p.open});
        }
    std::sort(out.begin(), out.end(), [](const Posed& a, const Posed& b) { return a.height > b.height; });
    return out;
}

float areaTowards(const std::vector<Posed>& points, const glm::vec3& e) {
    float sum = 0;
    for (const Posed& p : points) sum += p.area * std::abs(glm::dot(p.normal, e));
    return sum;
}

// Towards a level view: the mean over azimuths.
float areaAcross(const std::vector<Posed>& points) {
    float sum = 0;
    for (const Posed& p : points) sum += p.area * 0.63662f * std::sqrt(std::max(1 - p.normal.y * p.normal.y, 0.0f));
    return sum;
}

glm::vec3 facing(const glm::vec3& n, const glm::vec3& e) { return glm::dot(n, e) < 0 ? -n : n; }

// Mean radiance of what is seen along e, the direction towards the eye.
struct Mean {
    glm::vec3 radiance{0};
    float weight = 0;
    glm::vec3 value() const { return radiance / std::max(weight, 1e-9f); }
};

// Share of light from a direction that reaches a point among its neighbours.
float passes(const Posed& p, const FieldLight& l, const glm::vec3& light) {
    if (!l.shade || l.shade->rows.empty()) return p.open;
    const float full = maskPasses(*l.shade, p.height, light);
    return l.density == 1 ? full : std::pow(full, l.density);
}

glm::vec3 bladeLight(const Posed& p, const glm::vec3& e, const FieldLight& l) {
    const glm::vec3 n = facing(p.normal, e);
    glm::vec3 sum = p.color * glm::mix(l.ground, l.sky, 0.5f + 0.5f * n.y) * p.open;
    for (const auto& [direction, color] : l.suns) {
        const float toward = glm::dot(n, direction);
        glm::vec3 sent =
            p.color * std::max(toward, 0.0f) + f32::leafThrough(p.color) * (l.translucency * std::max(-toward, 0.0f));
        if (l.gloss > 0) sent += glm::vec3(l.gloss * f32::waxyLobe(n, direction, e, l.roughness));
        sum += color * sent * passes(p, l, direction);
    }
    return sum;
}

// What a slice that faces `way` stores of a point: its normal's parts along the axes and against them, each with what
// of that light passes.
struct Stored {
    glm::vec3 plus, minus;
};
Stored stored(const Posed& p, const glm::vec3& n, const FieldLight& l) {
    const float side = passes(p, l, {0.8191520f, 0.5735764f, 0}), above = passes(p, l, {0, 1, 0});
    const glm::vec3 share(side, above, side);
    return {glm::max(n, glm::vec3(0)) * share, glm::max(-n, glm::vec3(0)) * share};
}
glm::vec3 sliceLight(const Posed& p, const glm::vec3& n, const FieldLight& l, const glm::vec3& ambient,
                     const std::vector<glm::vec4>& weights) {
    glm::vec3 sum = p.color * ambient * p.open;
    const Stored s = stored(p, n, l);
    for (size_t i = 0; i < weights.size(); ++i) {
        glm::vec3 plus = glm::max(l.suns[i].first, glm::vec3(0)), minus = glm::max(-l.suns[i].first, glm::vec3(0));
        if (l.weighting != LightWeighting::Cosine) {
            const glm::vec4& w = weights[i];
            plus = {w.x, w.y, w.z}, minus = {w.w, 0, 1 - (w.x + w.y + w.z + w.w)};
        }
        float toward = glm::dot(s.plus, plus) + glm::dot(s.minus, minus),
              away = glm::dot(s.plus, minus) + glm::dot(s.minus, plus);
        if (l.weighting == LightWeighting::Cosine)
            std::tie(toward, away) = std::pair{std::max(toward - away, 0.0f), std::max(away - toward, 0.0f)};
        sum += l.suns[i].second * (p.color * toward + f32::leafThrough(p.color) * (l.translucency * away));
    }
    return sum;
}

// Calls see(point, share of it that is seen) for the points from the top down.
template <class F>
void eachSeen(const std::vector<Posed>& points, const glm::vec3& e, float density, F see) {
    const float k = density * areaTowards(points, e) / std::max(std::abs(e.y), kLeast);
    float all = 0, above = 0;
    for (const Posed& p : points) all += p.area;
    for (const Posed& p : points) {
        see(p, std::exp(-k * (above + 0.5f * p.area) / std::max(all, 1e-9f)));
        above += p.area;
    }
}

// The light as it counts in the mean for blades that are seen along e, beside the hot spot.
FieldLight tracedAlong(const FieldLight& light, const glm::vec3& e, float across) {
    FieldLight l = light;
    if (!l.traced) return l;
    const TracedFactors& traced = l.traced->blades;
    l.sky *= tracedRise(traced.sky, e.y), l.ground *= tracedRise(traced.ground, e.y);
    if (l.shade)
        for (auto& [direction, color] : l.suns)
            color *= glm::mix(glm::vec3(1), tracedBeside(traced, e, direction), f32::tracedShare(l.density, across));
    return l;
}

Mean asBlades(const std::vector<Posed>& points, const glm::vec3& e, const FieldLight& light) {
    const FieldLight l = tracedAlong(light, e, light.density == 1 ? 1 : areaAcross(points));
    Mean m;
    eachSeen(points, e, l.density, [&](const Posed& p, float seen) {
        const float w = p.area * std::abs(glm::dot(p.normal, e)) * seen;
        m.radiance += bladeLight(p, e, l) * w;
        m.weight += w;
    });
    return m;
}
// Both families of vertical slices, each by how much it is turned towards e.
Mean asSlices(const std::vector<Posed>& points, const glm::vec3& e, const FieldLight& l, const glm::vec3& ambient,
              const std::vector<glm::vec4>& weights) {
    Mean m;
    eachSeen(points, e, l.density, [&](const Posed& p, float seen) {
        for (int axis = 0; axis <= 2; axis += 2) {
            glm::vec3 way(0);
            way[axis] = e[axis] < 0 ? -1.0f : 1.0f;
            const float w = p.area * std::abs(p.normal[axis]) * e[axis] * e[axis] * seen;
            m.radiance += sliceLight(p, facing(p.normal, way), l, ambient, weights) * w;
            m.weight += w;
        }
    });
    return m;
}
Mean asFar(const std::vector<Posed>& points, const FieldLight& l, const glm::vec3& ambient,
           const std::vector<glm::vec4>& weights) {
    Mean m;
    const glm::vec3 up(0, 1, 0);
    eachSeen(points, up, l.density, [&](const Posed& p, float seen) {
        const float w = p.area * std::abs(p.normal.y) * seen;
        m.radiance += sliceLight(p, facing(p.normal, up), l, ambient, weights) * w;
        m.weight += w;
    });
    return m;
}

// What a texel of the horizontal slice sends, by shaders' form of light (lib/far_light.glsl).
glm::vec3 texelSends(const FarTexel& t, const glm::vec3& direction, const glm::vec4& w, const FieldLight& l) {
    float toward, away;
    if (l.weighting == LightWeighting::Cosine) {
        const glm::vec3 plus(t.sides.x, t.above, t.sides.z), minus(t.sides.y, t.below, t.sides.w);
        const float facing = glm::dot(plus - minus, direction),
                    spread = 2 * glm::dot(glm::min(plus, minus), glm::abs(direction)),
                    both = std::sqrt(facing * facing + spread * spread);
        toward = 0.5f * (both + facing), away = 0.5f * (both - facing);
    } else {
        const glm::vec4 images(w.x, w.w, w.z, 1 - (w.x + w.y + w.z + w.w));
        toward = glm::dot(t.sides, images) + t.above * w.y;
        away = glm::dot(glm::vec4(t.sides.y, t.sides.x, t.sides.w, t.sides.z), images) + t.below * w.y;
    }
    return t.color * toward + f32::leafThrough(t.color) * (l.translucency * away);
}
// What an image of the horizontal slice sends on average, over cells that are mirrored all ways.
glm::vec3 imageSends(const std::vector<FarTexel>& image, const FieldLight& l, const glm::vec3& ambient) {
    glm::vec3 sum(0);
    float weight = 0;
    std::vector<std::array<glm::vec4, 4>> weights;
    const auto mirrored = [](const glm::vec3& d, size_t m) {
        return d * glm::vec3(m & 1 ? -1.0f : 1.0f, 1, m & 2 ? -1.0f : 1.0f);
    };
    for (const auto& [direction, color] : l.suns) {
        std::array<glm::vec4, 4>& four = weights.emplace_back();
        for (size_t m = 0; m < 4; ++m) four[m] = imageWeights(mirrored(direction, m), l.weighting);
    }
    for (const FarTexel& t : image) {
        glm::vec3 sent = t.color * ambient * t.open;
        for (size_t i = 0; i < l.suns.size(); ++i)
            for (size_t m = 0; m < 4; ++m)
                sent += 0.25f * l.suns[i].second * texelSends(t, mirrored(l.suns[i].first, m), weights[i][m], l);
        sum += t.opacity * sent, weight += t.opacity;
    }
    return sum / std::max(weight, 1e-9f);
}

float luminance(const glm::vec3& c) { return glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }
// Of lamps, as a polynomial of the sine of their elevations.
glm::vec3 lampHotSpot(const TracedFactors& traced) {
    constexpr float kSines[] = {0.1f, 0.5f, 0.9f};
    glm::mat3 rises;
    glm::vec3 shares;
    for (int i = 0; i < 3; ++i) {
        const float y = kSines[i];
        rises[i] = f32::tracedRise(y);
        shares[i] = luminance(tracedHotSpot(traced, {std::sqrt(1 - y * y), y, 0}));
    }
    return glm::inverse(glm::transpose(rises)) * shares;
}

// share: of a quarter turn up, as a sine's root.
glm::vec3 directionOf(float azimuth, float share) {
    const float y = std::clamp(share * share, kLeast, 0.999f), h = std::sqrt(1 - y * y);
    return {h * std::cos(azimuth), y, h * std::sin(azimuth)};
}
glm::vec3 viewOf(int i) {
    return directionOf(6.2831853f * static_cast<float>(i % LOOK_AZIMUTHS) / LOOK_AZIMUTHS,
                       static_cast<float>(i / LOOK_AZIMUTHS) / (LOOK_ELEVATIONS - 1));
}

// Where there is no light, 1.
float quotient(float a, float b, float least = 0.02f) { return b > 1e-9f ? std::clamp(a / b, least, 5.0f) : 1.0f; }
glm::vec3 quotient(const glm::vec3& a, const glm::vec3& b) {
    return {quotient(a.x, b.x), quotient(a.y, b.y), quotient(a.z, b.z)};
}

// What the horizontal slice is to send along e: what rays have seen blades send, where they were traced.
glm::vec3 aimAlong(const FieldLight& light, const std::vector<Posed>& points, const glm::vec3& e) {
    if (!light.traced || !light.shade) return asBlades(points, e, light).value();
    const TracedShows& shows = light.traced->shows;
    glm::vec3 sum = light.sky * shownRise(shows.sky, e.y) + light.ground * shownRise(shows.ground, e.y);
    for (const auto& [direction, color] : light.suns) sum += color * shownDirect(shows, e, direction);
    if (light.density == 1) return sum;
    FieldLight full = light;
    full.density = 1;
    return sum * quotient(asBlades(points, e, light).value(), asBlades(points, e, full).value());
}

// By view, how many times as bright blades are that lie: their faces turn up, and none stands in another's light
// (lib/blade.glsl). Over blades that stand; and over what the horizontal slice sends of them.
void addLaidGains(const Look& look, const FieldLight& light, Gains& out) {
    const auto standing = posed(look, glm::vec2(0), look.clumpLean), laid = posed(look, glm::vec2(0), 0, 1);
    const BladeShade none{.rows = {1.0f}};
    FieldLight open = light;
    TracedLight indirect;  // light from all around is as among blades that stand, direct light as without them
    if (light.traced) {
        indirect = *light.traced, indirect.blades.direct = {};
        indirect.blades.direct[0] = glm::vec3(1);
        open.traced = &indirect;
    }
    if (light.shade) open.shade = &none;
    for (int i = 0; i < LOOK_VIEWS; ++i) {
        const auto at = static_cast<size_t>(i);
        const glm::vec3 e = viewOf(i), bright = asBlades(laid, e, open).value();
        out.laid[at] = glm::vec4(quotient(bright, asBlades(standing, e, light).value()), 0);
    }
}

}  // namespace

float maskPasses(const BladeShade& shade, float height, const glm::vec3& light) {
    const f32::MaskPoint at = f32::maskPointOf({0, height, 0}, {1, 0}, light, shade.radius, shade.top);
    const size_t n = shade.rows.size();
    return shade.rows[std::min(static_cast<size_t>(at.height * static_cast<float>(n)), n - 1)];
}

void updateLook(Look& look, uint64_t& madeFrom, const Species& s, const Patch& patch, uint64_t key,
                const Rgba8& blade) {
    const float colors[] = {s.rootColor.x, s.rootColor.y,   s.rootColor.z, s.midColor.x, s.midColor.y,
                            s.midColor.z,  s.tipColor.x,    s.tipColor.y,  s.tipColor.z, s.rootOcclusion,
                            s.clumpSize,   s.clumpStrength, s.leanDeg};
    const uint64_t parts[] = {key, hashBytes(colors, sizeof(colors))};
    const uint64_t now = hashBytes(parts, sizeof(parts));
    if (madeFrom == now) return;
    madeFrom = now;
    look = {};
    const size_t n = std::min<size_t>(patch.blades.size(), kBlades);
    for (size_t i = 0; i < n; ++i) {
        const Blade& b = patch.blades[i * patch.blades.size() / n];
        look.height += b.tip.y / static_cast<float>(n);
        for (int p = 0; p < kPoints; ++p) {
            const float v = (static_cast<float>(p) + 0.5f) / kPoints, open = glm::mix(s.rootOcclusion, 1.0f, v);
            const glm::vec3 color =
                f32::bladeTint(f32::bladeGradient(s.rootColor, s.midColor, s.tipColor, v), b.hue, b.lightness);
            look.points.push_back(
                {color, b.control, b.tip, b.facing, v,
                 b.width * opaqueShareAt(blade, v) * lengthOfPart(b, p) * s.bladesPerM2 / static_cast<float>(n), open});
        }
    }
    // Values of clumps are noise in [-1, 1] of deviation 0.4.
    if (s.clumpSize > 0)
        look.clumpLean =
            0.4f * 0.8f * s.clumpStrength * std::tan(glm::radians(std::min(s.leanVariationDeg + s.leanDeg, 80.0f)));
    const auto points = posed(look, glm::vec2(0), look.clumpLean), laid = posed(look, glm::vec2(0), 0, 1);
    look.across = areaAcross(points), look.above = areaTowards(points, {0, 1, 0});
    look.laidAcross = areaAcross(laid), look.laidAbove = areaTowards(laid, {0, 1, 0});
}

float lightLeft(const Look& look, float sinElevation) {
    const float y = std::max(sinElevation, 0.15f), across = look.across * std::sqrt(std::max(1 - y * y, 0.0f));
    return std::exp(-std::sqrt(across * across + look.above * look.above * y * y) / y);
}

glm::vec4 imageWeights(const glm::vec3& l, LightWeighting weighting) {
    const f32::LightOctant o = f32::lightOctant(l);
    glm::vec3 w;
    switch (weighting) {
        case LightWeighting::Poly9:
            w = f32::weightsPoly9(o);
            break;
        case LightWeighting::Poly7:
            w = f32::weightsPoly7(o);
            break;
        case LightWeighting::Poly5:
            w = f32::weightsPoly5(o);
            break;
        case LightWeighting::Poly3:
            w = f32::weightsPoly3(o);
            break;
        case LightWeighting::Linear:
            w = f32::weightsLinear(o);
            break;
        case LightWeighting::Squares:
            w = f32::weightsSquares(o);
            break;
        case LightWeighting::Published:
            w = f32::weightsPublished(l);
            if (!(std::abs(w.x + w.y + w.z - 1) < 0.01f))
                w = f32::weightsThreeAtan(o);  // no number on axes, too much below the horizon
            break;
        default:
            w = f32::weightsThreeAtan(o);
            break;
    }
    const f32::LightWeights five = f32::spreadWeights(l, w);
    return {five.xPos, five.yPos, five.zPos, five.xNeg};
}

Gains gainsOf(const Look& look, const FieldLight& light, const FarImage& image) {
    Gains out;
    if (light.traced && light.shade && !light.suns.empty())
        out.hotSpot = tracedHotSpot(light.traced->blades, light.suns[0].first);
    if (light.traced && light.lampsCast) out.lampHotSpot = lampHotSpot(light.traced->blades);
    out.sliceAmbient = 0.5f * (light.sky + light.ground);
    out.farAmbient = 0.25f * light.ground + 0.75f * light.sky;
    out.laid.fill(glm::vec4(1, 1, 1, 0));
    if (light.pressed) addLaidGains(look, light, out);
    std::vector<glm::vec4> weights;
    for (const auto& [direction, color] : light.suns) weights.push_back(imageWeights(direction, light.weighting));
    const auto plain = posed(look, glm::vec2(0), 0), clumped = posed(look, glm::vec2(0), look.clumpLean);
    const auto far = image.levels[0].empty() ? asFar(plain, light, out.farAmbient, weights).value()
                                             : imageSends(image.levels[0], light, out.farAmbient);
    for (size_t i = 1; i < FAR_LEVELS && !image.levels[i].empty(); ++i)
        out.farLevels[i] = quotient(luminance(far), luminance(imageSends(image.levels[i], light, out.farAmbient)));
    FieldLight sparse = light;
    sparse.density = kThinDensity;
    std::vector<Posed> leant[4];
    for (int i = 0; i < 4 && light.lean > 0; ++i)
        leant[i] = posed(look,
                         light.lean * glm::vec2(i == 0   ? 1
                                                : i == 1 ? -1
                                                         : 0,
                                                i == 2   ? 1
                                                : i == 3 ? -1
                                                         : 0),
                         look.clumpLean);
    for (int i = 0; i < LOOK_VIEWS; ++i) {
        const glm::vec3 e = viewOf(i), blades = asBlades(clumped, e, light).value();
        out.slices[static_cast<size_t>(i)] =
            glm::vec4(quotient(blades, asSlices(plain, e, light, out.sliceAmbient, weights).value()), 0);
        out.far[static_cast<size_t>(i)] = glm::vec4(quotient(aimAlong(light, clumped, e), far), 0);
        out.thin[static_cast<size_t>(i)] =
            light.painted ? glm::vec4(quotient(aimAlong(sparse, clumped, e), far), 0) : glm::vec4(1, 1, 1, 0);
        if (light.lean <= 0) continue;
        const auto change = [&](int plus) {
            const float a = luminance(asBlades(leant[plus], e, light).value()),
                        b = luminance(asBlades(leant[plus + 1], e, light).value());
            return std::clamp(0.5f * (a - b) / std::max(luminance(blades), 1e-9f), -0.9f, 0.9f) / light.lean;
        };
        out.slices[static_cast<size_t>(i)].w = change(0);
        out.far[static_cast<size_t>(i)].w = change(2);
    }
    return out;
}

LampGains lampGainsOf(const Look& look, FieldLight leaves, const FarImage& image) {
    leaves.sky = leaves.ground = glm::vec3(0);
    FieldLight images = leaves;  // of lamps they know what falls on the side that is seen
    images.translucency = 0, images.weighting = LightWeighting::Poly9;
    const auto plain = posed(look, glm::vec2(0), 0), clumped = posed(look, glm::vec2(0), look.clumpLean);
    constexpr size_t kLampLevel = 3;                 // few texels: there are hundreds of directions
    constexpr float kAzimuths[] = {0.196f, 0.982f};  // of all, by the symmetry of mirrored cells
    LampGains out;
    for (size_t i = 0; i < out.size(); ++i) {
        const auto share = [&](size_t n) {
            return static_cast<float>(i / n % LAMP_ELEVATIONS) / (LAMP_ELEVATIONS - 1);
        };
        const float between = std::acos(1 - 2 * static_cast<float>(i % LAMP_AZIMUTHS) / (LAMP_AZIMUTHS - 1));
        glm::vec3 blades(0), aim(0), vertical(0), horizontal(0);
        for (size_t k = 0; k < std::size(kAzimuths); ++k) {
            const float turn = kAzimuths[k];
            const glm::vec3 e = directionOf(turn, share(LAMP_AZIMUTHS)),
                            lamp = directionOf(turn + between, share(LAMP_AZIMUTHS * LAMP_ELEVATIONS));
            leaves.suns = images.suns = {{lamp, glm::vec3(1)}};
            const std::vector<glm::vec4> weights{imageWeights(lamp, images.weighting)};
            blades += asBlades(clumped, e, leaves).value();
            aim += aimAlong(leaves, clumped, e);
            vertical += asSlices(plain, e, images, glm::vec3(0), weights).value();
            horizontal += image.levels[kLampLevel].empty() ? asFar(plain, images, glm::vec3(0), weights).value()
                                                           : imageSends(image.levels[kLampLevel], images, glm::vec3(0));
        }
        // Blades are all but black before a lamp.
        out[i] = {quotient(luminance(blades), luminance(vertical), 0.02f),
                  quotient(luminance(aim), luminance(horizontal), 0.02f)};
    }
    return out;
}

}  // namespace sward
