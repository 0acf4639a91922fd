#include "playtest/playtest.h"

#include <glm/gtc/matrix_transform.hpp>

#include "playtest/trunks.h"
#include "tools/camera_control.h"
#include "world/ground.h"
#include "world/placement.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kLatestSeconds = 1e9;
constexpr double kMostSeconds = 0.25;  // of the clock at once: a slow machine plays slowly rather than in leaps

std::vector<Roller> rollersOf(const Project& p, const PlayWorld& world) {
    std::map<const StaticMesh*, PlacedMesh> placed;
    for (const PlacedMesh& m : placedMeshes(p)) placed[m.mesh] = m;
    std::vector<Roller> out;
    for (const auto& [name, e] : p.entities) {
        const Rolling* rolling = p.registry.get<Rolling>(e);
        if (!rolling) continue;
        Roller r{name, static_cast<double>(rolling->radius), static_cast<double>(rolling->friction),
                 static_cast<double>(rolling->push)};
        const Transform* at = p.registry.get<Transform>(e);
        if (at) r.position = at->position;
        if (const auto it = placed.find(p.registry.get<StaticMesh>(e)); it != placed.end()) {
            r.position = it->second.at;
            r.turn = glm::quat_cast(it->second.turn);
        }
        settleRoller(r, world);
        out.push_back(r);
    }
    return out;
}

bool sound(const PlayStart& s) {
    bool finite = std::isfinite(s.time) && std::abs(s.time) <= kLatestSeconds;
    for (int i = 0; i < 3; ++i) finite &= std::isfinite(s.view.eye[i]) && std::isfinite(s.view.target[i]);
    return finite;
}

}  // namespace

Result<std::unique_ptr<Playtest>> Playtest::start(const Project& p, std::span<const ComponentRow> rows,
                                                  const PlayStart& start) {
    const Ground ground = findGround(p);
    if (!ground.terrain) return failed("there is no ground to walk on", "add a Terrain to an entity");
    if (!sound(start))
        return failed("play cannot start there or then", "give finite numbers, and a time within 1e9 seconds");
    std::unique_ptr<Playtest> play(new Playtest);
    play->project_ = snapshot(p, rows);
    play->world_ = {*ground.terrain, ground.origin, playForests(p)};
    play->view_ = start.view;
    play->byClock_ = start.byClock;
    play->now_.tick = std::llround(start.time * kTicksPerSecond);
    const FlyCamera look = flyFrom(start.view);
    placeWalker(play->now_, play->world_, start.view.eye.x, start.view.eye.z, look.yaw, look.pitch);
    play->now_.rollers = rollersOf(p, play->world_);
    play->before_ = play->now_;
    play->tracks_.begin(play->project_, play->now_);
    play->input_.yaw = look.yaw;
    play->input_.pitch = look.pitch;
    play->show();
    return play;
}

void Playtest::hold(const PlayInput& input) {
    if (glm::length(input.move) > 0 || input.jump) walk_.reset();
    input_ = input;
}

Status Playtest::walkAlong(const std::string& entity) {
    const Entity e = findEntity(project_, entity);
    const GroundPath* path = e == kNoEntity ? nullptr : project_.registry.get<GroundPath>(e);
    if (!path) return usage(entity + " has no GroundPath to walk along", "name an entity with one");
    PathWalk walk = pathWalk(*path, world_.origin);
    if (walk.stations.empty()) return usage(entity + ".GroundPath has no points", "draw some: the path tool (P)");
    walk_ = std::move(walk);
    return {};
}

void Playtest::takeStep() {
    if (walk_ && !steer(*walk_, world_, now_.walker, input_)) walk_.reset();
    stepPlay(now_, world_, input_);
    tracks_.press(project_, now_);
}

// The picture then shows the last step itself.
void Playtest::step(int64_t steps) {
    for (int64_t i = 0; i < steps; ++i) takeStep();
    before_ = now_;
    due_ = 0;
    show();
}

bool Playtest::advance(double seconds) {
    if (!runs()) return false;
    due_ += std::clamp(seconds, 0.0, kMostSeconds) * kTicksPerSecond;
    const int steps = static_cast<int>(due_ + 1e-6);  // a screen of 60 Hz takes one a frame
    due_ = std::max(0.0, due_ - steps);
    for (int i = 0; i < steps; ++i) {
        before_ = now_;
        takeStep();
    }
    show();
    return seconds > 0;
}

double Playtest::time() const {
    if (before_.tick == now_.tick) return static_cast<double>(now_.tick) / kTicksPerSecond;
    return (static_cast<double>(before_.tick) + due_) / kTicksPerSecond;
}

// The eye lies between two steps; where it looks is the hand's own.
ViewCamera Playtest::view() const {
    const double share = before_.tick == now_.tick ? 1 : due_;
    FlyCamera c;
    c.eye = glm::mix(before_.walker.position, now_.walker.position, share) + glm::dvec3(0, kEyeHeight, 0);
    c.yaw = input_.yaw;
    c.pitch = input_.pitch;
    c.fovDeg = view_.fovDeg;
    c.exposure = view_.exposure;
    return viewOf(c);
}

void Playtest::show() {
    const double share = before_.tick == now_.tick ? 1 : due_;
    for (size_t i = 0; i < now_.rollers.size(); ++i) {
        const Roller &a = before_.rollers[i], &b = now_.rollers[i];
        const Entity e = findEntity(project_, b.name);
        project_.registry.add<Transform>(e, {glm::mix(a.position, b.position, share)});
        StaticMesh* mesh = project_.registry.get<StaticMesh>(e);
        if (!mesh) continue;
        mesh->onGround = false;
        mesh->rotationDeg = degreesOf(glm::mat3_cast(glm::slerp(a.turn, b.turn, share)));
    }
}

}  // namespace sward
