#include "reference/water_rays.h"

#include "core/numerics.h"
#include "world/ground.h"
#include "world/wind.h"

namespace sward {

WaterRays WaterRays::make(const Project& p, double time, const glm::dvec3& eye) {
    WaterRays w;
    const Ground ground = findGround(p);
    if (ground.terrain) w.places_ = watersOf(p, ground);
    if (w.places_.empty()) return w;
    w.terrain_ = ground.terrain;
    w.eye_ = eye;
    w.wind_ = windOf(p);
    for (const WaterPlace& place : w.places_) w.globals_.push_back(waterGlobals(place, w.wind_, eye, time));
    if (!w.wind_) return w;
    w.blows_ = windGlobals(*w.wind_, {eye.x, eye.z}, time);
    gustsOf(*w.wind_, w.made_);
    w.gusts_ = w.wind_->model != WindModel::Waves && w.wind_->gusts.present() ? &w.wind_->gusts.map : nullptr;
    return w;
}

std::optional<WaterMet> WaterRays::enters(const Ray& ray, double far) const {
    std::optional<WaterMet> met;
    if (!(ray.way.y < 0)) return met;
    size_t which = 0;
    for (size_t i = 0; i < places_.size(); ++i) {
        const double level = static_cast<double>(places_[i].water->level), t = (level - ray.origin.y) / ray.way.y;
        if (!(t > ray.near && t < std::min(met ? met->t : far, ray.far))) continue;
        const glm::dvec3 at = ray.origin + ray.way * t;
        if (at.x < 0 || at.z < 0 || at.x > terrain_->size.x || at.z > terrain_->size.y) continue;
        if (!within(places_[i], at.x, at.z)) continue;
        met.emplace();
        met->t = t, met->at = at, met->level = level;
        which = i;
    }
    if (!met) return met;
    const WaterGlobals& globals = globals_[which];
    met->color = globals.color, met->extinction = globals.extinction;
    if (wind_) {
        const glm::vec2 at(glm::dvec2(met->at.x - eye_.x, met->at.z - eye_.z));
        met->slope = waterSlope(globals, at, f32::rippleShare(blowsAt(blows_, gusts_ ? *gusts_ : made_, at)));
    }
    met->normal = f32::rippleNormal(met->slope);
    met->mirror = f32::waterFresnel(
        f32::roughCosine(std::max(glm::dot(met->normal, glm::vec3(-ray.way)), 0.0f), f32::kSmoothest));
    return met;
}

}  // namespace sward
