// Index: texels of images · what a texel sends · what a view shows.
#include "grass/image_light.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/hash.h"
#include "core/numerics.h"

namespace sward {
namespace {

constexpr int kRays = 1024;            // of a view
constexpr size_t kTexels = 64;         // that are kept of a row
constexpr size_t kFarTexels = 4096;    // of a level of the horizontal slice: a change of light takes a millisecond
constexpr float kSeenThrough = 0.02f;  // at which a ray ends

// --- texels of images ------------------------------------------------------------------------------------------------
glm::vec4 texelAt(const std::vector<uint8_t>& bytes, size_t i) {
    return glm::vec4(bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2], bytes[4 * i + 3]) / 255.0f;
}

// Places in a list of n, at most so many: all over it, in steps that share no divisor with n.
struct Places {
    size_t n, count, step;
    Places(size_t all, size_t most) : n(all), count(std::min(all, most)), step(all / count + 1) {
        while (std::gcd(step, n) > 1) ++step;
    }
    size_t operator[](size_t i) const { return i * step % n; }
};

// How far coarser than its colour the opacity of what is drawn is read: as it is at the finest that slices are sampled,
// for a view from above; slanted ones read coarser opacity, which is even wherever grass is dense.
constexpr size_t kCoarser = 2;

// A place of an image as filtering shows it: a mean of four texels by where between them it lies, by chance. Light that
// is filtered is brighter than texels that face it are on average, as what faces away counts less.
struct Filtered {
    glm::vec4 reflectance{0}, threshold{0}, front{0}, back{0};
};
// layer, x, y: of the texel below and left of it; images go on to the sides, `up` too if `repeats`, else with their
// edge.
Filtered filteredAt(const SliceLevel& l, int layer, int x, int y, bool repeats) {
    const uint32_t seed = f32::hash3(static_cast<uint32_t>(layer), static_cast<uint32_t>(x), static_cast<uint32_t>(y));
    const float across = f32::hashUnit(seed), up = f32::hashUnit(f32::hashMix(seed + 1));
    Filtered out;
    for (int k = 0; k < 4; ++k) {
        const int right = (x + (k & 1)) % l.width, over = y + (k >> 1),
                  above = repeats ? over % l.height : std::min(over, l.height - 1);
        const auto at = static_cast<size_t>((layer * l.height + above) * l.width + right);
        const float weight = (k & 1 ? across : 1 - across) * (k >> 1 ? up : 1 - up);
        out.reflectance += weight * texelAt(l.reflectance, at), out.threshold += weight * texelAt(l.threshold, at);
        out.front += weight * texelAt(l.front, at), out.back += weight * texelAt(l.back, at);
    }
    return out;
}
float opacityAt(const SliceLevel& coarse, const SliceLevel& l, int layer, int x, int y) {
    const int at = (layer * coarse.height + y * coarse.height / l.height) * coarse.width + x * coarse.width / l.width;
    return coarse.threshold[4 * static_cast<size_t>(at) + 1] / 255.0f;
}

FarImage farImageOf(const SliceImages& images) {
    FarImage out;
    const size_t last = images.far.size() - 1;
    for (size_t level = 0; level < FAR_LEVELS; ++level) {
        const SliceLevel &l = images.far[std::min(level, last)], &coarse = images.far[std::min(level + kCoarser, last)];
        const Places places(static_cast<size_t>(l.width) * l.height, kFarTexels);
        out[level].reserve(places.count);
        for (size_t i = 0; i < places.count; ++i) {
            const int x = static_cast<int>(places[i]) % l.width, y = static_cast<int>(places[i]) / l.width;
            const Filtered f = filteredAt(l, 0, x, y, true);
            out[level].push_back({glm::vec3(f.reflectance) * images.reflectScale, f.reflectance.w,
                                  opacityAt(coarse, l, 0, x, y), f.front, f.threshold.z, f.threshold.w});
        }
    }
    return out;
}

// Row `row` of the images of a level, `l`, from `layer` on, as many as there are slices along an axis. `coarse`: the
// level of their opacity.
SliceRow rowOf(const SliceImages& images, const SliceLevel& l, const SliceLevel& coarse, int layer, int row) {
    SliceRow out;
    const int high = std::max(l.height / kSliceRows, 1), first = row * l.height / kSliceRows;
    const Places places(static_cast<size_t>(high * l.width * images.slices), kTexels);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < places.n; ++i) {
        const int at = static_cast<int>(places[i]), x = at % l.width, y = first + at / l.width % high,
                  of = layer + at / (l.width * high);
        const float opacity = opacityAt(coarse, l, of, x, y);
        sum += static_cast<double>(opacity), squares += static_cast<double>(opacity * opacity);
        if (!(opacity > 0) || out.texels.size() == kTexels) continue;
        const Filtered f = filteredAt(l, of, x, y, false);
        out.texels.push_back({glm::vec3(f.reflectance) * images.reflectScale,
                              f.reflectance.w,
                              opacity,
                              {f.front.x, f.front.z, f.front.w, f.threshold.z},
                              {f.back.x, f.back.z, f.back.w, f.threshold.w}});
    }
    out.opacity = static_cast<float>(sum / static_cast<double>(places.n));
    out.covered = sum > 0 ? static_cast<float>(squares / sum) : 0.0f;
    return out;
}

