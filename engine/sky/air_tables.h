// The light of sky and air as tables: S. Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering
// Technique", EGSR 2020. What light meets on its way (section 5.2, as columns of air, haze and ozone, so that one table
// holds for every turbidity); light scattered more than once (section 5.5.4, equations 5 to 10); the sky as seen
// (section 5.3); and what the air adds to what stands in it (section 5.4, along level rays: land lies near the
// horizon). Drawing and the ray-traced truth read the same tables. Unlike the paper they are made on the CPU, since a
// picture's other light follows from them, too; the sky is that of an eye kAirEye above the ground, wherever the camera
// is. Does not: clouds, night's own light, shadows of hills in the air. Cost of a change:
// of the sun's height 0.3 million steps along rays, of the turbidity 0.9 million more, on all cores; of the haze some
// thousands. 0.3 MB.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace sward {

inline constexpr float kAirEye = 0.2f;  // km

// Values at the crossings of a grid over [0, 1] x [0, 1], rows first.
struct AirTable {
    int width = 0, height = 0;
    std::vector<glm::vec3> values;
    glm::vec3 at(float x, float y) const;  // bilinear; beyond the edges as there
};

struct AirTables {
    // What they were made for.
    float turbidity = -1, sunUp = 2, haze = -1;
    unsigned changes = 0;  // how often the last two tables were made
    AirTable columns;      // by height and distance to the top: km at full density (numerics/air.h airColumns)
    AirTable scattered;    // by the sun's and the eye's height: light from all around for 1 klx above the air
    AirTable sky;          // kcd/m2, by airAcross and skyUp
    AirTable between;      // what haze fades into, kcd/m2, by airAcross and airAlong
};

// Makes what is not yet as asked for, but for what this process made lately. sunUp: the sine of the sun's height over
// the horizon; haze: extinction of haze beside the air's own (1/m, 0 or more), which shines as the horizon does.
void updateAir(AirTables& tables, float turbidity, float sunUp, float haze);
// What a metre of air near the ground takes of light, mean over colours (1/m).
float airExtinction(float turbidity);
// Luminance of the sky, kcd/m2, in a direction (unit; below the horizon as there); sun: unit, of the height asked for.
glm::vec3 skyOf(const AirTables& tables, const glm::vec3& sun, const glm::vec3& towards);
// What the air over a distance (m) along `way` (x, z) fades into, kcd/m2: times hazeTaken(haze + airExtinction) it is
// what the air adds.
glm::vec3 airOver(const AirTables& tables, const glm::vec3& sun, const glm::vec2& way, float distance);

}  // namespace sward
