// What rolls: solid balls on the ground, or falling; the walker pushes them, and they push each other.
#include "playtest/play_state.h"
#include "playtest/trunks.h"

namespace sward {
namespace {

constexpr double kRollingShare =
    5.0 / 7;                          // of what pulls a solid ball along, the part that moves it; the rest turns it
constexpr double kBounce = 0.3;       // share of the speed that comes back
constexpr double kSoftLanding = 0.5;  // m/s below which nothing bounces
constexpr double kFastest = 60;       // m/s

struct Touch {
    glm::dvec3 normal;
    double gap;  // metres above the ground; negative: in it
};

glm::dvec3 normalAt(const PlayWorld& world, glm::dvec2 at, double radius) {
    const glm::dvec2 slope = groundSlope(world, at, std::max(radius / 2, 0.05));
    return glm::normalize(glm::dvec3(-slope.x, 1, -slope.y));
}

// The ground as the plane under the point where the ball comes nearest to it.
Touch touchOf(const PlayWorld& world, const Roller& r) {
    const glm::dvec3 guess = normalAt(world, across(r.position), r.radius);
    const glm::dvec3 n = normalAt(world, across(r.position - guess * r.radius), r.radius);
    const glm::dvec2 under = across(r.position - n * r.radius);
    const glm::dvec3 point{under.x, groundHeight(world, under), under.y};
    return {n, glm::dot(r.position - point, n) - r.radius};
}

void keepWithinEdges(Roller& r, const PlayWorld& world) {
    const glm::dvec2 in = insideEdges(world, across(r.position), r.radius);
    if (in.x != r.position.x) r.velocity.x = 0;
    if (in.y != r.position.z) r.velocity.z = 0;
    r.position.x = in.x;
    r.position.z = in.y;
}
void keepInside(Roller& r, const PlayWorld& world) {
    keepWithinEdges(r, world);
    const glm::dvec2 out = outOfTrunks(world, across(r.position), r.radius);
    r.position.x = out.x;
    r.position.z = out.y;
}

// On the way of a step, what it loses is what leads into trunks.
void meetTrunks(Roller& r, const PlayWorld& world) {
    const glm::dvec2 to = across(r.position), past = pastTrunks(world, across(r.from), to, r.radius);
    const double lost = glm::length(past - to);
    if (lost == 0) return;
    const glm::dvec2 n = (past - to) / lost;
    const double into = std::max(-glm::dot(across(r.velocity), n), 0.0);
    r.velocity += glm::dvec3(n.x, 0, n.y) * (into * (into > kSoftLanding ? 1 + kBounce : 1));
    r.position.x = past.x;
    r.position.z = past.y;
}

// Gravity along the slope against friction; what friction holds rests.
void rollAlong(Roller& r) {
    const glm::dvec3 n = r.normal;
    const glm::dvec3 pull = glm::dvec3(0, -kGravity, 0) + n * (kGravity * n.y);
    r.velocity += pull * (kRollingShare * kTickSeconds);
    r.velocity -= n * glm::dot(r.velocity, n);
    const double speed = glm::length(r.velocity), loss = r.friction * kGravity * n.y * kRollingShare * kTickSeconds;
    r.velocity *= speed > loss ? 1 - loss / speed : 0.0;
}

// Lands, stays on the ground or leaves it.
void meetGround(Roller& r, const PlayWorld& world) {
    const Touch t = touchOf(world, r);
    const double follow = r.onGround ? 0.02 + 0.3 * glm::length(r.velocity) * kTickSeconds : 0;
    const bool leaves = t.gap > follow;
    if (!leaves) r.position -= t.normal * t.gap;
    const double into = -glm::dot(r.velocity, t.normal);
    const bool bounces = !r.onGround && !leaves && into > kSoftLanding;
    if (!leaves && into > 0) r.velocity += t.normal * (into * (bounces ? 1 + kBounce : 1));
    r.onGround = !leaves && !bounces;
    r.normal = t.normal;
    if (r.onGround) r.spin = glm::cross(t.normal, r.velocity) / r.radius;
}

// On the ground by the way it came, pushed or by itself: it never slips.
void turn(Roller& r) {
    const glm::dvec3 by = r.onGround ? glm::cross(r.normal, r.position - r.from) / r.radius : r.spin * kTickSeconds;
    const double angle = glm::length(by);
    if (angle > 0) r.turn = glm::normalize(glm::angleAxis(angle, by / angle) * r.turn);
}

void move(Roller& r, const PlayWorld& world) {
    r.from = r.position;
    if (r.onGround)
        rollAlong(r);
    else
        r.velocity.y -= kGravity * kTickSeconds;
    const double speed = glm::length(r.velocity);
    if (speed > kFastest) r.velocity *= kFastest / speed;
    r.position += r.velocity * kTickSeconds;
    keepWithinEdges(r, world);
    meetTrunks(r, world);
    meetGround(r, world);
    keepInside(r, world);
}

// The walker is an upright post: it hands on its share of the way and of its speed, and is held back by what is left.
void meetWalker(Walker& w, Roller& r, const PlayWorld& world) {
    const glm::dvec2 gap = across(r.position - w.position);
    const double distance = glm::length(gap), depth = kBodyRadius + r.radius - distance;
    const bool apart = r.position.y - r.radius > w.position.y + kBodyHeight || r.position.y + r.radius < w.position.y;
    if (depth <= 0 || apart) return;
    const glm::dvec2 n = distance > 1e-9 ? gap / distance : glm::dvec2(std::sin(w.yaw), -std::cos(w.yaw));
    const double walks = std::max(glm::dot(across(w.velocity), n), 0.0), rolls = glm::dot(across(r.velocity), n);
    const double gain = std::max(r.push * walks - rolls, 0.0);
    r.velocity += glm::dvec3(n.x, 0, n.y) * gain;
    r.position += glm::dvec3(n.x, 0, n.y) * (depth * r.push);
    settleRoller(r, world);
    const double left = std::max(kBodyRadius + r.radius - glm::length(across(r.position - w.position)), 0.0);
    const glm::dvec2 free = insideEdges(world, across(w.position) - n * left, kBodyRadius);
    const glm::dvec2 back = pastTrunks(world, across(w.position), free, kBodyRadius);
    w.position = {back.x, w.onGround ? groundHeight(world, back) : std::max(w.position.y, groundHeight(world, back)),
                  back.y};
    w.velocity -= glm::dvec3(n.x, 0, n.y) * (walks * (1 - r.push));
}

// As solid balls of one stuff: the larger moves the smaller.
void meet(Roller& a, Roller& b, const PlayWorld& world) {
    const glm::dvec3 gap = b.position - a.position;
    const double reach = a.radius + b.radius, square = glm::dot(gap, gap);
    if (square >= reach * reach) return;
    const double distance = std::sqrt(square), heavyA = a.radius * a.radius * a.radius,
                 heavyB = b.radius * b.radius * b.radius;
    const glm::dvec3 n = distance > 1e-9 ? gap / distance : glm::dvec3(1, 0, 0);
    const double shareA = heavyB / (heavyA + heavyB), closing = std::max(-glm::dot(b.velocity - a.velocity, n), 0.0);
    a.position -= n * ((reach - distance) * shareA);
    b.position += n * ((reach - distance) * (1 - shareA));
    a.velocity -= n * (closing * (1 + kBounce) * shareA);
    b.velocity += n * (closing * (1 + kBounce) * (1 - shareA));
    settleRoller(a, world);
    settleRoller(b, world);
}

}  // namespace

void settleRoller(Roller& r, const PlayWorld& world) {
    keepInside(r, world);
    const Touch t = touchOf(world, r);
    if (t.gap < 0) r.position.y -= t.gap / t.normal.y;
}

void stepRollers(PlayState& s, const PlayWorld& world) {
    for (Roller& r : s.rollers) move(r, world);
    for (Roller& r : s.rollers) meetWalker(s.walker, r, world);
    for (size_t i = 0; i < s.rollers.size(); ++i)
        for (size_t k = i + 1; k < s.rollers.size(); ++k) meet(s.rollers[i], s.rollers[k], world);
    for (Roller& r : s.rollers) turn(r);
}

void addRollers(std::vector<Contact>& contacts, const std::vector<Roller>& rollers) {
    for (const Roller& r : rollers) {
        if (!r.onGround) continue;
        const double speed = glm::length(r.velocity);
        contacts.push_back(
            {r.position - r.normal * r.radius, r.radius, speed > 0.01 ? r.velocity / speed : glm::dvec3(0), 1});
    }
}

}  // namespace sward
