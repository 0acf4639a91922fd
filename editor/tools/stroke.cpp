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
constexpr double kMarginFactor = 2;        // points are kept within this many extents of the terrain around it

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
                    tiling.repeats,  tiling.repeats && map.row->map->role == MapRole::Heights,
                    factor,          shaderTiling(*terrain, factor)};
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
    return {};
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
}

void Stroke::moveTo(double x, double z) {
    if (!std::isfinite(x) || !std::isfinite(z)) return;
    const double reachX = kMarginFactor * scale_.width, reachZ = kMarginFactor * scale_.depth;
    if (!scale_.repeats) {
        x = std::clamp(x, -reachX, scale_.width + reachX);
        z = std::clamp(z, -reachZ, scale_.depth + reachZ);
    }
    points_.emplace_back(x, z);
    const auto [x0, z0] = points_.front();
    const double dx = x - x0, dz = z - z0, length = std::hypot(dx, dz);
    const double reach = std::max(kHeadingReach * static_cast<double>(settings_.radius), 1e-6);
    const glm::dvec2 before = heading_;
    heading_ = headingAfter(before, dx, dz, length, reach);
    if (headless_ && length > 0) queueStamp(x0, z0, heading_), headless_ = false;
    for (const auto& [sx, sz] : stampsAlong(points_, step_, carry_)) {
        if (points_.size() == 1 && row_->follows)
            headless_ = true;
        else
            queueStamp(sx, sz, headingAfter(before, dx, dz, std::hypot(sx - x0, sz - z0), reach));
    }
    points_.erase(points_.begin(), points_.end() - 1);
}

void Stroke::end() {
    if (headless_) queueStamp(points_.front().first, points_.front().second, heading_);
    headless_ = false;
}

void Stroke::queueStamp(double x, double z, const glm::dvec2& heading) {
    const double texelsX = info_.width / scale_.width, texelsZ = info_.height / scale_.depth;
    Stamp s{x * texelsX, z * texelsZ, settings_.radius * texelsX,           settings_.radius * texelsZ, turn_++,
            heading.x,   heading.y,   settings_.colours ? kColourSpread : 0};
    if (scale_.mirrored) {  // what falls over the edge lies nearer to the stamp's middle on this side, where it is
                            // painted already
        s.x = f64::mirrorUnit(s.x / info_.width) * info_.width;
        s.y = f64::mirrorUnit(s.y / info_.height) * info_.height;
    }
    if (!scale_.repeats || scale_.mirrored) {
        queue_.push_back(s);
        return;
    }
    s.x -= std::floor(s.x / info_.width) * info_.width;
    s.y -= std::floor(s.y / info_.height) * info_.height;
    for (const int ny : {0, -1, 1})  // the repeats whose edge the stamp crosses
        for (const int nx : {0, -1, 1}) {
            Stamp shifted = s;
            shifted.x += nx * info_.width;
            shifted.y += ny * info_.height;
            if (stampTiles(info_, shifted).count() > 0) queue_.push_back(shifted);
        }
}

void Stroke::beginStamp(const Map& map) {
    stamp_ = queue_.front();
    queue_.pop_front();
    tiles_ = stampTiles(info_, stamp_);
    if (before_.empty()) before_ = map;
}

void Stroke::endStamp(const Map& map) {
    for (int ty = tiles_.y0; ty < tiles_.y1; ++ty)
        for (int tx = tiles_.x0; tx < tiles_.x1; ++tx) before_.setTile(tx, ty, map.tile(tx, ty));
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

void Stroke::pump(Map& map, double budgetMs) {
    const double end = milliseconds() + budgetMs;
    const size_t batch = static_cast<size_t>(workerCount()) * 4;  // about half a millisecond
    while (!idle()) {
        if (tiles_.count() == 0) beginStamp(map);
        const size_t left = tiles_.count() - nextTile_;
        paintTiles(map, budgetMs > 0 ? std::min(left, batch) : left);
        if (nextTile_ == tiles_.count()) endStamp(map);
        if (budgetMs > 0 && milliseconds() >= end) break;
    }
    if (idle()) before_ = Map();
}

}  // namespace sward
