// Looks at a scene from many random places for pixels that are brighter than its lights can make them. Shared by tests
// (a small scene) and bench (the sample projects). Does not: look into the sun, whose disc and whose glint on water
// are.
#pragma once
#include "core/numerics.h"
#include "frame/renderer.h"
#include "grass/drawing.h"
#include "scene/technique.h"
#include "sky/daylight.h"
#include "world/ground.h"
#include "world/lights.h"
#include "world/view_camera.h"

namespace sward::test {

// What a white surface that faced all lights at once would send, and the sky at its brightest horizon besides; the
// greatest channel.
inline float lightsGive(const Project& p, double time) {
    FrameGlobals g{};
    g.exposure = 1;
    SkySums sums;
    if (sunLight(p)) addSun(g, p, time);
    if (firstOf<Sky>(p)) addSky(g, p, time, sums, nullptr);
    glm::vec3 all = g.sunLight + g.skyLight + g.groundLight, horizon(0);
    for (const glm::vec4& h : g.horizon) horizon = glm::max(horizon, glm::vec3(h));
    all += horizon;
    const LightsGlobals lamps = lampsAround(p, {0, 0, 0}, time, 1);
    for (int i = 0; i < lamps.count; ++i) all += lamps.lights[i].color;
    return std::max({all.x, all.y, all.z});
}

// Number n of the places from which a scene is looked at: a person's to a tree's height over any ground of it, down at
// the grass, the sun behind.
inline ViewCamera placeToLook(const Project& p, double time, uint32_t n) {
    const auto unit = [n](uint32_t k) { return static_cast<double>(f32::hashUnit(f32::hash3(n, k, 4711))); };
    const Ground ground = findGround(p);
    const glm::dvec2 at = ground.terrain->size * glm::dvec2(0.05 + 0.9 * unit(0), 0.05 + 0.9 * unit(1));
    const double up = terrainHeight(*ground.terrain, at.x, at.y) + 0.25 + 6 * unit(2) * unit(2);
    const Light* sun = sunLight(p);
    const glm::vec3 to = sun ? directionTo(*sun, time) : glm::vec3(0, 0, 1);
    const double away = std::atan2(-double(to.z), -double(to.x)) + 2.6 * (unit(3) - 0.5), down = 0.15 + 0.6 * unit(4);
    ViewCamera c;
    c.eye = ground.origin + glm::dvec3(at.x, up, at.y);
    c.target = c.eye + glm::dvec3(std::cos(away), -down, std::sin(away));
    c.fovDeg = 60;
    return c;
}

struct BrightPixels {
    int frames = 0, pixels = 0;
    double worst = 0;  // of all pixels, in what the lights give
};
// Adds a picture of 96 x 72. limit: in what the lights give.
inline void lookFrom(Renderer& r, const Project& p, const ViewCamera& place, double time, int msaa, double limit,
                     BrightPixels& found) {
    ViewSettings s;
    s.width = 96, s.height = 72, s.msaa = msaa, s.time = time;
    if (!r.draw(p, place, s)) return;
    ++found.frames;
    const double most = static_cast<double>(lightsGive(p, time));
    for (const float v : r.readLinear()) {
        const double share = static_cast<double>(v) / most;
        found.worst = std::max(found.worst, share);
        found.pixels += !(share <= limit);
    }
}
// All fields of a project by this way with pixels that are covered in part.
inline void setTransparency(Project& p, Transparency way) {
    for (const auto& [name, of] : fieldsOf(p)) {
        GrassDrawing drawing = of.settings<GrassDrawing>();
        drawing.transparency = way;
        p.registry.add<GrassDrawing>(findEntity(p, name), drawing);
    }
}

}  // namespace sward::test
