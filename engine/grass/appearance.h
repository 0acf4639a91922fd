// How grass looks in the mean: radiance of what is seen of its blades by view, so that every tier can be given the mean
// of the blades it stands for. Why: slices hold two views of a volume and light from five directions (Boulanger et al.
// 2006, section 3.3), blades are seen and lit from all. At a sun of 42 degrees the interpolated light alone is a third
// too dark, and a view from above shows other faces than one from the side: without a gain, tiers meet in a visible
// ring. What blades send is what paths have seen (grass/traced.h); where none were traced, means over 64 blades x 4
// points x 4 mirrorings, by how much of each is seen: its area towards the eye, and Beer's law over what stands above
// it. What slices send is told from their images (grass/image_light.h). Pure. Cost: 5 ms a species when its blades or
// the light change; nothing otherwise.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "frame/color_image.h"
#include "grass/image_light.h"
#include "scene/population.h"
#include "shared/slices.h"

namespace sward {

// Share of light from a direction (unit, towards it) that the neighbours leave at density 1 to a point so high over the
// ground (m), in the mean around the blade.
float maskPasses(const BladeShade& shade, float height, const glm::vec3& light);

// A point of a blade that stands for others.
struct LookPoint {
    glm::vec3 color;  // reflectance
    glm::vec3 control, tip;
    glm::vec2 facing;
    float along;
    float area;  // m2 of blade a m2 of ground at density 1 that it stands for
    float open;  // ambient light that reaches it
};
struct Look {
    std::vector<LookPoint> points;
    float across = 0;                     // area towards a level view, m2 a m2 of ground, mean over azimuths
    float above = 0;                      // area towards a view from the zenith
    float laidAcross = 0, laidAbove = 0;  // the same of blades that are pressed down
    float height = 0;                     // mean, metres
    float grazed = 0;                     // mean height where rays that come in almost level meet blades, metres
    float clumpLean = 0;  // metres a metre by which clumps lean blades, one standard deviation; slices do not know it
};
// Made anew if the species or `key`, of its patch and its blade's image, differ from what it was made from.
void updateLook(Look& look, uint64_t& madeFrom, const Species& species, const Patch& patch, uint64_t key,
                const Rgba8& blade);

// Share of light from this elevation that full grass leaves to the soil: Beer's law.
float lightLeft(const Look& look, float sinElevation);
// Likewise of light from `towards` (unit) over ground of this slope (numerics/slope.h).
float lightLeft(const Look& look, const glm::vec3& towards, const glm::vec2& slope);

inline constexpr float kThinDensity = 1.0f / THIN_DENSITY;
// By view: LOOK_AZIMUTHS (x = cos a, z = sin a towards the eye, fastest) times LOOK_ELEVATIONS.
struct Gains {
    std::array<glm::vec3, LOOK_VIEWS> slices, far;  // factors of vertical slices and of the horizontal one
    std::array<glm::vec3, LOOK_VIEWS> thin;         // rgb: as `far` where the field's density is kThinDensity: one sees
                                                    // further down, where others shade less
    // rgb: how many times as bright blades that are pressed down are as those that stand; 1 where none may be.
    std::array<glm::vec3, LOOK_VIEWS> laid;
    // By how much paint is drawn brighter, as LookGain has it; 1 where there is none.
    std::array<glm::vec3, LOOK_VIEWS> paintAcross, paintAbove;
    std::array<float, LOOK_VIEWS> shine{};  // highlights on paint, likewise
    // By what share grass brightens as its blades lean, as LookGain has it: x, z, xx, zz, xz.
    std::array<std::array<glm::vec3, LOOK_VIEWS>, 5> leans{};
    // As SliceGlobals has them.
    std::array<float, FAR_LEVELS> farLevels{1, 1, 1, 1, 1, 1, 1, 1};
    LevelFactors sliceLevels = evenLevels();
    std::array<float, LOOK_ELEVATIONS> thinner{1, 1, 1, 1, 1, 1, 1, 1};
    glm::vec3 sliceAmbient, farAmbient;    // ambient light that their texels are taken to receive
    glm::vec3 hotSpot{0}, lampHotSpot{0};  // as SliceGlobals has them
    float recollision = 0;                 // likewise
};
// Factors by which slices and pressed blades are drawn so that they are as bright as blades drawn one by one.
Gains gainsOf(const Look& look, const FieldLight& light, const DrawnImages& images);

// Factors for light from one direction, by where the eye and the light are: LAMP_AZIMUTHS, x fastest; LAMP_ELEVATIONS
// of the eye, then of the light.
inline constexpr size_t kDirectedGains = static_cast<size_t>(LAMP_AZIMUTHS * LAMP_ELEVATIONS * LAMP_ELEVATIONS);
// Of lamps' light, which comes from elsewhere at each place, so that the sun's gains say nothing of it: x, of vertical
// slices; y, of the horizontal one.
using LampGains = std::array<glm::vec2, kDirectedGains>;
// leaves: roughness, gloss, translucency; how lamps are shaded. Its lights are not read.
LampGains lampGainsOf(const Look& look, const FieldLight& leaves, const DrawnImages& images);
// Of the sun's on objects, where it stands elsewhere over each place: rgb, of vertical slices; a, by how many times as
// much the horizontal one is drawn brighter as they are.
using SunGains = std::array<glm::vec4, kDirectedGains>;
// leaves: likewise, and how slices weigh their images.
SunGains sunGainsOf(const Look& look, const FieldLight& leaves, const DrawnImages& images);
}  // namespace sward
