// A forest's volume on the GPU: made beside the pictures where one may wait for it, with a draft shown meanwhile, and
// lit anew where the sun has moved. Does not: say how it is drawn (forest/texcells.h).
#pragma once
#include "forest/foliage.h"
#include "forest/slicing.h"
#include "forest/stand.h"
#include "forest/volume_images.h"

namespace sward {

struct Volume {
    VolumeSpec spec;                // what is asked for
    uint64_t key = 0, shown = 0;    // its hash; that of what the textures hold, ~key: a draft of it
    uint64_t grown = 0, stood = 0;  // as ForestHere
    float voxelOf = 0;              // Forest::voxel
    VolumeStorage storageOf{};      // Forest::storage
    float verticalScale = 1;        // Forest::verticalScale
    Job<VolumeImages> bake;
    VolumeImages images;  // its levels are dropped once they are a texture
    int levels = 0;       // of the pyramid
    Texture slabs, slots, light;
    glm::vec3 sun{0};                                // that the light is of
    glm::vec3 bakedSun{0};                           // the way to it through what is baked (forest/stretch.h)
    LightShares past;                                // of it, on level ground
    std::array<bool, FOREST_RISES> lit{};            // for which the texture has it
    float floorSun = 1, floorSky = 1;                // shares of it, and of the sky's, that reach the lowest parts
    std::vector<FoliageTable> foliage;               // under it, by species
    std::vector<Prism> prisms;                       // of StandingForest::triangles
    Buffer globals;                                  // of its light, for meshes
    std::array<std::vector<float>, 2> stretchedSky;  // skyThrough at another verticalScale than 1; empty: not made
    // Metres that all slabs reach, as they stand.
    double height() const { return images.height * static_cast<double>(verticalScale); }
    const std::array<std::vector<float>, 2>& sky() const { return stretchedSky[0].empty() ? images.sky : stretchedSky; }
};

// Has the textures show what the forest is, or a draft of it. owner: charged for their bytes.
void ensureVolume(DrawContext& ctx, const std::string& owner, Volume& v, const ForestHere& here);
// How steeply the sun's light comes down against slopes, as a factor of what it does on level ground: those for which
// it is stored. A tile takes the nearest.
inline constexpr std::array<double, FOREST_RISES> kRises = {0.3, 0.6, 1, 1.6};
static_assert(kRises[FOREST_LEVEL] == 1);
// Has the light be that of a sun in this direction (unit), on level ground alone. True where it was another.
bool lightVolume(Volume& v, const glm::vec3& sun);
// How full the forest stands along the way to the sun, and all around as far as it is high: Prism::canopy;
// and by which of kRises the sun's light comes.
void fillCanopies(Volume& v, const StandingForest& f, const glm::dvec3& sun);

// Has the light for all slopes that its tiles have, after fillCanopies.
void lightSlopes(Volume& v);

}  // namespace sward
