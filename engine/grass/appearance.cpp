#include "grass/appearance.h"

#include <algorithm>
#include <map>

#include "core/hash.h"
#include "core/luminance.h"
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
    const float full = maskPasses(*l.shade, p.height, light), others = amongLeave(l.among, p.height, light);
    return others * (l.density == 1 ? full : std::pow(full, l.density));
}

glm::vec3 bladeLight(const Posed& p, const glm::vec3& e, const FieldLight& l) {
    const glm::vec3 n = facing(p.normal, e);
    const float open = p.open * amongLeave(l.among, p.height, glm::vec3(0));
    glm::vec3 sum = p.color * glm::mix(l.ground, l.sky, 0.5f + 0.5f * n.y) * open;
    for (const auto& [direction, color] : l.suns) {
        const float toward = glm::dot(n, direction);
        glm::vec3 sent =
            p.color * std::max(toward, 0.0f) + f32::leafThrough(p.color) * (l.translucency * std::max(-toward, 0.0f));
        if (l.gloss > 0) sent += glm::vec3(l.gloss * f32::waxyLobe(n, direction, e, l.roughness));
        sum += color * sent * passes(p, l, direction);
    }
    return sum;
}

// Calls see(point, share of it that is seen past the others and what stands among them) for the points from the top
// down.
template <class F>
void eachSeen(const std::vector<Posed>& points, const glm::vec3& e, float density, const std::vector<Among>& among,
              F see) {
    const float k = density * areaTowards(points, e) / std::max(std::abs(e.y), kLeast);
    float all = 0, above = 0;
    for (const Posed& p : points) all += p.area;
    for (const Posed& p : points) {
        see(p, amongLeave(among, p.height, e) * std::exp(-k * (above + 0.5f * p.area) / std::max(all, 1e-9f)));
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
    eachSeen(points, e, l.density, l.among, [&](const Posed& p, float seen) {
        const float w = p.area * std::abs(glm::dot(p.normal, e)) * seen;
        m.radiance += bladeLight(p, e, l) * w;
        m.weight += w;
    });
    return m;
}
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

// Where there is no light, 1.
float quotient(float a, float b, float least = 0.02f) { return b > 1e-9f ? std::clamp(a / b, least, 5.0f) : 1.0f; }
glm::vec3 quotient(const glm::vec3& a, const glm::vec3& b) {
    return {quotient(a.x, b.x), quotient(a.y, b.y), quotient(a.z, b.z)};
}

// Whether what paths have seen holds: they know no sun that shines through blades.
bool asTraced(const FieldLight& light) { return light.traced && (light.shade || light.suns.empty()); }

glm::vec3 tracedShow(const TracedShows& shows, const FieldLight& light, const glm::vec3& e) {
    glm::vec3 sum = light.sky * shownRise(shows.sky, e.y) + light.ground * shownRise(shows.ground, e.y);
    for (const auto& [direction, color] : light.suns) sum += color * shownDirect(shows.direct, e, direction);
    return sum;
}
// What slices are to send along e: what rays have seen blades send, where they were traced.
glm::vec3 aimAlong(const FieldLight& light, const std::vector<Posed>& points, const glm::vec3& e) {
    if (!asTraced(light)) return asBlades(points, e, light).value();
    const glm::vec3 sum = tracedShow(light.traced->shows, light, e);
    if (light.density == 1 && light.among.empty()) return sum;
    FieldLight full = light;  // as traced: alone
    full.density = 1, full.among.clear();
    return sum * quotient(asBlades(points, e, light).value(), asBlades(points, e, full).value());
}

// By view, how many times as bright blades are that lie: their faces turn up, and shade each other less
// (numerics/lying.h). Over what slices send of those that stand.
void addLaidGains(const Look& look, const FieldLight& light, Gains& out) {
    const auto standing = posed(look, glm::vec2(0), look.clumpLean), laid = posed(look, glm::vec2(0), 0, 1);
    const BladeShade lying{.rows = {f32::lyingLit(look.laidAbove)}};
    FieldLight open = light;
    TracedLight indirect;  // light from all around is as among blades that stand, direct light as without them
    if (light.traced) {
        indirect = *light.traced, indirect.blades.direct = {};
        for (size_t i = 0; i < TRACED_DIRECT; i += TRACED_TERMS) indirect.blades.direct[i] = glm::vec3(1);
        open.traced = &indirect;
    }
    if (light.shade) open.shade = &lying;
    for (int i = 0; i < LOOK_VIEWS; ++i) {
        const auto at = static_cast<size_t>(i);
        const glm::vec3 e = lookView(i), bright = asBlades(laid, e, open).value();
        out.laid[at] = quotient(bright, aimAlong(light, standing, e));
    }
}

constexpr size_t kRowTexels = 64;  // that are read of a row

// By how much brighter each level is drawn than it says, so that all are as bright as the first.
void addLevels(const DrawnImages& images, const FieldLight& light, Gains& out) {
    const glm::vec3 far = imageSends(images.far[0], light, out.farAmbient);
    for (size_t i = 1; i < FAR_LEVELS; ++i)
        out.farLevels[i] = quotient(luminance(far), luminance(imageSends(images.far[i], light, out.farAmbient)));
    std::array<RowsSend, SLICE_LEVELS> rows;
    for (size_t i = 0; i < SLICE_LEVELS; ++i)
        rows[i] = rowsSend(images.standing, i, light, out.sliceAmbient, kRowTexels);
    for (size_t high = 0; high < LOOK_ELEVATIONS; ++high) {
        const auto shown = [&](size_t level) {
            return luminance(sentAlong(images.shown.levels[high][level], rows[level], usualView(high)));
        };
        for (size_t i = 0; i < SLICE_LEVELS; ++i) out.sliceLevels[high][i] = quotient(shown(kShownLevel), shown(i));
    }
}

// By how much brighter slices are drawn that stand for a few of the blades: they show what stands lower.
void addThinner(const DrawnImages& images, const RowsSend& rows, Gains& out) {
    for (size_t i = 0; i < LOOK_ELEVATIONS; ++i) {
        const glm::vec3 e = usualView(i);
        out.thinner[i] = quotient(luminance(sentAlong(images.shown.full[i], rows, e)),
                                  luminance(sentAlong(images.shown.thin[i], rows, e)));
    }
}

// By what share grass brightens as it leans: x, z, xx, zz, xz.
using LeanShares = std::array<glm::vec3, 5>;
// What paths have seen of leaning grass, as LeaningShows has it.
std::array<glm::vec3, kTracedLeans> leaningSends(const FieldLight& light, const glm::vec3& e) {
    const LeaningShows& leaning = light.traced->leaning;
    std::array<glm::vec3, kTracedLeans> out;
    for (size_t k = 0; k < out.size(); ++k) {
        out[k] = light.sky * shownRise(leaning.sky[k], e.y);
        for (const auto& [direction, color] : light.suns) {
            const bool sine = k % 2 == 0 && k > 0, mirrored = e.x * direction.z - e.z * direction.x < 0;
            out[k] += (sine && mirrored ? -1.0f : 1.0f) * color * shownDirect(leaning.direct[k], e, direction);
        }
    }
    return out;
}
// The polynomial that is upright grass where there is no lean, and these at the full one.
LeanShares tracedLeans(const FieldLight& light, const glm::vec3& e) {
    const TracedLight& traced = *light.traced;
    const auto sends = leaningSends(light, e);
    glm::vec3 upright = light.sky * shownRise(traced.shows.sky, e.y);
    for (const auto& [direction, color] : light.suns) upright += color * shownDirect(traced.shows.direct, e, direction);
    const glm::vec3 all = glm::max(upright + light.ground * shownRise(traced.shows.ground, e.y), glm::vec3(1e-9f));
    const glm::vec2 u = glm::normalize(glm::vec2(e.x, e.z)), v(-u.y, u.x);  // along the eye's azimuth, and aside
    const glm::vec3 mean = sends[0] - upright;
    LeanShares out{sends[1] * u.x + sends[2] * v.x, sends[1] * u.y + sends[2] * v.y,
                   mean + sends[3] * (u.x * u.x - v.x * v.x) + sends[4] * (2 * u.x * v.x),
                   mean + sends[3] * (u.y * u.y - v.y * v.y) + sends[4] * (2 * u.y * v.y),
                   2.0f * sends[3] * (u.x * u.y - v.x * v.y) + 2.0f * sends[4] * (u.x * v.y + u.y * v.x)};
    const float full = traced.leaning.lean;
    for (size_t k = 0; k < out.size(); ++k) out[k] /= all * (k < 2 ? full : full * full);
    return out;
}

// A few of a look's blades.
Look fewOf(const Look& look) {
    constexpr size_t kEach = 3;
    Look out = look;
    out.points.clear();
    for (size_t i = 0; i < look.points.size(); ++i)
        if (i / kPoints % kEach == 0) out.points.push_back(look.points[i]);
    for (LookPoint& p : out.points)
        p.area *= static_cast<float>(look.points.size()) / static_cast<float>(out.points.size());
    return out;
}
// The polynomial through what blades send that lean along x, along z and between.
void addLocalLeans(const Look& whole, const FieldLight& light, Gains& out) {
    const Look look = fewOf(whole);
    constexpr std::array<glm::vec2, 6> kWays{
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {0.7071f, 0.7071f}, {-0.7071f, -0.7071f}}};
    const auto standing = posed(look, {0, 0}, look.clumpLean);
    std::array<std::vector<Posed>, 6> leant;
    for (size_t k = 0; k < leant.size(); ++k) leant[k] = posed(look, light.lean * kWays[k], look.clumpLean);
    const float square = light.lean * light.lean;
    for (int i = 0; i < LOOK_VIEWS; ++i) {
        const glm::vec3 e = lookView(i), upright = asBlades(standing, e, light).value();
        std::array<glm::vec3, 6> more;
        for (size_t k = 0; k < more.size(); ++k)
            more[k] = glm::clamp(quotient(asBlades(leant[k], e, light).value(), upright) - 1.0f, -0.9f, 0.9f);
        const auto both = [&](size_t k) { return 0.5f * (more[k] + more[k + 1]) / square; };
        const LeanShares shares{0.5f * (more[0] - more[1]) / light.lean, 0.5f * (more[2] - more[3]) / light.lean,
                                both(0), both(2), 2.0f * both(4) - both(0) - both(2)};
        for (size_t k = 0; k < shares.size(); ++k) out.leans[k][static_cast<size_t>(i)] = shares[k];
    }
}

