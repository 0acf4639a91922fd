// What grows on the soil, for who lights the ground (shaders/lib/soil.glsl): whoever grows it says how much light it leaves
// and by which maps, and the ground's program is compiled for that. Does not: know species or fields by name.
#pragma once
#include <epoxy/gl.h>

#include <string>
#include <vector>

namespace sward {

// Which of the maps each species and field reads; -1: none, and then the density, or the share of height or sky, is 1.
struct SoilNumbers {
    std::vector<int> fieldOf, density;   // by species
    std::vector<int> height, occlusion;  // by field
};
// The numbers as constants for shaders.
std::string soilConstants(const SoilNumbers& numbers);
// Ways in which they differ, for tests that compile every program (ProgramRow::variants).
std::vector<std::string> soilVariants();

struct SoilCover {
    GLuint globals = 0;                               // SoilGlobals
    std::string constants = soilConstants({});        // nothing grows
    std::vector<GLuint> maps;                         // textures, bound from TEX_SOIL on
};

}  // namespace sward
