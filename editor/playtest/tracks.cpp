#include "playtest/tracks.h"

#include "world/forces.h"

namespace sward {
namespace {

constexpr float kShoeWidth = 0.1f, kShoeLength = 0.28f;  // metres

glm::dvec2 onGround(const glm::dvec3& p) { return {p.x, p.z}; }
double secondsOf(const PlayState& s) { return static_cast<double>(s.tick) / kTicksPerSecond; }

Entity feetOf(Project& p) {
    for (const auto& [name, e] : p.entities)
        if (const ForceSource* s = p.registry.get<ForceSource>(e);
            s && s->shape == ForceShape::Foot && !p.registry.get<Transform>(e))
            return e;
    std::string name = "feet";
    while (findEntity(p, name) != kNoEntity) name += "'";
    const Entity e = *addEntity(p, name);
    ForceSource shoes;
    shoes.shape = ForceShape::Foot;
    shoes.radius = 0.5f * kShoeWidth, shoes.length = kShoeLength, shoes.reach = 3;
    p.registry.add<ForceSource>(e, shoes);
    return e;
}

// A foot that stands keeps its print new; one that came down leaves another.
void pressFoot(ForceSource& source, const glm::dvec2& foot, double yaw, double seconds) {
    const double half = std::max(0.5 * static_cast<double>(source.length) - static_cast<double>(source.radius), 0.0);
    const glm::dvec2 along = half * glm::dvec2(std::sin(yaw), -std::cos(yaw));
    const size_t n = source.tracks.size();
    for (size_t i = n - std::min<size_t>(n, 2); i < n; ++i)
        if (glm::length(0.5 * (source.tracks[i].from + source.tracks[i].to) - foot) < 1e-6) {
            source.tracks[i].seconds = seconds;
            return;
        }
    leaveTrack(source, foot - along, foot + along, seconds);
}

}  // namespace

void Tracks::begin(Project& p, const PlayState& s) {
    feet_ = feetOf(p);
    for (const Roller& r : s.rollers) {
        const Entity e = findEntity(p, r.name);
        ends_.push_back(onGround(r.position));
        if (p.registry.get<ForceSource>(e)) continue;
        ForceSource source;
        source.radius = 0.5f * static_cast<float>(r.radius);
        p.registry.add<ForceSource>(e, source);
    }
}

void Tracks::press(Project& p, const PlayState& s) {
    ForceSource& feet = *p.registry.get<ForceSource>(feet_);
    if (s.walker.onGround)
        for (const glm::dvec2& foot : s.walker.feet) pressFoot(feet, foot, s.walker.yaw, secondsOf(s));
    for (size_t i = 0; i < s.rollers.size(); ++i) {
        const Roller& r = s.rollers[i];
        const glm::dvec2 at = onGround(r.position);
        if (r.onGround && glm::length(at - ends_[i]) < 0.5 * r.radius) continue;
        if (r.onGround) leaveTrack(*p.registry.get<ForceSource>(findEntity(p, r.name)), ends_[i], at, secondsOf(s));
        ends_[i] = at;
    }
}

}  // namespace sward