void addLeans(const Look& look, const FieldLight& light, Gains& out) {
    if (!asTraced(light) || !(light.traced->leaning.lean > 0)) return addLocalLeans(look, light, out);
    for (int i = 0; i < LOOK_VIEWS; ++i) {
        const LeanShares shares = tracedLeans(light, lookView(i));
        for (size_t k = 0; k < shares.size(); ++k) out.leans[k][static_cast<size_t>(i)] = shares[k];
    }
}

// By how much paint is brighter on slices than their gains for blades' own colours make it.
void addPaint(const std::vector<Posed>& standing, const DrawnImages& images, const FieldLight& light, Gains& out) {
    const glm::vec3 color(TRACED_GREY);
    std::vector<Posed> grey = standing;
    for (Posed& p : grey) p.color = color;
    const DrawnImages greys = colored(images, kShownLevel, color);
    const RowsSend rows = rowsSend(greys.standing, kShownLevel, light, out.sliceAmbient, kRowTexels);
    const glm::vec3 far = imageSends(greys.far[0], light, out.farAmbient);
    FieldLight dull = light;
    dull.gloss = 0;  // highlights are not painted
    for (int i = 0; i < LOOK_VIEWS; ++i) {
        const auto at = static_cast<size_t>(i);
        const glm::vec3 e = lookView(i), local = asBlades(grey, e, dull).value(),
                        aim = asTraced(light) ? tracedShow(light.traced->grey, light, e) : local;
        const float shines = quotient(luminance(asBlades(grey, e, light).value()), luminance(local));
        out.shine[at] = float(TRACED_GREY) * (shines - 1);
        out.paintAbove[at] = quotient(aim, far * out.far[at]);
        out.paintAcross[at] = quotient(aim, sentAlong(images.shown.views[at], rows, e) * out.slices[at]);
    }
}

