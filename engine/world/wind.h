// Which wind blows, and how hard at a place and time: one evaluation for all techniques and for the reference.
// Formulas: numerics/wind.h (waves: Jahrmann and Wimmer 2013, equation 9), numerics/gust.h. Does not: draw, bend
// blades. Places are metres relative to the terrain's corner; what shaders get of them is relative to the eye and
// wrapped in double.
#pragma once
#include <glm/glm.hpp>

#include "scene/project.h"
#include "shared/wind.h"

namespace sward {

// The first Wind by name that blows; null in a calm.
const Wind* windOf(const Project& p);

// The picture of gusts that the program makes: 128 x 128, two octaves of periodic noise, values spread over [0, 1].
Map makeGusts();
// The wind's own picture, or the made one, which `made` keeps once it is needed. Empty for waves.
const Map& gustsOf(const Wind& wind, Map& made);
// How many gusts lie along and across a picture: it covers so many times gustSize.
inline constexpr double kGustsInPicture = 8;

// The lean (m per m) that a full gust gives a species: Wind.strength divided by its stiffness; at most what the
// strongest wind gives one of stiffness 1, which lies as flat as blades do (numerics/population.h, poseBlade).
float windStrength(const Wind& wind, const Species& species);

// As shaders read it, for a stiffness of 1: way.z is the strength. eye: relative to the terrain's corner. seconds:
// scene time, of any age.
WindGlobals windGlobals(const Wind& wind, const glm::dvec2& eye, double seconds);
// Seconds after which waves are again what they were: infinite without waves. c1 and c3 are taken in twentieths for it.
double wavePeriod(const Wind& wind);

// How hard it blows at a place relative to the eye of `g`: [-1, 1] for waves, [0, 1] for gusts.
float blowsAt(const WindGlobals& g, const Map& gusts, const glm::vec2& at);
// The lean (m per m) that it gives there; to a blade of `grain` in [0, 1]. A negative grain: to none in particular, as
// to slices.
glm::vec2 windLeanAt(const WindGlobals& g, const Map& gusts, const glm::vec2& at, float grain);
// By how much at most the lean changes over a metre. Sure, not close.
float windSlope(const WindGlobals& g, const Map& gusts);

}  // namespace sward
