// Light from blade to blade, traced once a species and kept: by how much its grass is brighter than local light says
// (grass/traced.h), over all views and lights.
// Rays are sent down onto an endless lawn of the species at full density. What blade they meet is lit twice: as
// techniques light it (a shadow mask's mean at that height; the share of the sky that the depth below the tips leaves),
// and by paths, from blade to blade and through them, up to the sky or down to the soil, with light from 70 directions
// at each meeting. The quotients of the sums are fitted by polynomials; the paths' means are kept as they are. The soil
// sends nothing of its own light: what comes up from it is counted as light from below, as dim as the soil lies under
// the grass. Does not: know slopes, paint, wind, other species, or objects near by. Cost: about 4 s a species on two
// cores and 12 KB in the cache folder; twice that time and 38 KB where paint leans it.
#pragma once
#include <filesystem>

#include "core/jobs.h"
#include "grass/slice_bake.h"
#include "grass/traced.h"
#include "scene/technique.h"

namespace sward {

struct EffectRow;

struct TracedSpec {
    SliceSpec species;          // its slices' sizes are not read
    std::filesystem::path dir;  // of the project, in which the blade's texture lies
    bool leans = false;         // whether anything leans its grass: what that changes is traced, too
};
TracedSpec tracedSpec(const Project& project, const FieldEntity& field, size_t species, const Rgba8& blade);
// Hash over all that traceLight reads.
uint64_t tracedKey(const TracedSpec& spec);

// Sums over what was seen, for one direction of the eye (by elevation) and one light.
struct TracedSums {
    glm::dvec3 local{0}, full{0}, grey{0};  // the last as `full`, if all of the lawn were of reflectance TRACED_GREY
    // Adds each of the other's sums to its own.
    void add(const TracedSums& o) { local += o.local, full += o.full, grey += o.grey; }
};
// What rays have seen, before it is fitted.
struct TracedTable {
    std::array<int, kTracedViews> met{};  // rays that the sums of a view are of
    std::array<std::array<TracedSums, kTracedLights * kTracedTurns>, kTracedViews> direct;  // by turn, then elevation
    std::array<TracedSums, kTracedViews> sky, ground;
    // Of direct light, by the heights of TracedParts::fill: what came from blade to blade to what is seen, over all
    // directions of an elevation of the light; and the reflectance of what is seen, by view.
    std::array<std::array<glm::dvec3, TRACED_HEIGHTS>, kTracedLights> filled{};
    std::array<std::array<glm::dvec3, TRACED_HEIGHTS>, kTracedViews> reflect{};
    struct Leaning {  // full: sums as LeaningShows has means
        std::array<std::array<glm::dvec3, kTracedLeans>, kTracedLights * kTracedTurns> direct{};
        std::array<glm::dvec3, kTracedLeans> sky{};
        int met = 0;
    };
    std::array<Leaning, kTracedViews> leaning;
    float lean = 0;                             // of those, m per m; 0: none were traced
    std::array<TracedSums, kTracedViews> tilt;  // full: of the sky's tilt alone; local: as under an even sky
    // What comes to the soil, as shares of the sky's light and of that on what faces the sun, by the sun's elevation.
    // What is seen of direct light that was sent by one blade and by two, and that the second would send if it sent all
    // on: luminance, over all views and lights.
    double once = 0, twice = 0;
    double soilSky = 0, soilTilt = 0;  // the latter a unit of the sky's tilt
    std::array<double, kTracedLights> soilScattered{};
};

// rays: that meet a blade, a view. Failed without memory or when cancelled.
Result<TracedTable> traceTable(const TracedSpec& spec, int rays, JobControl& control);
// The polynomials that come nearest to a table's quotients.
TracedLight fitTraced(const TracedTable& table);
// From the cache folder, or traced and kept there.
Result<TracedLight> tracedLight(const std::filesystem::path& folder, const TracedSpec& spec, JobControl& control);

// Row of the effect "grass/traced": runs in scenes with grass that asks for GrassTraced. In the editor it traces beside
// the pictures, and local light is all until then.
const EffectRow& tracedEffect();

}  // namespace sward