StandingImage standingImageOf(const SliceImages& images, SliceSets sets) {
    StandingImage out;
    out.width = images.vertical[0].width, out.height = images.vertical[0].height, out.top = images.top;
    for (size_t level = 0; level < SLICE_LEVELS; ++level) {
        const size_t last = images.vertical.size() - 1;
        const SliceLevel &l = images.vertical[std::min(level, last)],
                         &coarse = images.vertical[std::min(level + 1, last)];
        for (int axis = 0; axis < 2; ++axis)
            for (int row = 0; row < kSliceRows; ++row)
                out.levels[level][static_cast<size_t>(axis)][static_cast<size_t>(row)] =
                    rowOf(images, l, coarse, sets == SliceSets::Shared ? 0 : axis * images.slices, row);
    }
    return out;
}

// --- what a texel sends ----------------------------------------------------------------------------------------------
// Light on this side of what is seen and on the other, by shaders' form of light (cosineOf of lib/slices.glsl).
struct TwoSides {
    float toward, away;
};
TwoSides cosineOf(const glm::vec3& plus, const glm::vec3& minus, const glm::vec3& towards) {
    const float facing = glm::dot(plus - minus, towards),
                spread = 2 * glm::dot(glm::min(plus, minus), glm::abs(towards)),
                both = std::sqrt(facing * facing + spread * spread);
    return {0.5f * (both + facing), 0.5f * (both - facing)};
}
glm::vec3 leafSent(const glm::vec3& color, const TwoSides& light, float translucency) {
    return color * light.toward + f32::leafThrough(color) * (translucency * light.away);
}

// What a texel of the horizontal slice sends (lib/far_light.glsl).
glm::vec3 texelSends(const FarTexel& t, const glm::vec3& direction, const glm::vec4& w, const FieldLight& l) {
    if (l.weighting == LightWeighting::Cosine)
        return leafSent(t.color, cosineOf({t.sides.x, t.above, t.sides.z}, {t.sides.y, t.below, t.sides.w}, direction),
                        l.translucency);
    const glm::vec4 images(w.x, w.w, w.z, 1 - (w.x + w.y + w.z + w.w));
    return leafSent(t.color,
                    {glm::dot(t.sides, images) + t.above * w.y,
                     glm::dot(glm::vec4(t.sides.y, t.sides.x, t.sides.w, t.sides.z), images) + t.below * w.y},
                    l.translucency);
}

