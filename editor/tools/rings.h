// Circles of equal distance from a point, draped over the ground, and which of them the pointer means. Pure.
// A tier's distance is measured from the eye to the blade, so its ring on level ground has the radius
// sqrt(distance^2 - height^2), and none lies nearer than the ground below.
// Does not: draw, nor know where distances come from.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace sward {

using HeightAt = std::function<double(double x, double z)>;  // of the ground, metres

// `count` points around `centre`, the first towards +x, each on the ground and `distance` from the centre to within a
// few centimetres; nothing where the ground does not come so near. Cost: six heights a point.
std::vector<std::optional<glm::dvec3>> ringPoints(const HeightAt& heightAt, const glm::dvec3& centre, double distance,
                                                  int count);
// True if ground hides a point that lies on it from the eye; `slack` metres of it do not count.
bool hiddenByGround(const HeightAt& heightAt, const glm::dvec3& eye, const glm::dvec3& point, double slack);

// A ring as it is on the screen: consecutive points are joined, the last with the first; none: off the screen.
using ScreenRing = std::vector<std::optional<glm::dvec2>>;
struct RingHit {
    std::vector<size_t> rings;  // the nearest, and those that lie on top of it; ascending
    glm::dvec2 at{0};           // the nearest point of the first
    double share = 0;           // where that is, in points from the first
    double pixels = 0;          // how far from the pointer
};
// The rings within `tolerance` pixels of the pointer; those within a pixel and a half of the nearest count as one.
std::optional<RingHit> pickRing(std::span<const ScreenRing> rings, const glm::dvec2& pointer, double tolerance);
// Of rings that lie on top of each other: the first if the hand goes inwards, the last if it goes out.
size_t ringMeant(const RingHit& hit, double now, double wanted);
// Where a ring's name goes: its visible point nearest to a place on the screen, low ones first; nothing if none is
// within [low, high].
std::optional<glm::dvec2> ringLabel(const ScreenRing& ring, const glm::dvec2& low, const glm::dvec2& high, double x);

}  // namespace sward
