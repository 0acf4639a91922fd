#include "playtest/play_state.h"

#include "core/hash.h"
#include "playtest/trunks.h"
#include "world/ground.h"

namespace sward {
namespace {

double finite(double v) { return std::isfinite(v) ? v : 0; }

PlayInput sound(const PlayInput& in) {
    PlayInput out = in;
    out.move = {finite(in.move.x), finite(in.move.y)};
    const double length = glm::length(out.move);
    if (length > 1) out.move /= length;
    out.yaw = finite(in.yaw);
    out.pitch = std::clamp(finite(in.pitch), -kMostPitch, kMostPitch);
    return out;
}

// Bits of numbers and flags; -0 counts as 0.
struct StateHasher {
    Hasher hasher;
    void add(double v) {
        const double plain = v + 0.0;
        hasher.add(&plain, sizeof plain);
    }
    void add(int64_t v) { hasher.add(&v, sizeof v); }
    void add(const glm::dvec3& v) { add(v.x), add(v.y), add(v.z); }
    void add(const glm::dvec2& v) { add(v.x), add(v.y); }
};

}  // namespace

double groundHeight(const PlayWorld& world, glm::dvec2 at) {
    return world.origin.y + terrainHeight(world.terrain, at.x - world.origin.x, at.y - world.origin.z);
}

glm::dvec2 groundSlope(const PlayWorld& world, glm::dvec2 at, double reach) {
    const auto along = [&](glm::dvec2 by) {
        const glm::dvec2 a = insideEdges(world, at - by, 0), b = insideEdges(world, at + by, 0);
        const double run = glm::length(b - a);
        return run > 0 ? (groundHeight(world, b) - groundHeight(world, a)) / run : 0.0;
    };
    return {along({reach, 0}), along({0, reach})};
}

glm::dvec2 insideEdges(const PlayWorld& world, glm::dvec2 at, double margin) {
    const glm::dvec2 least{world.origin.x, world.origin.z};
    const glm::dvec2 room = glm::min(glm::dvec2(margin), world.terrain.size * 0.5);
    return glm::clamp(at, least + room, least + world.terrain.size - room);
}

void placeWalker(PlayState& s, const PlayWorld& world, double x, double z, double yaw, double pitch) {
    Walker w;
    const glm::dvec2 at = outOfTrunks(world, insideEdges(world, {finite(x), finite(z)}, kBodyRadius), kBodyRadius);
    w.position = {at.x, groundHeight(world, at), at.y};
    w.yaw = finite(yaw);
    w.pitch = std::clamp(finite(pitch), -kMostPitch, kMostPitch);
    w.feet[0] = w.feet[1] = at;
    s.walker = w;
}

void stepPlay(PlayState& s, const PlayWorld& world, const PlayInput& in) {
    ++s.tick;
    stepWalker(s.walker, world, sound(in));
    stepRollers(s, world);
    s.contacts.clear();
    addFeet(s.contacts, s.walker, world);
    addRollers(s.contacts, s.rollers);
}

uint64_t hashPlay(const PlayState& s) {
    StateHasher h;
    const Walker& w = s.walker;
    h.add(s.tick);
    h.add(w.position), h.add(w.velocity), h.add(w.yaw), h.add(w.pitch), h.add(w.stride);
    h.add(w.feet[0]), h.add(w.feet[1]);
    h.add(int64_t(w.onGround) | int64_t(w.jumpHeld) << 1 | int64_t(w.stance) << 2);
    for (const Roller& r : s.rollers) {
        h.add(r.position), h.add(r.velocity), h.add(r.spin), h.add(r.normal);
        h.add(r.turn.w), h.add(r.turn.x), h.add(r.turn.y), h.add(r.turn.z);
        h.add(int64_t(r.onGround));
    }
    return h.hasher.value();
}

}  // namespace sward