// The sun as a vertical slice sees it, in the patch's own axes (sunImages of lib/slices.glsl): light that faces the
// side that is seen, from its sides, and from above.
struct SliceSun {
    glm::vec4 images;
    glm::vec3 color;
};
glm::vec3 sideSends(const SliceTexel& t, bool front, const SliceSun& sun, const FieldLight& l) {
    const SliceTexel::Side &seen = front ? t.front : t.back, &other = front ? t.back : t.front;
    if (l.weighting == LightWeighting::Cosine)
        return leafSent(t.color,
                        cosineOf({seen.facing, seen.plus, seen.above}, {0, seen.minus, other.above}, sun.images),
                        l.translucency);
    const glm::vec4& w = sun.images;
    return leafSent(
        t.color,
        {glm::dot(w, glm::vec4(seen.facing, seen.plus, seen.minus, seen.above)),
         glm::dot(w, glm::vec4(0, seen.minus, seen.plus, other.above)) + (1 - (w.x + w.y + w.z + w.w)) * seen.facing},
        l.translucency);
}
// axis: 0 of slices across x, 1 across z; `before`: whether the eye is on that axis' positive side; `turned`: whether
// its cell is mirrored along the slice.
SliceSun sunOn(const FieldLight& l, size_t sun, int axis, bool before, bool turned) {
    const auto& [direction, color] = l.suns[sun];
    const float facing = before ? 1.0f : -1.0f, across = turned ? -1.0f : 1.0f;
    if (l.weighting == LightWeighting::Cosine)
        return {axis == 0 ? glm::vec4(direction.x * facing, direction.z * across, direction.y, 0)
                          : glm::vec4(direction.z * facing, direction.x * across, direction.y, 0),
                color};
    const glm::vec4 w = imageWeights(direction, l.weighting);
    const glm::vec2 x(w.x, w.w), z(w.z, 1 - (w.x + w.y + w.z + w.w)), &along = axis == 0 ? x : z,
                                                                      &side = axis == 0 ? z : x;
    return {{before ? along.x : along.y, turned ? side.y : side.x, turned ? side.x : side.y, w.y}, color};
}

// The mean of a row's texels, over both sides of slices and cells that are mirrored both ways.
glm::vec3 rowSends(const SliceRow& row, const FieldLight& l, const glm::vec3& ambient,
                   const std::vector<SliceSun>& suns, size_t texels) {
    glm::vec3 sum(0);
    float weight = 0;
    for (size_t i = 0; i < std::min(texels, row.texels.size()); ++i) {
        const SliceTexel& t = row.texels[i];
        glm::vec3 sent = t.color * ambient * t.open;
        for (const SliceSun& sun : suns)
            sent += 0.25f * sun.color * (sideSends(t, true, sun, l) + sideSends(t, false, sun, l));
        sum += t.opacity * sent, weight += t.opacity;
    }
    return sum / std::max(weight, 1e-9f);
}

