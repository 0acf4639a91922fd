#include "tools/stroke.h"

#include <chrono>

#include "core/jobs.h"
#include "core/numerics.h"
#include "scene/map_fields.h"
#include "scene/tiling.h"

namespace sward {
namespace {

constexpr double kLeastStepTexels = 0.25;  // stamps closer than this change nothing that one sees
constexpr double kHeadingReach = 0.25;     // radii of the way behind that a comb's direction is the mean of
constexpr float kHighestGround = 1e5f;     // metres, both ways, of float maps; as far as heightRange goes
constexpr int kMostImages = 64;            // of a ramp over heights that are mirrored
constexpr double kPi = 3.14159265358979323846;
constexpr double kMarginFactor = 2;  // points are kept within this many extents of the terrain around it

const Terrain* terrainOf(const Project& p, const std::string& entity) {
    if (const auto* own = p.registry.get<Terrain>(findEntity(p, entity))) return own;
    for (const auto& [name, e] : p.entities)
        if (const auto* t = p.registry.get<Terrain>(e)) return t;
    return nullptr;
}

double milliseconds() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Result<MapScale> mapScale(const Project& p, const ConstFieldRef& map) {
    if (map.row->map->onMesh) return MapScale{1, 1, true, false, 1, 1};  // in texture coordinates
    const Terrain* terrain = terrainOf(p, map.entity);
    if (!terrain) return usage("there is no terrain for " + map.path + " to lie on", "add an entity with a Terrain");
    const float factor = mapTiling(map);
    const Tiling tiling = tilingOf(*terrain, factor);
    return MapScale{tiling.metres.x, tiling.metres.y,
                    tiling.repeats,  tiling.repeats && map.row->map->kind == MapKind::Heights,
                    factor,          shaderTiling(*terrain, factor),
                    terrain->size};
}

Status checkBrush(const BrushSettings& b) {
    const auto inside = [](double v, double low, double high) { return v >= low && v <= high; };  // false for NaN
    if (!findBrush(b.mode)) {
        std::string names;
        for (const BrushRow& row : brushRows()) names += (names.empty() ? "" : ", ") + std::string(row.name);
        return usage(fmt::format("there is no brush \"{}\"", b.mode), "use one of " + names);
    }
    if (!inside(b.radius, 0, 1e6) || b.radius == 0)
        return usage("the brush's radius is not above 0, up to 1e6 m", "give a length in metres");
    if (!inside(b.strength, 0, 1)) return usage("the brush's strength is not between 0 and 1", "1 is the full effect");
    if (!inside(b.falloff, 0, 1)) return usage("the brush's falloff is not between 0 and 1", "0 is a hard edge");
    if (!inside(b.spacing, 0, 100))
        return usage("the brush's spacing is not between 0 and 100", "it is a share of the diameter");
    if (!inside(b.angleDeg, -1e6, 1e6))
        return usage("the brush's angle is not between -1e6 and 1e6", "give degrees, clockwise from north");
    for (int c = 0; c < 3; ++c)
        if (!inside(b.color[c], 0, 1))
            return usage("the brush's colour is not between 0 and 1",
                         "give red, green and blue (sRGB), each from 0 to 1");
    if (!inside(b.value, -1e6, 1e6))
        return usage("the brush's value is not between -1e6 and 1e6", "give a finite number");
    if (!inside(b.bumpSize, 0, 1e6))
        return usage("the brush's bumps are not between 0 and 1e6 m wide", "0 makes them as wide as its radius");
    if (!inside(b.talusDeg, 0, 89))
        return usage("the brush's talus angle is not between 0 and 89", "give degrees; dry sand rests at 35");
    if (!inside(b.shapeAngleDeg, -1e6, 1e6))
        return usage("the angle of the brush's shape is not between -1e6 and 1e6", "give degrees, clockwise");
    if (!inside(b.base, -1e6, 1e6))
        return usage("the brush's base is not between -1e6 and 1e6 m", "give metres, at which black lies");
    if (!inside(b.water, 0, 1)) return usage("the brush's water is not between 0 and 1", "0 is no rain");
    return {};
}

void paintHeights(BrushSettings& brush, const std::pair<double, double>& scale) {
    brush.heights = true;
    brush.low = -kHighestGround, brush.high = kHighestGround;
    brush.metres = {scale.first, scale.second};
}

std::vector<BrushSettings> speciesBrushes(const Project& p, std::span<const ComponentRow> rows,
                                          const BrushSettings& like) {
    const auto grows = [&](const std::string& entity) { return p.registry.get<GrassField>(findEntity(p, entity)); };
    std::string entity = like.map.substr(0, like.map.find('.'));
    if (!p.entities.contains(entity) || !grows(entity)) entity.clear();
    std::vector<BrushSettings> brushes;
    for (const ConstFieldRef& map : allMaps(p, rows, true)) {
        if (map.row->map->role != MapRole::Density || !grows(map.entity)) continue;
        if (entity.empty()) entity = map.entity;
        if (map.entity != entity) continue;
        brushes.push_back(like);
        brushes.back().map = map.path;
    }
    return brushes;
}

glm::dvec2 headingAfter(const glm::dvec2& before, double x, double z, double metres, double reach) {
    const double length = std::hypot(x, z);
    if (!(length > 0)) return before;
    const double kept = std::exp(-metres / reach);
    return before * kept + glm::dvec2(x, z) / length * (1 - kept);
}

Stroke::Stroke(const BrushRow& row, const BrushSettings& settings, const MapScale& scale, const MapInfo& info,
               uint32_t firstTurn)
    : row_(&row), settings_(settings), scale_(scale), info_(info), turn_(firstTurn) {
    const double texel = std::min(scale.width / info.width, scale.depth / info.height);
    step_ = std::max(2.0 * settings.spacing * settings.radius, kLeastStepTexels * texel);
    if (row.spans) settings_.shape.reset();  // its one stamp is a way, not a picture
    follows_ = row.follows || (settings_.shape && settings_.shapeTurn == ShapeTurn::Along && !row.once);
}

void Stroke::moveTo(double x, double z) {
    if (!std::isfinite(x) || !std::isfinite(z)) return;
    const double reachX = kMarginFactor * scale_.width, reachZ = kMarginFactor * scale_.depth;
    if (!scale_.repeats) {
        x = std::clamp(x, -reachX, scale_.width + reachX);
        z = std::clamp(z, -reachZ, scale_.depth + reachZ);
    }
    if (first_ && row_->once) return;
    if (!first_) first_ = glm::dvec2(x, z);
    if (row_->spans) {
        points_.assign(1, {x, z});
        return;
    }
    points_.emplace_back(x, z);
    const auto [x0, z0] = points_.front();
    const double dx = x - x0, dz = z - z0, length = std::hypot(dx, dz);
    const double reach = std::max(kHeadingReach * static_cast<double>(settings_.radius), 1e-6);
    const glm::dvec2 before = heading_;
    heading_ = headingAfter(before, dx, dz, length, reach);
    if (headless_ && length > 0) queueStamp(x0, z0, heading_), headless_ = false;
    for (const auto& [sx, sz] : stampsAlong(points_, step_, carry_)) {
        if (points_.size() == 1 && follows_)
            headless_ = true;
        else
            queueStamp(sx, sz, headingAfter(before, dx, dz, std::hypot(sx - x0, sz - z0), reach));
    }
    points_.erase(points_.begin(), points_.end() - 1);
}

void Stroke::end() {
    if (headless_) queueStamp(points_.front().first, points_.front().second, heading_);
    headless_ = false;
    if (row_->spans && !points_.empty()) queueSpans();
}

void Stroke::queue(const Stamp& stamp) {
    queue_.push_back(stamp);
    reached_ = reached_ || stampTiles(info_, stamp).count() > 0;
}

// Random ones by the stamp's number and the brush's seed (steps of the golden ratio fill the circle evenly).
double Stroke::shapeAngle(const glm::dvec2& heading) const {
    const double fixed = glm::radians(static_cast<double>(settings_.shapeAngleDeg));
    if (settings_.shapeTurn == ShapeTurn::Random) {
        const uint32_t share = turn_ * 0x9E3779B9u + static_cast<uint32_t>(settings_.seed) * 0x85EBCA6Bu;
        return fixed + 2 * kPi * share * 0x1p-32;
    }
    const bool goes = settings_.shapeTurn == ShapeTurn::Along && glm::length(heading) > 1e-9;
    return goes ? fixed + std::atan2(heading.x, -heading.y) : fixed;
}

void Stroke::queueStamp(double x, double z, const glm::dvec2& heading) {
    const double texelsX = info_.width / scale_.width, texelsZ = info_.height / scale_.depth;
    Stamp s{x * texelsX, z * texelsZ, settings_.radius * texelsX,           settings_.radius * texelsZ, turn_,
            heading.x,   heading.y,   settings_.colours ? kColourSpread : 0};
    if (settings_.shape) {
        s.angle = shapeAngle(heading);
        s.reach = std::abs(std::cos(s.angle)) + std::abs(std::sin(s.angle));
    }
    ++turn_;
    queueMirrored(s);
}

// The stamp, and its images on the other sides of the terrain's middle; on the middle line it is its own.
void Stroke::queueMirrored(const Stamp& stamp) {
    const double across = scale_.terrain.x * info_.width / scale_.width,
                 along = scale_.terrain.y * info_.height / scale_.depth;
    const bool x = settings_.mirrorX && std::abs(across - 2 * stamp.x) > 1e-6,
               z = settings_.mirrorZ && std::abs(along - 2 * stamp.y) > 1e-6;
    for (const bool flipZ : {false, true})
        for (const bool flipX : {false, true}) {
            if ((flipX && !x) || (flipZ && !z)) continue;
            Stamp s = stamp;
            if (flipX) s.x = across - s.x, s.headingX = -s.headingX, s.flipX = true;
            if (flipZ) s.y = along - s.y, s.headingZ = -s.headingZ, s.flipZ = true;
            queueRepeats(s);
        }
}

// The stamp in the map's one repeat, and what of it crosses its edges.
void Stroke::queueRepeats(Stamp s) {
    if (scale_.mirrored) {  // what falls over the edge lies nearer to the stamp's middle on this side, where it is
                            // painted already
        s.x = f64::mirrorUnit(s.x / info_.width) * info_.width;
        s.y = f64::mirrorUnit(s.y / info_.height) * info_.height;
    }
    if (!scale_.repeats || scale_.mirrored) {
        queue(s);
        return;
    }
    s.x -= std::floor(s.x / info_.width) * info_.width;
    s.y -= std::floor(s.y / info_.height) * info_.height;
    for (const int ny : {0, -1, 1})  // the repeats whose edge the stamp crosses
        for (const int nx : {0, -1, 1}) {
            Stamp shifted = s;
            shifted.x += nx * info_.width;
            shifted.y += ny * info_.height;
            if (stampTiles(info_, shifted).count() > 0) queue(shifted);
        }
}

// One stamp from a point to another; over heights that are mirrored its image in each repeat that it crosses.
void Stroke::queueSpan(const glm::dvec2& first, const glm::dvec2& last, uint32_t turn) {
    const double texelsX = info_.width / scale_.width, texelsZ = info_.height / scale_.depth;
    const glm::dvec2 texels(texelsX, texelsZ), size(info_.width, info_.height);
    Stamp s{first.x * texelsX, first.y * texelsZ, settings_.radius * texelsX, settings_.radius * texelsZ, turn};
    const glm::dvec2 begin = first * texels, end = last * texels, reach(s.radiusX, s.radiusY);
    if (!scale_.mirrored) {
        s.acrossX = end.x - begin.x, s.acrossY = end.y - begin.y;
        return queue(s);
    }
    const glm::ivec2 from(glm::floor((glm::min(begin, end) - reach) / size)),
        to(glm::floor((glm::max(begin, end) + reach) / size));
    int images = 0;
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) {
            const auto image = [&](const glm::dvec2& p) {  // of the texel that shows in repeat (x, y)
                return glm::dvec2(x % 2 != 0 ? (x + 1) * size.x - p.x : p.x - x * size.x,
                                  y % 2 != 0 ? (y + 1) * size.y - p.y : p.y - y * size.y);
            };
            const glm::dvec2 a = image(begin), across = image(end) - a;
            Stamp shown = s;
            shown.x = a.x, shown.y = a.y, shown.acrossX = across.x, shown.acrossY = across.y;
            if (stampTiles(info_, shown).count() > 0 && images++ < kMostImages) queue(shown);
        }
}

// The way from the stroke's first point to its last, and its images on the other sides of the terrain's middle.
void Stroke::queueSpans() {
    const glm::dvec2 last(points_.back().first, points_.back().second), size = scale_.terrain;
    const uint32_t turn = turn_++;
    for (const bool flipZ : {false, true})
        for (const bool flipX : {false, true}) {
            if ((flipX && !settings_.mirrorX) || (flipZ && !settings_.mirrorZ)) continue;
            const auto image = [&](const glm::dvec2& p) {
                return glm::dvec2(flipX ? size.x - p.x : p.x, flipZ ? size.y - p.y : p.y);
            };
            queueSpan(image(*first_), image(last), turn);
        }
}

// Metres, at a place in texels of the map, which may lie in another repeat.
double Stroke::heightAt(const Map& map, const glm::dvec2& texel) const {
    const glm::dvec2 share = texel / glm::dvec2(info_.width, info_.height);
    const double value =
        static_cast<double>(scale_.mirrored ? map.sample(f64::mirrorUnit(share.x), f64::mirrorUnit(share.y))
                                            : map.sample(share.x, share.y));
    return settings_.metres.x + settings_.metres.y * value;
}

// What the stroke takes from the ground as it was when it began.
void Stroke::takeHeights(const Map& map) {
    if (!settings_.heights || startHeight_) return;
    startHeight_ = heightAt(map, *first_ * glm::dvec2(info_.width / scale_.width, info_.height / scale_.depth));
    if (settings_.fromStart && row_->levels) settings_.value = static_cast<float>(*startHeight_);
    if (!row_->spans && !row_->once) return;
    for (Stamp& s : queue_) {
        s.beginHeight =
            row_->once && !settings_.fromStart ? static_cast<double>(settings_.base) : heightAt(map, {s.x, s.y});
        s.endHeight = heightAt(map, {s.x + s.acrossX, s.y + s.acrossY});
    }
}

void Stroke::beginStamp(const Map& map) {
    takeHeights(map);
    stamp_ = queue_.front();
    queue_.pop_front();
    tiles_ = stampTiles(info_, stamp_);
    if (before_.empty()) before_ = map;
}

namespace {

// Whether texels of an integer tile stand at either end of its range that did not before.
template <class T>
std::pair<bool, bool> newEnds(const Tile& before, const Tile& now) {
    const TileTexels old = before.texels(), fresh = now.texels();
    const T *a = reinterpret_cast<const T*>(old.data()), *b = reinterpret_cast<const T*>(fresh.data());
    constexpr T most = std::numeric_limits<T>::max();
    int low = 0, high = 0;
    for (size_t i = 0; i < fresh.size() / sizeof(T); ++i) {
        low |= b[i] == 0 && a[i] != 0;
        high |= b[i] == most && a[i] != most;
    }
    return {low != 0, high != 0};
}

}  // namespace

void Stroke::endStamp(const Map& map) {
    for (int ty = tiles_.y0; ty < tiles_.y1; ++ty)
        for (int tx = tiles_.x0; tx < tiles_.x1; ++tx) {
            if (settings_.heights && info_.type == PixelType::U16 && map.tile(tx, ty) != before_.tile(tx, ty)) {
                const auto [low, high] = newEnds<uint16_t>(*before_.tile(tx, ty), *map.tile(tx, ty));
                hitLow_ = hitLow_ || low, hitHigh_ = hitHigh_ || high;
            }
            before_.setTile(tx, ty, map.tile(tx, ty));
        }
    tiles_ = {};
    nextTile_ = 0;
}

void Stroke::paintTiles(Map& map, size_t count) {
    std::vector<std::shared_ptr<const Tile>> painted(count);
    const size_t columns = std::max<size_t>(1, static_cast<size_t>(tiles_.x1 - tiles_.x0));
    const auto place = [&](size_t i) {
        const size_t t = nextTile_ + i;
        return std::pair{tiles_.x0 + static_cast<int>(t % columns), tiles_.y0 + static_cast<int>(t / columns)};
    };
    parallelFor(count, [&](size_t i) {
        const auto [tx, ty] = place(i);
        painted[i] = row_->apply(before_, tx, ty, stamp_, settings_);
    });
    for (size_t i = 0; i < count; ++i) {
        const auto [tx, ty] = place(i);
        map.setTile(tx, ty, std::move(painted[i]));
    }
    nextTile_ += count;
}

void Stroke::paintWhole(Map& map) {
    row_->applyWhole(map, stamp_, settings_);
    nextTile_ = tiles_.count();
}

void Stroke::pump(Map& map, double budgetMs) {
    const double end = milliseconds() + budgetMs;
    const size_t batch = static_cast<size_t>(workerCount()) * 4;  // about half a millisecond
    while (!idle()) {
        if (tiles_.count() == 0) beginStamp(map);
        const size_t left = tiles_.count() - nextTile_;
        if (row_->applyWhole)
            paintWhole(map);
        else
            paintTiles(map, budgetMs > 0 ? std::min(left, batch) : left);
        if (nextTile_ == tiles_.count()) endStamp(map);
        if (budgetMs > 0 && milliseconds() >= end) break;
    }
    if (idle()) before_ = Map();
}

}  // namespace sward
