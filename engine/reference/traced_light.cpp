#include "reference/traced_light.h"

#include <cstddef>
#include <cstring>
#include <mutex>

#include "core/cache_file.h"
#include "core/hash.h"
#include "core/log.h"
#include "core/luminance.h"
#include "core/numerics.h"
#include "frame/plan.h"
#include "grass/drawing.h"
#include "grass/grass_fields.h"
#include "grass/grown.h"
#include "grass/mask.h"
#include "grass/slices.h"
#include "reference/grass_rays.h"
#include "reference/hemisphere.h"
#include "sky/daylight.h"

namespace sward {
namespace {

constexpr uint32_t kTracedVersion = 16;  // of the method: another one gives other factors
constexpr int kRaysOfView = 4000;        // that meet a blade, a view
constexpr int kRayParts = 16;  // of a view's rays, each with its own sums, so that any number of threads adds alike
constexpr int kMostMeetings = 12;
constexpr int kSkyPaths = 8;  // from each blade that is seen
constexpr size_t kOften = 5;  // behind the first meeting light comes from one of so many directions, by chance
constexpr double kLawnSide = 1000, kSpread = 10, kOff = 2e-5;  // metres: of the lawn; of the part of it that rays are
                                                               // sent to; by which a path starts off a blade
struct PathDice {
    uint32_t seed, next = 0;
    float unit() { return f32::hashUnit(f32::hash2(seed, next++)); }
    uint32_t grain() { return f32::hash2(seed, next++); }
};

glm::vec3 aroundByDice(const glm::vec3& n, PathDice& dice) {
    const float share = dice.unit();
    return cosineAround(n, share, dice.unit());
}

// The lawn, and how its blades shade each other in local light.
struct Lawn {
    Project project;
    BladeShade shade;
    float height = 0;    // of its highest blade, metres
    float soilOpen = 1;  // share of the sky's light that comes to its soil
};
// leaning: all of it, along x, as far as paint can lean it.
Result<Lawn> lawnOf(const TracedSpec& spec, bool leaning = false) {
    Lawn lawn;
    const SliceSpec& s = spec.species;
    lawn.project.dir = spec.dir;
    const Result<Entity> ground = addEntity(lawn.project, "ground"), grass = addEntity(lawn.project, "grass");
    if (!ground || !grass) return failed("the lawn cannot be made");
    Terrain t;
    t.size = {kLawnSide, kLawnSide};
    lawn.project.registry.add<Terrain>(*ground, t);
    GrassField f;
    f.cellSize = s.cellSize, f.seed = static_cast<int>(s.seed);
    f.species = {s.species};
    if (leaning) {
        Map along({1, 1, 2, PixelType::F32});
        along.set(0, 0, 0, 1), along.set(0, 0, 1, 0.5f);
        f.orientation.map = std::move(along);
    }
    lawn.project.registry.add<GrassField>(*grass, f);
    const Patch patch = makePatch(s.species, s.cellSize, s.seed);
    for (const Blade& b : patch.blades) lawn.height = std::max({lawn.height, b.tip.y, b.control.y});
    lawn.height *= 1.05f;
    const BladeMask mask = makeBladeMask(s.species, patch, s.cellSize, s.shadowMask, s.blade);
    lawn.shade = shadeBy(mask);
    return lawn;
}

struct Tracer {
    const Lawn& lawn;
    const GrassRays& rays;
    GrassMemory memory{};
};
// Tracers of one lawn, as many as threads ask at a time: what one has learned of the lawn's cells serves the next part.
class Tracers {
  public:
    Tracers(const Lawn& lawn, const GrassRays& rays) : lawn_(lawn), rays_(rays) {}
    // Calls work(tracer, part) for each of kRayParts, on all workers.
    template <class F>
    void eachPart(const F& work) {
        parallelFor(kRayParts, [&](size_t part) {
            std::unique_ptr<Tracer> tracer = take();
            work(*tracer, part);
            const std::lock_guard lock(mutex_);
            idle_.push_back(std::move(tracer));
        });
    }