// --- what a view shows -----------------------------------------------------------------------------------------------
// A slice that a ray meets: which, and its share of the ray's light.
struct MetRow {
    size_t set = 0, row = 0;
    float share = 0;
};
// What a ray has met.
struct Walked {
    float through = 1;
    RowShares shares{};
    MetRow most, next;
    void meet(MetRow met, float alpha) {
        met.share = through * alpha;
        through -= met.share;
        shares[met.set][met.row] += met.share;
        if (met.share > most.share)
            next = most, most = met;
        else if (met.share > next.share)
            next = met;
    }
};
// A view of slices at a level of what is lit.
struct SliceSight {
    const SliceRows &rows, &restRows;
    float top;
    glm::vec2 falls;   // metres down from slice to slice, of those across x and across z
    glm::vec2 turned;  // share of them that shows
    int steps;         // of a ray
    bool rest;
    float density;
    float deepest;  // metres down to the slice that stands for the rest, at most
};
// The pixel for which this level is lit is the wider the fewer texels of it there are.
int stepsAt(const StandingImage& image, size_t level, const SliceStand& s) {
    if (!s.traced) return std::numeric_limits<int>::max();
    const float finest = std::max(static_cast<float>(image.width) / (0.7f * s.across),
                                  static_cast<float>(image.height) / std::max(image.top, 1e-3f)),
                pixel = std::exp2(static_cast<float>(level) + 1 + s.sharpness) / finest;
    const float steps = std::ceil(static_cast<float>(s.steps) * s.apart / std::max(s.footprint * pixel, 1e-6f));
    return static_cast<int>(std::clamp(steps, 1.0f, static_cast<float>(s.steps)));
}
SliceSight sightOf(const StandingImage& image, size_t level, const glm::vec3& e, const SliceStand& s) {
    const glm::vec2 across(std::abs(e.x), std::abs(e.z));
    const float size = std::max(glm::length(across), 1e-4f), y = std::max(e.y, 1e-3f);
    return {image.levels[level],
            image.levels[kRestLevel],
            image.top,
            s.apart * y / glm::max(across, glm::vec2(1e-4f)),
            std::min(s.steepest * size / y, 1.0f) * across / size,
            stepsAt(image, level, s),
            s.restShown,
            s.density,
            s.across * y};
}
size_t rowAt(const SliceSight& s, float depth) {
    return static_cast<size_t>(std::clamp(1 - depth / s.top, 0.0f, 0.999f) * kSliceRows);
}
// The mean opacity of a row where slices stand for some of the blades.
float opacityOf(const SliceSight& s, const SliceRow& row) {
    return s.density == 1 ? row.opacity : 1 - std::pow(1 - row.opacity, s.density);
}
// What lies below the last slice that a ray comes to, as one slice more.
void meetRest(const SliceSight& s, int axis, float depth, Walked& w) {
    const float left = s.top - depth, shown = 1 + left * (s.turned.x / s.falls.x + s.turned.y / s.falls.y);
    const auto a = static_cast<size_t>(axis), at = rowAt(s, depth + 0.5f * std::min(left, s.deepest));
    w.meet({a + 2, at, 0}, 1 - std::pow(1 - opacityOf(s, s.restRows[a][at]), std::min(shown, 64.0f)));
}
// A ray down through the slices, over their rows by chance.
Walked walk(const SliceSight& s, uint32_t ray) {
    uint32_t next = 0;
    const auto chance = [&] { return f32::hashUnit(f32::hash2(ray, next++)); };
    glm::vec2 below = s.falls * glm::vec2(chance(), chance());
    Walked w;
    for (int step = 0; w.through > kSeenThrough; ++step) {
        const int axis = below.x < below.y ? 0 : 1;
        const float depth = below[axis];
        if (!(depth < s.top)) break;
        if (step == s.steps) {
            if (s.rest) meetRest(s, axis, depth, w);
            break;
        }
        below[axis] += s.falls[axis];
        const auto a = static_cast<size_t>(axis), at = rowAt(s, depth);
        const SliceRow& row = s.rows[a][at];
        if (row.covered > 0 && chance() * row.covered < opacityOf(s, row))
            w.meet({a, at, 0}, row.covered * s.turned[axis]);
    }
    return w;
}

}  // namespace

LevelFactors evenLevels() {
    LevelFactors out;
    for (auto& levels : out) levels.fill(1);
    return out;
}

DrawnImages drawnImagesOf(const SliceImages& images, bool vertical, SliceSets sets, const SliceStand& stand) {
    DrawnImages out;
    out.far = farImageOf(images), out.stand = stand;
    if (vertical) out.standing = standingImageOf(images, sets), out.shown = shownShares(out.standing, stand);
    std::vector<uint64_t> parts;
    for (const auto& level : out.far) parts.push_back(hashBytes(level.data(), level.size() * sizeof(FarTexel)));
    for (const SliceRows& level : out.standing.levels)
        for (const auto& axis : level)
            for (const SliceRow& row : axis)
                parts.push_back(hashBytes(row.texels.data(), row.texels.size() * sizeof(SliceTexel)));
    const float how[] = {stand.apart,
                         stand.across,
                         stand.steepest,
                         stand.footprint,
                         stand.sharpness,
                         static_cast<float>(stand.steps),
                         stand.traced ? 1.0f : 0.0f,
                         stand.restShown ? 1.0f : 0.0f};
    parts.push_back(hashBytes(how, sizeof(how)));
    out.key = hashBytes(parts.data(), parts.size() * sizeof(uint64_t));
    return out;
}

DrawnImages colored(const DrawnImages& images, size_t level, const glm::vec3& color) {
    DrawnImages out;
    out.far[0] = images.far[0];
    for (FarTexel& t : out.far[0]) t.color = color;
    for (const size_t of : {level, kRestLevel}) {
        out.standing.levels[of] = images.standing.levels[of];
        for (auto& axis : out.standing.levels[of])
            for (SliceRow& row : axis)
                for (SliceTexel& t : row.texels) t.color = color;
    }
    return out;
}

