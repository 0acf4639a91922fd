// What grows on the soil, for who lights the ground (shaders/lib/soil.glsl): whoever grows it says how much light it
// leaves and by which maps, and the ground's program is compiled for that. Does not: know species or fields by name.
#pragma once
#include <epoxy/gl.h>

#include <string>
#include <vector>

namespace sward {

// Which of the maps a field and its species read, by their numbers in SoilGrowth::maps; -1: none, and then the density,
// or the share of height or sky, is 1.
struct SoilNumbers {
    int height = -1, occlusion = -1;
    std::vector<int> density;  // by species
};
// The same as text for shaders: the macro SOIL_EACH.
std::string soilConstants(const std::vector<SoilNumbers>& fields);
// What a field's programs are compiled with where it has several species, so that each stands in the others' light: the
// macro OTHERS_EACH of lib/others.glsl. end: number of the species after its last, among those of all fields.
std::string othersConstants(const SoilNumbers& field, size_t end);
// Ways in which soilConstants differs, for tests that compile every program (ProgramRow::variants).
std::vector<std::string> soilVariants();

struct SoilGrowth {
    GLuint globals = 0;        // SoilGlobals
    std::string constants;     // of soilConstants; empty: nothing grows
    std::vector<GLuint> maps;  // textures, bound from TEX_SOIL on
};
// For who lights the ground, and blades of fields of several species.
void bindSoil(const SoilGrowth& soil);

}  // namespace sward