// By Beer's law through the points, the highest first, of a ray that sinks by a metre in kGrazing metres.
float grazedHeight(const Look& look) {
    constexpr float kGrazing = 20;
    std::vector<std::pair<float, float>> heights;  // and area
    float area = 0;
    for (const LookPoint& p : look.points) {
        heights.push_back({f32::bladePosition(p.control, p.tip, p.along).y, p.area});
        area += p.area;
    }
    std::sort(heights.begin(), heights.end(), std::greater<>());
    float left = 1, sum = 0;
    for (const auto& [height, share] : heights) {
        const float met = left * (1 - std::exp(-kGrazing * look.across * share / std::max(area, 1e-9f)));
        sum += met * height, left -= met;
    }
    return sum / std::max(1 - left, 1e-6f);
}

// In the light from one direction: what blades send, and what vertical slices and the horizontal one do without gains.
struct Directed {
    glm::vec3 aim, vertical, horizontal;
};
// By direction as LampGains has them. seen: how the images take the light.
std::vector<Directed> directedOf(const Look& look, FieldLight leaves, FieldLight seen, const DrawnImages& images) {
    leaves.sky = leaves.ground = seen.sky = seen.ground = glm::vec3(0);
    const auto standing = posed(look, glm::vec2(0), look.clumpLean);
    constexpr size_t kLampLevel = 3, kFarLevel = 5, kLampTexels = 8;  // few texels: there are hundreds of directions
    constexpr float kAzimuths[] = {0.196f, 0.982f};                   // of all, by the symmetry of mirrored cells
    const auto share = [](size_t i) { return static_cast<float>(i % LAMP_ELEVATIONS) / (LAMP_ELEVATIONS - 1); };
    std::array<std::array<RowShares, LAMP_ELEVATIONS>, 2> shown;
    for (size_t k = 0; k < std::size(kAzimuths); ++k)
        for (size_t i = 0; i < LAMP_ELEVATIONS; ++i)
            shown[k][i] = sharesSeen(images.standing, kLampLevel, lookDirection(kAzimuths[k], share(i)), images.stand);
    std::vector<Directed> out(kDirectedGains);
    for (size_t i = 0; i < out.size(); ++i) {
        const float between = std::acos(1 - 2 * static_cast<float>(i % LAMP_AZIMUTHS) / (LAMP_AZIMUTHS - 1));
        const size_t eye = i / LAMP_AZIMUTHS % LAMP_ELEVATIONS;
        auto& [aim, vertical, horizontal] = out[i] = {};
        for (size_t k = 0; k < std::size(kAzimuths); ++k) {
            const glm::vec3 e = lookDirection(kAzimuths[k], share(eye)),
                            light = lookDirection(kAzimuths[k] + between, share(i / (LAMP_AZIMUTHS * LAMP_ELEVATIONS)));
            leaves.suns = seen.suns = {{light, glm::vec3(1)}};
            aim += aimAlong(leaves, standing, e);
            vertical +=
                sentAlong(shown[k][eye], rowsSend(images.standing, kLampLevel, seen, glm::vec3(0), kLampTexels), e);
            horizontal += imageSends(images.far[kFarLevel], seen, glm::vec3(0));
        }
    }
    return out;
}

}  // namespace

