// What runs in a playtest: a walker and what rolls, in fixed steps of 1/60 s. Pure: no project, no window, no clock, no
// chance; the same state and inputs give the same bits, step for step. Time is counted in whole ticks, so that nothing
// drifts however late it is (T-3). Places are world metres in double, angles radians; y is up, yaw clockwise from -z
// seen from above. Does not: draw; collide with objects that neither roll nor are trunks. Cost: about 1 us a step and 1
// us a rolling thing, and 5 ns each pair of them; twice and four times as much in a forest (trunks.h).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "scene/components.h"
#include "world/forest_stand.h"

namespace sward {

inline constexpr int kTicksPerSecond = 60;
inline constexpr double kTickSeconds = 1.0 / kTicksPerSecond;
inline constexpr double kGravity = 9.81;  // m/s2
inline constexpr double kEyeHeight = 1.7;
inline constexpr double kBodyRadius = 0.3, kBodyHeight = 1.8;
inline constexpr double kWalkSpeed = 1.8, kRunSpeed = 4.8;     // m/s over the ground
inline constexpr double kJumpSpeed = 3.2;                      // m/s upwards: about half a metre
inline constexpr double kSteepest = 1;                         // rise over run that can be walked up: 45 degrees
inline constexpr double kWalkStride = 0.75, kRunStride = 1.2;  // from foot to foot
inline constexpr double kFootRadius = 0.13;
inline constexpr double kFootApart = 0.1;  // of each foot from the middle
inline constexpr double kMostPitch = 89 * 3.14159265358979 / 180;

// A forest in whose trunks nothing can walk or roll: asked by place (trunks.h).
struct PlayForest {
    ForestPlaces places;
    double thickest = 0;  // metres: radius of its thickest trunk
};
// What does not change while it is played. Heights: world/ground.h.
struct PlayWorld {
    Terrain terrain;
    glm::dvec3 origin{0};  // of the terrain
    std::vector<PlayForest> forests{};
};

// What the person holds; it holds until something else is given.
struct PlayInput {
    glm::dvec2 move{0};         // right and forward, -1 to 1 each; longer than 1 counts as 1
    double yaw = 0, pitch = 0;  // where the walker looks; pitch within kMostPitch
    bool run = false, jump = false;
};

struct Walker {
    glm::dvec3 position{0};  // between the feet
    glm::dvec3 velocity{0};  // m/s
    double yaw = 0, pitch = 0;
    bool onGround = true;
    bool jumpHeld = false;  // a jump needs a new press
    double stride = 0;      // metres since the last foot came down
    int stance = 0;         // index of the foot that came down last
    glm::dvec2 feet[2]{};   // x and z of the left and the right foot, as each last stood
};

struct Roller {
    std::string name;                                   // of its entity
    double radius = 0.25, friction = 0.06, push = 0.6;  // as Rolling
    glm::dvec3 position{0};                             // its centre
    glm::dvec3 from{0};                                 // where it was a step ago
    glm::dvec3 velocity{0};                             // m/s
    glm::dvec3 spin{0};                                 // radians a second about each axis
    glm::dquat turn{1, 0, 0, 0};
    bool onGround = false;
    glm::dvec3 normal{0, 1, 0};  // of the ground, while on it
};

// What touches the ground in a step, for what yields to it.
struct Contact {
    glm::dvec3 position{0};   // on the ground
    double radius = 0;        // of the foot's disc; of a rolling thing its own
    glm::dvec3 direction{0};  // of its motion, a unit vector; zero: it stands
    double pressed = 0;       // 0 to 1: all its weight
};

struct PlayState {
    int64_t tick = 0;  // scene time is tick / kTicksPerSecond
    Walker walker;
    std::vector<Roller> rollers;    // in the order of their names
    std::vector<Contact> contacts;  // of the last step: feet first; empty before the first
};

// Puts the walker on the ground at (x, z), or at the edge nearest to it, at rest; beside a trunk that stands there.
void placeWalker(PlayState& s, const PlayWorld& world, double x, double z, double yaw, double pitch);
// One tick. What is not finite in the input counts as 0.
void stepPlay(PlayState& s, const PlayWorld& world, const PlayInput& in);
// Over all that the next steps depend on, and the tick.
uint64_t hashPlay(const PlayState& s);

// Along x and z.
inline glm::dvec2 across(const glm::dvec3& v) { return {v.x, v.z}; }

// --- the ground; beyond the terrain it goes on as at its edge
double groundHeight(const PlayWorld& world, glm::dvec2 at);
// Rise over run along x and z, from what lies `reach` metres around.
glm::dvec2 groundSlope(const PlayWorld& world, glm::dvec2 at, double reach);
// The nearest place at least `margin` from the terrain's edges; its middle where it is too small.
glm::dvec2 insideEdges(const PlayWorld& world, glm::dvec2 at, double margin);

// --- the parts of a step (walker.cpp, rollers.cpp)
void stepWalker(Walker& w, const PlayWorld& world, const PlayInput& in);
// Where the walker's feet are down; none in the air.
void addFeet(std::vector<Contact>& contacts, const Walker& w, const PlayWorld& world);
// Moves what rolls, lets the walker push it, and parts what meets. The walker may be set back.
void stepRollers(PlayState& s, const PlayWorld& world);
// Where what rolls lies on the ground.
void addRollers(std::vector<Contact>& contacts, const std::vector<Roller>& rollers);
// Within the edges, out of trunks, and straight up out of the ground.
void settleRoller(Roller& r, const PlayWorld& world);

}  // namespace sward
