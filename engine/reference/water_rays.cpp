#include "reference/water_rays.h"

#include "core/numerics.h"
#include "world/ground.h"
#include "world/wind.h"

namespace sward {

WaterRays WaterRays::make(const Project& p, double time, const glm::dvec3& eye) {
    WaterRays w;
    const Water* water = waterOf(p);
    const Terrain* terrain = findGround(p).terrain;
    if (!water || !terrain) return w;
    w.terrain_ = terrain;
    w.level_ = static_cast<double>(water->level);
    w.eye_ = eye;
    w.wind_ = windOf(p);
    w.globals_ = waterGlobals(*water, w.wind_, eye, time);
    if (!w.wind_) return w;
    w.blows_ = windGlobals(*w.wind_, {eye.x, eye.z}, time);
    gustsOf(*w.wind_, w.made_);
    w.gusts_ = w.wind_->model != WindModel::Waves && w.wind_->gusts.present() ? &w.wind_->gusts.map : nullptr;
    return w;
}

std::optional<WaterMet> WaterRays::enters(const Ray& ray, double far) const {
    if (!terrain_ || !(ray.way.y < 0)) return std::nullopt;
    const double t = (level_ - ray.origin.y) / ray.way.y;
    if (!(t > ray.near && t < std::min(far, ray.far))) return std::nullopt;
    WaterMet m;
    m.t = t;
    m.at = ray.origin + ray.way * t;
    if (m.at.x < 0 || m.at.z < 0 || m.at.x > terrain_->size.x || m.at.z > terrain_->size.y) return std::nullopt;
    if (wind_) {
        const glm::vec2 at(glm::dvec2(m.at.x - eye_.x, m.at.z - eye_.z));
        m.slope = waterSlope(globals_, at, f32::rippleShare(blowsAt(blows_, gusts_ ? *gusts_ : made_, at)));
    }
    m.normal = f32::rippleNormal(m.slope);
    m.mirror =
        f32::waterFresnel(f32::roughCosine(std::max(glm::dot(m.normal, glm::vec3(-ray.way)), 0.0f), f32::kSmoothest));
    return m;
}

}  // namespace sward
