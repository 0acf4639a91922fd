// Ambient occlusion of the ground: which share of the sky, weighted by the cosine to the ground's normal, hills and
// objects leave to see, but for objects that darken the ground by themselves (hasTracedLight;
// reference/ground_around.h). Rays are stratified over the hemisphere and jittered by an integer hash of texel and ray:
// the same scene gives the same map on every machine and with any number of threads. Does not: colour bleeding, grass
// (its own darkening is a species' rootOcclusion). Cost: about 3 million rays a second on two cores; 512 x 512 texels
// of 64 rays: 5 s. The error of a texel of n rays is below 0.5 / sqrt(n), mostly far below.
#pragma once
#include "core/jobs.h"
#include "maps/map.h"
#include "reference/scene_rays.h"

namespace sward {

struct OcclusionSettings {
    int samples = 64;  // rays a texel, 1 to 65536; rounded down to a square number
    int size = 0;      // texels along the terrain's longer side, 1 to 8192; 0: as the map that is there, else 512
};

// Share of the sky seen from a point with this normal. id: decides the jitter. spread: metres over which origins are
// scattered, each put on the surface.
double skySeen(const RayScene& rays, const TerrainSurface& ground, double x, double z, const glm::dvec2& spread,
               int samples, uint32_t id);

// A map of one channel, 8 bits, over the terrain of the project (with its first GrassField's map as a model for the
// size). Unsound error without a terrain, or if an object's file cannot be read; Failed when cancelled.
Result<Map> bakeOcclusion(const Project& p, const OcclusionSettings& settings, JobControl& control);
// Names the map that bakeOcclusion would make.
uint64_t occlusionHash(const Project& p, const OcclusionSettings& settings);

}  // namespace sward