  private:
    std::unique_ptr<Tracer> take() {
        const std::lock_guard lock(mutex_);
        if (idle_.empty()) return std::unique_ptr<Tracer>(new Tracer{lawn_, rays_});
        std::unique_ptr<Tracer> tracer = std::move(idle_.back());
        idle_.pop_back();
        return tracer;
    }
    const Lawn& lawn_;
    const GrassRays& rays_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Tracer>> idle_;
};

Ray from(const Surface& s, const glm::vec3& way, PathDice& dice) {
    const double side = glm::dot(s.face, way) < 0 ? -1 : 1;
    return {s.at + glm::dvec3(s.face) * (kOff * side), glm::normalize(glm::dvec3(way)), 0,
            std::numeric_limits<double>::infinity(), dice.grain()};
}
// What a blade sentBy towards one direction of light from another, and what it would if it were grey.
struct Sent {
    glm::vec3 own, grey;
};
Sent sentBy(const Surface& s, const glm::vec3& toEye, const glm::vec3& towards) {
    const glm::vec3 dull(s.looks.x, 0, s.looks.z);
    return {s.tint * f32::leafSends(s.color, s.looks, s.normal, toEye, towards),
            s.tint * f32::leafSends(glm::vec3(TRACED_GREY), dull, s.normal, toEye, towards)};
}
// What of a path's light comes to the eye.
struct Weight {
    glm::vec3 own{1}, grey{1};
    Weight& operator*=(const Sent& s) { return own *= s.own, grey *= s.grey, *this; }
    Weight& operator*=(float share) { return own *= share, grey *= share, *this; }
};
// The next direction of a path, through the blade or off it by chance; weight: what it counts.
glm::vec3 bounce(const Surface& s, const glm::vec3& toEye, PathDice& dice, Weight& weight) {
    const float through = luminance(f32::leafPasses(s.color, s.looks.x)),
                share = through / std::max(through + luminance(s.color), 1e-6f);
    const bool behind = dice.unit() < share;
    const glm::vec3 side = behind ? -s.normal : s.normal, towards = aroundByDice(side, dice);
    weight *= sentBy(s, toEye, towards);
    weight *= 1 / (std::max(glm::dot(side, towards), 1e-6f) * (behind ? share : 1 - share));
    return towards;
}

using Lights = std::array<glm::vec3, kTracedLights * kTracedTurns>;
// The lights about an eye that stands at this azimuth.
Lights lightsAbout(float azimuth) {
    Lights out;
    for (int i = 0; i < kTracedLights; ++i)
        for (int k = 0; k < kTracedTurns; ++k)
            out[static_cast<size_t>(i * kTracedTurns + k)] = raised(azimuth + kTurns[k], kLightSines[i]);
    return out;
}

// One view's sums.
struct ViewSums {
    std::array<TracedSums, kTracedLights * kTracedTurns> direct;
    TracedSums sky, tilt, ground;                                                // tilt: of a sky that is skyTilted
    std::array<std::array<glm::dvec3, TRACED_HEIGHTS>, kTracedLights> filled{};  // as TracedTable has them
    std::array<glm::dvec3, TRACED_HEIGHTS> reflect{};
    int met = 0;                 // rays
    double once = 0, twice = 0;  // as TracedTable has them
    void add(const ViewSums& o) {
        for (size_t i = 0; i < direct.size(); ++i) direct[i].add(o.direct[i]);
        sky.add(o.sky), tilt.add(o.tilt), ground.add(o.ground);
        for (size_t k = 0; k < TRACED_HEIGHTS; ++k) {
            reflect[k] += o.reflect[k];
            for (size_t i = 0; i < kTracedLights; ++i) filled[i][k] += o.filled[i][k];
        }
        met += o.met, once += o.once, twice += o.twice;
    }
};

void addLocal(const Lawn& lawn, const Surface& s, const glm::vec3& toEye, const Lights& lights, ViewSums& sums) {
    for (size_t i = 0; i < lights.size(); ++i)
        sums.direct[i].local +=
            glm::dvec3(sentBy(s, toEye, lights[i]).own * maskPasses(lawn.shade, float(s.at.y), lights[i]));
    const glm::dvec3 sent(s.color * s.tint * s.open);
    sums.sky.local += sent * (0.5 + 0.5 * double(s.normal.y));
    sums.tilt.local = sums.sky.local;
    sums.ground.local += sent * (0.5 - 0.5 * double(s.normal.y));
}

// The next blade of a path; none: it has ended, or left with `weight` along `way`.
std::optional<Surface> goOn(Tracer& t, const Surface& s, const glm::vec3& toEye, PathDice& dice, Weight& weight,
                            glm::vec3& way) {
    way = bounce(s, toEye, dice, weight);
    const std::optional<Surface> next = t.rays.closest(from(s, way, dice), t.memory);
    if (!next) return next;
    const float goesOn = std::clamp(std::max({weight.own.x, weight.own.y, weight.own.z}) * 2, 0.02f, 1.0f);
    weight *= dice.unit() < goesOn ? 1 / goesOn : 0.0f;
    if (weight.own == glm::vec3(0)) return std::nullopt;
    return next;
}

// How much each of TRACED_HEIGHTS counts for a blade there.
glm::vec3 heightsOf(const Lawn& lawn, const Surface& s) {
    return f32::tracedHeights(static_cast<float>(s.at.y) / std::max(lawn.shade.top, 1e-6f));
}
// A path from what was seen on, with light at each blade that it meets.
void addLights(Tracer& t, Surface s, glm::vec3 toEye, const Lights& lights, PathDice& dice, ViewSums& sums) {
    Weight weight;
    glm::vec3 way;
    const glm::vec3 heights = heightsOf(t.lawn, s);
    for (int k = 0; k < TRACED_HEIGHTS; ++k)
        sums.reflect[static_cast<size_t>(k)] += glm::dvec3(heights[k] * s.color * s.tint);
    for (int n = 0; n < kMostMeetings; ++n) {
        const float albedo = std::max(luminance(s.color + f32::leafPasses(s.color, s.looks.x)), 1e-4f);
        const size_t step = n == 0 ? 1 : kOften, first = n == 0 ? 0 : static_cast<size_t>(dice.unit() * kOften);
        for (size_t i = first; i < lights.size(); i += step) {
            Weight sent = weight;
            sent *= sentBy(s, toEye, lights[i]);
            sent *= static_cast<float>(step);
            if (sent.own == glm::vec3(0) || t.rays.blocks(from(s, lights[i], dice), t.memory)) continue;
            sums.direct[i].full += glm::dvec3(sent.own), sums.direct[i].grey += glm::dvec3(sent.grey);
            for (int k = 0; n > 0 && k < TRACED_HEIGHTS; ++k)
                sums.filled[i / kTracedTurns][static_cast<size_t>(k)] += glm::dvec3(heights[k] * sent.own);
            if (n == 0) sums.once += double(luminance(sent.own));
            if (n == 1) sums.twice += double(luminance(sent.own) / albedo);
        }
        const std::optional<Surface> next = goOn(t, s, toEye, dice, weight, way);
        if (!next) return;
        s = *next, toEye = -way;
    }
}
// Paths up to the sky or down to the soil, of which each counts for a share.
void addSky(Tracer& t, const Surface& seen, const glm::vec3& toSeen, PathDice& dice, ViewSums& sums) {
    for (int path = 0; path < kSkyPaths; ++path) {
        Surface s = seen;
        glm::vec3 toEye = toSeen, way;
        Weight weight;
        for (int n = 0; n < kMostMeetings; ++n) {
            const std::optional<Surface> next = goOn(t, s, toEye, dice, weight, way);
            if (next) {
                s = *next, toEye = -way;
                continue;
            }
            const glm::dvec3 own(weight.own), grey(weight.grey);
            const auto add = [&](TracedSums& to, float share) {
                to.full += own * double(share / kSkyPaths), to.grey += grey * double(share / kSkyPaths);
            };
            if (way.y > 0)
                add(sums.sky, 1), add(sums.tilt, skyTilted(way.y));
            else
                add(sums.ground, t.lawn.soilOpen);
            break;
        }
    }
}

// The n-th of a sequence of points that fill the unit cube evenly however many of them are taken, as chance does not
// (additive recurrence by the powers of the root of x^4 = x + 1: Roberts 2018). seed: shifts all of it.
glm::dvec3 evenly(uint32_t seed, uint32_t n) {
    const auto first = [&](uint32_t axis) { return double(f32::hashUnit(f32::hash2(seed, axis))); };
    const glm::dvec3 step(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
    return glm::fract(glm::dvec3(first(0), first(1), first(2)) + double(n) * step);
}
// The ray of this number, of all parts of a view together.
uint32_t rayNumber(int part, int n) { return static_cast<uint32_t>(n * kRayParts + part); }

// A ray towards the eye's place over the lawn; none: it met no blade. share: of the part of the lawn that rays are sent
// to.
std::optional<Surface> lookDown(Tracer& t, const glm::vec3& toEye, const glm::dvec2& share, PathDice& dice) {
    const double height = static_cast<double>(t.lawn.height);
    const glm::dvec3 top(0.5 * kLawnSide + kSpread * share.x, height, 0.5 * kLawnSide + kSpread * share.y);
    return t.rays.closest({top, -glm::dvec3(toEye), 0, height / double(toEye.y), dice.grain()}, t.memory);
}

// Rays of a part of a view over grass that leans along x. What each sentBy counts by the angle of that lean to the eye:
// eyes stand all around, so that means of it times these terms are the terms' numbers.
TracedTable::Leaning traceLeaning(Tracer& t, int view, int part, int rays, const JobControl& control) {
    TracedTable::Leaning sums;
    for (int n = 0; n < 8 * rays && sums.met < rays && !control.cancelled(); ++n) {
        PathDice dice{
            f32::hash3(0x1ea0u + static_cast<uint32_t>(view), static_cast<uint32_t>(part), static_cast<uint32_t>(n))};
        const glm::dvec3 drawn = evenly(static_cast<uint32_t>(view), rayNumber(part, n));
        const float azimuth = f32::kTau * float(drawn.z);
        const glm::vec3 toEye = raised(azimuth, kViewSines[view]);
        const std::optional<Surface> s = lookDown(t, toEye, drawn, dice);
        if (!s) continue;
        ++sums.met;
        const double lean = -static_cast<double>(azimuth);
        const std::array<double, kTracedLeans> terms{1, 2 * std::cos(lean), 2 * std::sin(lean), 2 * std::cos(2 * lean),
                                                     2 * std::sin(2 * lean)};
        ViewSums one;
        addLights(t, *s, toEye, lightsAbout(azimuth), dice, one);
        addSky(t, *s, toEye, dice, one);
        for (size_t k = 0; k < kTracedLeans; ++k) {
            for (size_t i = 0; i < one.direct.size(); ++i) sums.direct[i][k] += terms[k] * one.direct[i].full;
            sums.sky[k] += terms[k] * one.sky.full;
        }
    }
    return sums;
}

// Rays of a part of a view, until enough of them have met a blade.
ViewSums traceView(Tracer& t, int view, int part, int rays, const JobControl& control) {
    ViewSums sums;
    for (int n = 0; n < 8 * rays && sums.met < rays && !control.cancelled(); ++n) {
        PathDice dice{f32::hash3(static_cast<uint32_t>(view), static_cast<uint32_t>(part), static_cast<uint32_t>(n))};
        const glm::dvec3 drawn = evenly(static_cast<uint32_t>(view), rayNumber(part, n));
        const float azimuth = f32::kTau * float(drawn.z);
        const glm::vec3 toEye = raised(azimuth, kViewSines[view]);
        const std::optional<Surface> s = lookDown(t, toEye, drawn, dice);
        if (!s) continue;
        ++sums.met;
        const Lights lights = lightsAbout(azimuth);
        addLocal(t.lawn, *s, toEye, lights, sums);
        addLights(t, *s, toEye, lights, dice, sums);
        addSky(t, *s, toEye, dice, sums);
    }
    return sums;
}

// Light at the soil: paths up from it.
struct SoilSums {
    ViewSums met;  // full alone
    int rays = 0, open = 0;
    double openTilt = 0;
    void add(const SoilSums& o) { met.add(o.met), rays += o.rays, open += o.open, openTilt += o.openTilt; }
};
SoilSums traceSoil(Tracer& t, int part, int rays, const JobControl& control) {
    SoilSums sums;
    sums.rays = rays;
    for (int n = 0; n < rays && !control.cancelled(); ++n) {
        PathDice dice{f32::hash3(0x5011u, static_cast<uint32_t>(part), static_cast<uint32_t>(n))};
        const glm::dvec3 drawn = evenly(0x5011u, rayNumber(part, n));
        const glm::dvec3 at(0.5 * kLawnSide + kSpread * drawn.x, 1e-4, 0.5 * kLawnSide + kSpread * drawn.y);
        const glm::vec3 way = aroundByDice({0, 1, 0}, dice);
        const std::optional<Surface> s =
            t.rays.closest({at, glm::dvec3(way), 0, std::numeric_limits<double>::infinity(), dice.grain()}, t.memory);
        if (s) {
            addLights(t, *s, -way, lightsAbout(f32::kTau * dice.unit()), dice, sums.met);
            addSky(t, *s, -way, dice, sums.met);
        } else
            ++sums.open, sums.openTilt += double(skyTilted(way.y));
    }
    return sums;
}
void tellSoil(const SoilSums& sums, TracedTable& table) {
    table.soilSky = (sums.open + luminance(sums.met.sky.full)) / std::max(sums.rays, 1);
    table.soilTilt = (sums.openTilt + luminance(sums.met.tilt.full)) / std::max(sums.rays, 1);
    for (size_t i = 0; i < sums.met.direct.size(); ++i)
        table.soilScattered[i / kTracedTurns] +=
            luminance(sums.met.direct[i].full) / (kTracedTurns * std::max(sums.rays, 1));
}

// --- the file of the cache: the numbers, and a hash of their bytes
constexpr size_t kNumbers =
    3 * (2 * TRACED_DIRECT + TRACED_FILL + 3 * TRACED_RISE + 2 * kTracedViews * (kTracedLights * kTracedTurns + 3) +
         kTracedLeans * kTracedViews * (kTracedLights * kTracedTurns + 1) + 1) +
    4;
static_assert(sizeof(TracedLight) == kNumbers * sizeof(float));

std::filesystem::path tracedFile(const std::filesystem::path& folder, uint64_t key) {
    return folder / "traced" / (hashHex(key) + ".traced");
}
size_t bytesOf(bool leaning) { return leaning ? sizeof(TracedLight) : offsetof(TracedLight, leaning); }
std::optional<TracedLight> parseTraced(const std::string& bytes, std::string& wrong) {
    uint64_t sum;
    const size_t size = bytes.size() - std::min(bytes.size(), sizeof(sum));
    if (size != bytesOf(false) && size != bytesOf(true)) return wrong = "it is truncated", std::nullopt;
    std::memcpy(&sum, bytes.data() + size, sizeof(sum));
    if (sum != hashBytes(bytes.data(), size)) return wrong = "it is damaged", std::nullopt;
    TracedLight out;
    std::memcpy(&out, bytes.data(), size);
    return out;
}
void keep(const std::filesystem::path& file, const TracedLight& light) {
    const size_t size = bytesOf(light.leaning.lean > 0);
    const uint64_t sum = hashBytes(&light, size);
    std::string bytes(reinterpret_cast<const char*>(&light), size);
    bytes.append(reinterpret_cast<const char*>(&sum), sizeof(sum));
    writeCached(file, "traced light", bytes);
}

// --- the effect
// Where one may wait, waits; else traces beside.
void updateTraced(DrawContext& ctx, TracedState::One& one, const FieldEntity& field, size_t i) {
    // Most frames ask for what is there: the name of the blade's image stands for its pixels.
    const Species& species = field.grows.species[i];
    const uint64_t asked =
        tracedKey(tracedSpec(ctx.project, field, i, {})) ^ hashBytes(species.texture.data(), species.texture.size());
    if (one.asked == asked) return;
    const TracedSpec spec = tracedSpec(ctx.project, field, i, bladeImage(ctx.project, species));
    const uint64_t key = tracedKey(spec);
    if (one.bakeOf != key) one.bake = {};  // the light of what was is shown meanwhile: nearer than none
    if (ctx.sketching()) return;
    const auto take = [&](Result<TracedLight> made) {
        if (!made) logWarning(species.name + ": light from blade to blade is missing: " + made.error().text());
        one.light = made ? std::optional(*made) : std::nullopt;
        one.asked = asked;  // what failed is not tried again until something is changed
    };
    JobControl control;
    if (!ctx.settings.background) return take(tracedLight(cacheDir(), spec, control));
    if (auto made = one.bake.take(key)) return take(std::move(*made));
    if (one.bake.active()) return;
    one.bakeOf = key;
    one.bake = Job<TracedLight>("light between blades of " + spec.species.species.name, key,
                                [spec](JobControl& c) { return tracedLight(cacheDir(), spec, c); });
}

void updateAllTraced(DrawContext& ctx) {
    TracedState& state = ctx.own<TracedState>();
    std::map<std::string, std::vector<TracedState::One>> now;
    for (const auto& [name, field] : fieldsOf(ctx.project)) {
        if (!has(fieldFeatures(ctx.tables.techniques, field), Feature::GrassTraced)) continue;
        std::vector<TracedState::One>& species = now[name] = std::move(state.fields[name]);
        species.resize(field.grows.species.size());
        for (size_t i = 0; i < species.size(); ++i) {
            updateTraced(ctx, species[i], field, i);
            if (species[i].light) species[i].here = underSky(*species[i].light, ctx.shared.skyTilt);
        }
    }
    state.fields = std::move(now);
    ctx.shared.traced = &state;
}

const System kSystems[] = {
    {"grass/traced", {.reads = {Slot::SkyLight}, .writes = {Slot::Traced}}, updateAllTraced, true}};

}  // namespace

TracedSpec tracedSpec(const Project& project, const FieldEntity& field, size_t species, const Rgba8& blade) {
    const bool leans = field.grows.orientation.present() && leanAtFull(field.grows.species[species]) > 0.05f;
    return {sliceSpec(field, species, blade, true), project.dir, leans};
}

uint64_t tracedKey(const TracedSpec& spec) {
    SliceSpec s = spec.species;
    s.slices = s.width = s.height = s.farSize = 0;
    const Species& p = s.species;
    const float read[] = {static_cast<float>(kTracedVersion),
                          spec.leans ? 1.0f : 0.0f,
                          p.translucency,
                          p.gloss,
                          p.roughness,
                          p.leanDeg,
                          p.clumpSize,
                          p.clumpStrength};
    const uint64_t parts[] = {sliceKey(s), hashBytes(read, sizeof(read))};
    return hashBytes(parts, sizeof(parts));
}

// Fills in the table's leaning grass.
Result<void> traceLeans(const TracedSpec& spec, int rays, JobControl& control, TracedTable& table) {
    Result<Lawn> lawn = lawnOf(spec, true);
    if (!lawn) return lawn.error();
    const Result<GrassRays> grass = GrassRays::make(lawn->project, 0, control);
    if (!grass) return grass.error();
    std::array<std::array<TracedTable::Leaning, kTracedViews>, kRayParts> sums;
    Tracers tracers(*lawn, *grass);
    tracers.eachPart([&](Tracer& t, size_t part) {
        for (int view = 0; view < kTracedViews; ++view)
            sums[part][static_cast<size_t>(view)] =
                traceLeaning(t, view, static_cast<int>(part), std::max(rays / kRayParts, 1), control);
    });
    if (control.cancelled()) return failed("cancelled");
    for (size_t view = 0; view < kTracedViews; ++view)
        for (const auto& part : sums) {
            TracedTable::Leaning& all = table.leaning[view];
            const TracedTable::Leaning& one = part[view];
            all.met += one.met;
            for (size_t k = 0; k < kTracedLeans; ++k) {
                all.sky[k] += one.sky[k];
                for (size_t i = 0; i < all.direct.size(); ++i) all.direct[i][k] += one.direct[i][k];
            }
        }
    table.lean = leanAtFull(spec.species.species);
    return {};
}

Result<TracedTable> traceTable(const TracedSpec& spec, int rays, JobControl& control) {
    Result<Lawn> lawn = lawnOf(spec);
    if (!lawn) return lawn.error();
    const Result<GrassRays> grass = GrassRays::make(lawn->project, 0, control);
    if (!grass) return grass.error();
    std::array<SoilSums, kRayParts> soil;
    Tracers tracers(*lawn, *grass);
    tracers.eachPart([&](Tracer& t, size_t part) {
        soil[part] = traceSoil(t, static_cast<int>(part), std::max(rays / kRayParts, 1), control);
    });
    TracedTable table;
    for (size_t part = 1; part < kRayParts; ++part) soil[0].add(soil[part]);
    tellSoil(soil[0], table);
    lawn->soilOpen = static_cast<float>(table.soilSky);
    std::array<ViewSums, kRayParts * kTracedViews> sums;
    std::atomic<int> done = 0;
    tracers.eachPart([&](Tracer& t, size_t part) {
        for (int view = 0; view < kTracedViews; ++view) {
            sums[part * kTracedViews + static_cast<size_t>(view)] =
                traceView(t, view, static_cast<int>(part), std::max(rays / kRayParts, 1), control);
            control.setProgress(static_cast<double>(++done) / static_cast<double>(sums.size()));
        }
    });
    if (control.cancelled()) return failed("cancelled");
    for (size_t view = 0; view < kTracedViews; ++view) {
        ViewSums all;
        for (size_t part = 0; part < kRayParts; ++part) all.add(sums[part * kTracedViews + view]);
        table.met[view] = all.met;
        table.direct[view] = all.direct, table.reflect[view] = all.reflect;
        for (size_t i = 0; i < kTracedLights; ++i)
            for (size_t k = 0; k < TRACED_HEIGHTS; ++k) table.filled[i][k] += all.filled[i][k];
        table.once += all.once, table.twice += all.twice;
        table.sky[view] = all.sky, table.tilt[view] = all.tilt, table.ground[view] = all.ground;
    }
    if (spec.leans)
        if (const Result<void> traced = traceLeans(spec, rays, control, table); !traced) return traced.error();
    return table;
}

Result<TracedLight> tracedLight(const std::filesystem::path& folder, const TracedSpec& spec, JobControl& control) {
    const std::filesystem::path file = tracedFile(folder, tracedKey(spec));
    if (auto kept = loadCached(file, 1 << 16, "traced light", parseTraced)) return *kept;
    const Result<TracedTable> table = traceTable(spec, kRaysOfView, control);
    if (!table) return table.error();
    const TracedLight light = fitTraced(*table);
    keep(file, light);
    return light;
}

const EffectRow& tracedEffect() {
    static const EffectRow row{
        .name = "grass/traced",
        .needs = featureSet(Feature::Grass, Feature::GrassTraced),
        .systems = kSystems,
        .makeState = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<TracedState>(); },
        .help = "light from blade to blade"};
    return row;
}

}  // namespace sward