float maskPasses(const BladeShade& shade, float height, const glm::vec3& light) {
    const f32::MaskPoint at = f32::maskPointOf({0, height, 0}, {1, 0}, light, shade.radius, shade.top);
    const int rows = static_cast<int>(shade.rows.size()) / shade.layers;
    const f32::BilinearTap tap = f32::bilinearTap(at.height, at.rise, rows, shade.layers);
    const auto mean = [&](int row, int layer) { return shade.rows[static_cast<size_t>(layer * rows + row)]; };
    return f32::bilinearMix(mean(tap.x0, tap.y0), mean(tap.x1, tap.y0), mean(tap.x0, tap.y1), mean(tap.x1, tap.y1),
                            tap.fx, tap.fy);
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
    look.grazed = grazedHeight(look);
}

float lightLeft(const Look& look, float sinElevation) {
    const float y = std::clamp(sinElevation, f32::kLeastRise, 1.0f);
    return lightLeft(look, {std::sqrt(1 - y * y), y, 0}, {0, 0});
}
float lightLeft(const Look& look, const glm::vec3& towards, const glm::vec2& slope) {
    const float rise = std::max(f32::riseOver(towards, slope), f32::kLeastRise);
    return std::exp(-f32::leafDepth({look.across, look.above}, towards, rise));
}