glm::vec3 lookDirection(float azimuth, float height) {
    constexpr float kFlattest = 0.03f;  // sine of the lowest view
    const float rise = 0.7853982f + std::asin((2 * height * height - 1) * 0.7071068f),
                y = std::clamp(std::sin(rise), kFlattest, 0.999f), level = std::sqrt(1 - y * y);
    return {level * std::cos(azimuth), y, level * std::sin(azimuth)};
}
glm::vec3 lookView(size_t i) {
    return lookDirection(6.2831853f * static_cast<float>(i % LOOK_AZIMUTHS) / LOOK_AZIMUTHS,
                         static_cast<float>(i / LOOK_AZIMUTHS) / (LOOK_ELEVATIONS - 1));
}

ShownShares shownShares(const StandingImage& image, const SliceStand& stand) {
    ShownShares out;
    constexpr size_t kHalf = LOOK_AZIMUTHS / 2;
    for (size_t i = 0; i < LOOK_VIEWS; ++i) {  // alike in each quarter of a turn, forth and back
        const size_t azimuth = i % LOOK_AZIMUTHS, like = std::min(azimuth % kHalf, kHalf - azimuth % kHalf);
        out.views[i] =
            like < azimuth ? out.views[i - azimuth + like] : sharesSeen(image, kShownLevel, lookView(i), stand);
    }
    SliceStand few = stand;
    few.density = 1.0f / THIN_DENSITY;
    for (size_t i = 0; i < LOOK_ELEVATIONS; ++i) {
        for (size_t level = 0; level < SLICE_LEVELS; ++level)
            out.levels[i][level] = sharesSeen(image, level, usualView(i), stand);
        out.full[i] = out.levels[i][kShownLevel];
        out.thin[i] = sharesSeen(image, kShownLevel, usualView(i), few);
    }
    return out;
}

RowShares sharesSeen(const StandingImage& image, size_t level, const glm::vec3& e, const SliceStand& stand) {
    RowShares out{};
    float all = 0;
    const SliceSight sight = sightOf(image, level, e, stand);
    for (uint32_t ray = 0; ray < kRays; ++ray) {
        const Walked w = walk(sight, ray);
        const float both = w.most.share + w.next.share;
        if (!(both > 0)) continue;
        all += 1 - w.through;
        if (stand.traced)
            for (const MetRow& m : {w.most, w.next}) out[m.set][m.row] += m.share / both * (1 - w.through);
        else
            for (size_t set = 0; set < out.size(); ++set)
                for (size_t row = 0; row < kSliceRows; ++row) out[set][row] += w.shares[set][row];
    }
    for (auto& set : out)
        for (float& share : set) share /= std::max(all, 1e-9f);
    return out;
}

RowsSend rowsSend(const StandingImage& image, size_t level, const FieldLight& light, const glm::vec3& ambient,
                  size_t texels) {
    RowsSend out{};
    for (int axis = 0; axis < 2; ++axis)
        for (const bool before : {false, true}) {
            std::vector<SliceSun> suns;
            for (size_t i = 0; i < light.suns.size(); ++i)
                for (const bool turned : {false, true}) suns.push_back(sunOn(light, i, axis, before, turned));
            const auto at = static_cast<size_t>(axis);
            for (size_t row = 0; row < kSliceRows; ++row) {
                out[at][before][row] = rowSends(image.levels[level][at][row], light, ambient, suns, texels);
                out[at + 2][before][row] = rowSends(image.levels[kRestLevel][at][row], light, ambient, suns, texels);
            }
        }
    return out;
}

glm::vec3 sentAlong(const RowShares& shares, const RowsSend& sends, const glm::vec3& e) {
    glm::vec3 sum(0);
    for (size_t set = 0; set < shares.size(); ++set)
        for (size_t row = 0; row < kSliceRows; ++row)
            sum += shares[set][row] * sends[set][(set % 2 == 0 ? e.x : e.z) > 0][row];
    return sum;
}

glm::vec3 imageSends(const std::vector<FarTexel>& image, const FieldLight& l, const glm::vec3& ambient) {
    glm::vec3 sum(0);
    float all = 0;
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
        sum += t.shown * sent, all += t.shown;
    }
    return sum / std::max(all, 1e-9f);
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

}  // namespace sward
