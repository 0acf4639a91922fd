// The walker's step: it steers, goes as far as slopes and edges allow, jumps and falls, and sets its feet down.
#include "playtest/play_state.h"
#include "playtest/trunks.h"

namespace sward {
namespace {

constexpr double kGroundGrip = 20, kAirGrip = 3;  // m/s2 by which steering changes the velocity
constexpr double kSlopeReach = 0.15;              // metres around a place that decide how steep it is
constexpr double kStepDown = 0.02;                // metres that feet follow the ground down beyond its slope

glm::dvec2 approach(glm::dvec2 from, glm::dvec2 to, double most) {
    const glm::dvec2 gap = to - from;
    const double length = glm::length(gap);
    return length <= most ? to : from + gap * (most / length);
}

// On ground too steep to stand on, gravity takes the walker down and its steering hardly helps.
glm::dvec2 steered(const Walker& w, const PlayInput& in, glm::dvec2 slope) {
    const glm::dvec2 forward{std::sin(w.yaw), -std::cos(w.yaw)}, right{std::cos(w.yaw), std::sin(w.yaw)};
    const glm::dvec2 wanted = (right * in.move.x + forward * in.move.y) * (in.run ? kRunSpeed : kWalkSpeed);
    const double steep = glm::length(slope);
    const bool slides = w.onGround && steep > kSteepest;
    const glm::dvec2 v =
        approach(across(w.velocity), wanted, (w.onGround && !slides ? kGroundGrip : kAirGrip) * kTickSeconds);
    return slides ? v - slope * (kGravity * kTickSeconds / (1 + steep * steep)) : v;
}

bool isTooSteep(const Walker& w, const PlayWorld& world, glm::dvec2 to) {
    return groundHeight(world, to) - w.position.y > kSteepest * glm::length(to - across(w.position)) + 1e-9;
}

// The part of a way that climbs no steeper than feet hold: all of it, along the slope, or nothing.
glm::dvec2 passable(const Walker& w, const PlayWorld& world, glm::dvec2 way) {
    const glm::dvec2 at = across(w.position);
    const auto tooSteep = [&](glm::dvec2 by) { return isTooSteep(w, world, insideEdges(world, at + by, kBodyRadius)); };
    if (!tooSteep(way)) return way;
    const glm::dvec2 up = groundSlope(world, at + way, kSlopeReach);
    const double climb = glm::dot(way, up);
    if (climb > 0) way -= up * (climb / std::max(glm::dot(up, up), 1e-30));
    return tooSteep(way) ? glm::dvec2(0) : way;
}

// Returns how far it came over the ground.
double moveAcross(Walker& w, const PlayWorld& world, glm::dvec2 velocity) {
    const glm::dvec2 at = across(w.position);
    const glm::dvec2 wanted = insideEdges(world, at + passable(w, world, velocity * kTickSeconds), kBodyRadius);
    glm::dvec2 to = pastTrunks(world, at, wanted, kBodyRadius);
    if (to != wanted && isTooSteep(w, world, to)) to = at;  // a trunk's side leads up a cliff
    w.velocity.x = (to.x - at.x) / kTickSeconds;
    w.velocity.z = (to.y - at.y) / kTickSeconds;
    w.position.x = to.x;
    w.position.z = to.y;
    return glm::length(to - at);
}

// `follow`: metres that the ground may have fallen away under feet that stay on it.
void moveUp(Walker& w, const PlayWorld& world, double follow) {
    const double ground = groundHeight(world, across(w.position));
    if (w.onGround && w.position.y - ground > follow) w.onGround = false, w.velocity.y = 0;
    if (!w.onGround) {
        w.position.y += w.velocity.y * kTickSeconds - kGravity * kTickSeconds * kTickSeconds / 2;
        w.velocity.y -= kGravity * kTickSeconds;
    }
    if (!w.onGround && w.position.y > ground) return;
    w.onGround = true;
    w.position.y = ground;
    w.velocity.y = 0;
}

// Feet come down by turns, a stride apart; who stands has both beneath.
void placeFeet(Walker& w, const PlayWorld& world, double moved) {
    const glm::dvec2 at = across(w.position), side{std::cos(w.yaw), std::sin(w.yaw)};
    const double speed = moved / kTickSeconds, length = speed > (kWalkSpeed + kRunSpeed) / 2 ? kRunStride : kWalkStride;
    const auto foot = [&](int i, glm::dvec2 ahead) {
        return insideEdges(world, at + ahead + side * (i == 0 ? -kFootApart : kFootApart), 0);
    };
    w.stride += moved;
    if (speed < 0.05) {
        w.stride = 0;
        for (const int i : {0, 1}) w.feet[i] = foot(i, glm::dvec2(0));
    } else if (w.stride >= length) {
        w.stride -= length;
        if (w.stride >= length) w.stride = 0;  // it ran, and now walks
        w.stance = 1 - w.stance;
        w.feet[w.stance] = foot(w.stance, glm::normalize(across(w.velocity)) * (length * 0.4));
    }
}

}  // namespace

void stepWalker(Walker& w, const PlayWorld& world, const PlayInput& in) {
    w.yaw = in.yaw;
    w.pitch = in.pitch;
    const glm::dvec2 slope = groundSlope(world, across(w.position), kSlopeReach);
    const double steep = glm::length(slope);
    const bool jumps = in.jump && !w.jumpHeld && w.onGround && steep <= kSteepest;
    w.jumpHeld = in.jump;
    const double moved = moveAcross(w, world, steered(w, in, slope));
    if (jumps) w.onGround = false, w.velocity.y = kJumpSpeed;
    moveUp(w, world, (kSteepest + steep) * moved + kStepDown);
    if (w.onGround) placeFeet(w, world, moved);
}

void addFeet(std::vector<Contact>& contacts, const Walker& w, const PlayWorld& world) {
    if (!w.onGround) return;
    const glm::dvec2 velocity = across(w.velocity);
    const double speed = glm::length(velocity);
    const bool stands = speed < 0.05;
    const glm::dvec3 direction = stands ? glm::dvec3(0) : glm::dvec3(velocity.x, 0, velocity.y) / speed;
    for (const int i : {0, 1}) {
        if (!stands && i != w.stance) continue;  // in the air, on its way to the next place
        const glm::dvec2 at = w.feet[i];
        contacts.push_back({{at.x, groundHeight(world, at), at.y}, kFootRadius, direction, 1});
    }
}

}  // namespace sward