Gains gainsOf(const Look& look, const FieldLight& light, const DrawnImages& images) {
    Gains out;
    if (light.traced && light.shade && !light.suns.empty())
        out.hotSpot = tracedHotSpot(light.traced->blades, light.suns[0].first);
    if (light.traced && light.lampsCast) out.lampHotSpot = lampHotSpot(light.traced->blades);
    out.sliceAmbient = 0.5f * (light.sky + light.ground);
    out.farAmbient = 0.25f * light.ground + 0.75f * light.sky;
    for (auto* factors : {&out.laid, &out.paintAcross, &out.paintAbove}) factors->fill(glm::vec3(1));
    if (light.traced) out.recollision = light.traced->recollision;
    if (light.pressed) addLaidGains(look, light, out);
    addLevels(images, light, out);
    FieldLight sparse = light;
    sparse.density = kThinDensity;
    const auto standing = posed(look, glm::vec2(0), look.clumpLean);
    const glm::vec3 far = imageSends(images.far[0], light, out.farAmbient);
    const RowsSend rows = rowsSend(images.standing, kShownLevel, light, out.sliceAmbient, kRowTexels);
    addThinner(images, rows, out);
    for (size_t i = 0; i < LOOK_VIEWS; ++i) {
        const glm::vec3 e = lookView(i), aim = aimAlong(light, standing, e);
        out.slices[i] = quotient(aim, sentAlong(images.shown.views[i], rows, e));
        out.far[i] = quotient(aim, far);
        out.thin[i] = light.painted ? quotient(aimAlong(sparse, standing, e), far) : glm::vec3(1);
    }
    if (light.tinted) addPaint(standing, images, light, out);
    if (light.lean > 0) addLeans(look, light, out);
    return out;
}

LampGains lampGainsOf(const Look& look, const FieldLight& leaves, const DrawnImages& images) {
    FieldLight seen = leaves;  // of lamps images know what falls on the side that is seen
    seen.translucency = 0, seen.weighting = LightWeighting::Poly9;
    LampGains out;
    const std::vector<Directed> sent = directedOf(look, leaves, seen, images);
    // Blades are all but black before a lamp.
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = {quotient(luminance(sent[i].aim), luminance(sent[i].vertical)),
                  quotient(luminance(sent[i].aim), luminance(sent[i].horizontal))};
    return out;
}

SunGains sunGainsOf(const Look& look, const FieldLight& leaves, const DrawnImages& images) {
    SunGains out;
    const std::vector<Directed> sent = directedOf(look, leaves, leaves, images);
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = {quotient(sent[i].aim, sent[i].vertical),
                  quotient(luminance(sent[i].vertical), luminance(sent[i].horizontal))};
    return out;
}

}  // namespace sward
