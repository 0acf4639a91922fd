// By how much a species' grass is brighter than its local light says, as rays have found it (reference/traced_light.h):
// light goes from blade to blade, through leaves and up from the soil, and what is seen of blades is rather what is
// lit. Local light knows none of that: a shadow mask, and the share of the sky by depth below the tips. Factors are of
// the mean over all that is seen of blades, by where eye and light stand; slices, which stand for all of it, take the
// means themselves. Beyond Boulanger, Pattanaik and Bouatouch 2006, section 3.3, who light slices by directions alone.
// Does not: trace (reference/traced_light.h), nor know how far down a blade is.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frame/draw_context.h"
#include "shared/grass.h"

namespace sward {

// Directions that rays were traced for: sines of elevations of the eye, those that gains of slices are for, and of the
// light; angles between their level parts, closest to what is lit.
inline constexpr int kTracedViews = 6, kTracedLights = TRACED_LIGHTS, kTracedTurns = 10;
inline constexpr float kViewSines[kTracedViews]{0.04f, 0.16f, 0.36f, 0.6f, 0.8f, 0.98f};
inline constexpr float kLightSines[kTracedLights]{0.1f, 0.2f, 0.35f, 0.5f, 0.65f, 0.8f, 0.99f};
inline constexpr float kTurns[kTracedTurns]{0, 0.1f, 0.3f, 0.6f, 0.95f, 1.3f, 1.7f, 2.2f, 2.7f, 3.1415927f};

// What is seen of full grass on level ground sends on average, of light that would light what faces it by 1.
struct TracedShows {
    std::array<glm::vec3, kTracedViews * kTracedLights * kTracedTurns> direct{};  // without the glow about the light
    std::array<glm::vec3, kTracedViews> sky{}, skyTilt{}, ground{};               // of light from above and from below
};
// The same of grass that leans as far as its paint can lean it, on average over all ways that it may lean, and times
// the cosine and the sine of the angle from the eye's azimuth to that of the lean, and of twice that angle.
inline constexpr int kTracedLeans = 5;
struct LeaningShows {
    std::array<decltype(TracedShows::direct), kTracedLeans> direct{};  // of lights to one side: a turn towards z from x
    std::array<decltype(TracedShows::sky), kTracedLeans> sky{};
    float lean = 0;  // m per m; 0: was not traced
};
// Numbers of the polynomials of numerics/traced.h, red, green and blue.
struct TracedFactors {
    std::array<glm::vec3, TRACED_DIRECT> direct{};       // as SpeciesGlobals::traced has them
    std::array<glm::vec3, TRACED_RISE> sky{}, ground{};  // of light from above and from below
    std::array<glm::vec3, TRACED_RISE> skyTilt{};        // what `sky` gains a unit of the sky's tilt (sky/daylight.h)
};
// The same in two parts, so that the shade among blades is not black.
struct TracedParts {
    std::array<glm::vec3, TRACED_DIRECT>
        direct{};                               // over what local light says, without what comes from blade to blade
    std::array<glm::vec3, TRACED_FILL> fill{};  // of that, as light on a blade of any direction, by where it is
};
struct TracedLight {
    TracedFactors blades;  // over what local light says of each point of a blade that is seen
    TracedParts parts;
    TracedShows shows;
    TracedShows grey;            // of the same lawn all of reflectance TRACED_GREY, without highlights
    glm::vec3 soilScattered{0};  // polynomial by the sun's elevation
    float soilSky = 1;           // share of the sky's light that comes to the soil
    float soilTilt = 0;          // what that gains a unit of tilt
    float recollision = 0;       // share of the light that a blade sends which meets another and is seen of it
    LeaningShows leaning;        // last: files of grass that nothing leans end before it
};
// The same under a sky of this tilt: each `sky` and `soilSky` are what they are there.
TracedLight underSky(const TracedLight& traced, const glm::vec3& tilt);
// Share of the light on what faces the sun, so high (sine), that comes to the soil from blade to blade.
float soilScattered(const TracedLight& traced, float sinElevation);
// Of the fields' species, by the field's name; nothing while it is being traced.
struct TracedState : EffectState {
    struct One {
        uint64_t asked = 0;                // what the light was traced for
        std::optional<TracedLight> light;  // under an even sky
        TracedLight here;                  // under the frame's, if there is any
        Job<TracedLight> bake;
        uint64_t bakeOf = 0;  // what it makes
    };
    std::map<std::string, std::vector<One>> fields;
    void jobs(std::vector<JobNews>& out) const override;
};

// What is there for a species of a field; null: local light is all.
const TracedLight* tracedOf(const DrawContext& ctx, const std::string& field, size_t species);
// The factors for an eye and a light (unit, towards them), at least 0.
glm::vec3 tracedDirect(const TracedFactors& traced, const glm::vec3& toEye, const glm::vec3& towards);
// The same without the glow about the light's own direction, which is narrower than a table of views is fine.
glm::vec3 tracedBeside(const TracedFactors& traced, const glm::vec3& toEye, const glm::vec3& towards);
// By what share of tracedBeside the glow is brighter in its middle, at least 0.
glm::vec3 tracedHotSpot(const TracedFactors& traced, const glm::vec3& towards);
// What `direct` of TracedShows says between the directions that were traced, and what one of the others says of a view
// so high (sine).
glm::vec3 shownDirect(const decltype(TracedShows::direct)& direct, const glm::vec3& toEye, const glm::vec3& towards);
glm::vec3 shownRise(const std::array<glm::vec3, kTracedViews>& shows, float sinElevation);
glm::vec3 tracedRise(const std::array<glm::vec3, TRACED_RISE>& numbers, float sinElevation);
// Writes them for shaders. Null: factors of 1.
void setTraced(SpeciesGlobals& g, const TracedLight* traced);
// What comes of the sun's light from blade to blade in full grass; sun: unit, towards it.
void setSunFill(glm::vec4 (&fill)[TRACED_HEIGHTS], const TracedLight& traced, const glm::vec3& sun);

}  // namespace sward
