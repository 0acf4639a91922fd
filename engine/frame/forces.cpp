#include "frame/forces.h"

#include "core/numerics.h"
#include "frame/ground.h"

namespace sward {
namespace {

// From the middle to the middle of one end of what presses; in the world.
glm::dvec2 halfLength(const ForceSource& s) {
    if (s.shape == static_cast<int>(ForceShape::Object)) return glm::dvec2(0);
    const double angle = glm::radians(static_cast<double>(s.headingDeg));
    const double half = std::max(0.5 * static_cast<double>(s.length) - static_cast<double>(s.radius), 0.0);
    return half * glm::dvec2(std::sin(angle), -std::cos(angle));
}

}  // namespace

double trackLeft(double age, float recovery) {
    if (std::isinf(recovery)) return 1;
    if (!(recovery > 0) || !(age < static_cast<double>(recovery))) return 0;
    return 1 - f64::clumpFade(std::max(age, 0.0) / static_cast<double>(recovery));
}

std::vector<Force> forcesOf(const Project& p, double seconds) {
    const Ground ground = findGround(p);
    const glm::dvec2 origin(ground.origin.x, ground.origin.z);
    std::vector<Force> out;
    for (const auto& [name, e] : p.entities) {
        const ForceSource* s = p.registry.get<ForceSource>(e);
        if (!s || !(s->strength > 0) || !(s->radius > 0)) continue;
        for (const Track& t : s->tracks)
            if (const double left = trackLeft(seconds - t.seconds, s->recovery); left > 0)
                out.push_back({t.from - origin, t.to - origin, s->radius, s->reach, s->strength * static_cast<float>(left)});
        if (const Transform* at = p.registry.get<Transform>(e)) {
            const glm::dvec2 middle = glm::dvec2(at->position.x, at->position.z) - origin, half = halfLength(*s);
            out.push_back({middle - half, middle + half, s->radius, s->reach, s->strength});
        }
    }
    return out;
}

glm::vec3 forceAt(std::span<const Force> forces, const glm::dvec2& place) {
    glm::vec3 sum(0);
    for (const Force& f : forces) {
        const glm::vec3 one = f32::longForce(glm::vec2(place - f.from), glm::vec2(f.to - f.from), f.radius, f.reach, f.share);
        sum = {sum.x + one.x, sum.y + one.y, std::max(sum.z, one.z)};
    }
    return f32::forceOf(sum);
}

void leaveTrack(ForceSource& source, const glm::dvec2& from, const glm::dvec2& to, double seconds) {
    std::erase_if(source.tracks, [&](const Track& t) { return !(trackLeft(seconds - t.seconds, source.recovery) > 0); });
    if (std::isfinite(from.x + from.y + to.x + to.y)) source.tracks.push_back({from, to, seconds});
}

}  // namespace sward
