// The ray-traced truth of a project: what its cameras would see if nothing had to be quick. Every blade that the maps
// call for (grass_rays.h), ground and objects (solids.h), met exactly; light that reaches them traced. What techniques
// draw is held against it (metrics/). Full: direct light of sun and lamps past everything that casts shadows, and light
// of the sky, of ground, blades and objects that falls on each other, by paths (Kajiya 1986) that end by chance
// (Russian roulette) without bias. Direct: surfaces lit as the shaders light them, by the same numerics: light from
// above and below by the normal (on objects too, whose traced light is not in it), darker near a blade's root and by
// the ambient-occlusion map; only shadows are traced, where the scene has them at all (shadowMask, groundShadows). What
// is left against a technique is its geometry, not its light. Samples of a pixel are independent (a hash of seed, pixel
// and sample), over the pixel's square; haze is the shaders' own. Does not: depth of field, motion blur, spectra. Cost:
// football's `human`, 640 x 480, 16 samples: docs/accuracy.md.
#pragma once
#include <algorithm>
#include <memory>
#include <vector>

#include "core/enum_names.h"
#include "core/jobs.h"
#include "frame/renderer.h"
#include "scene/rows.h"
#include "world/view_camera.h"

namespace sward {

enum class ReferenceLighting { Full, Direct };
inline constexpr auto kReferenceLightings = enumNames<ReferenceLighting>("full", "direct");

inline constexpr int kShardRows = 8;  // of a band of rows, unless many machines need lower ones

struct ReferenceSettings {
    int width = 1024, height = 768;
    int samples = 16;   // a pixel, 1 to kMaxReferenceSamples
    uint32_t seed = 1;  // of the samples, never of the scene
    ReferenceLighting lighting = ReferenceLighting::Full;
    int shard = 0, shards = 1;  // of several machines this one's bands: the others' pixels stay 0
    int bandRows = kShardRows;  // of a band, 1 to kShardRows; no pixel depends on it
};
inline constexpr int kMaxReferenceSamples = 1 << 20;
inline constexpr int64_t kMaxReferencePixels = int64_t(1) << 26;
// Whether this machine traces a row of pixels (0 on top): bands go round among the shards.
inline bool isOfShard(int row, const ReferenceSettings& s) { return row / s.bandRows % s.shards == s.shard; }
// Rows of a band such that each of so many shards (at least 1) has four or more bands, where the image (height in
// pixels) has rows enough: with one or two bands each some machines would trace twice what others do, or nothing.
inline int bandRowsFor(int height, int shards) {
    return static_cast<int>(std::clamp<int64_t>(height / (int64_t(4) * shards), 1, kShardRows));
}

struct Truth {
    int width = 0, height = 0;
    std::vector<float> color;  // RGB, linear, before tone mapping, first row on top: as Renderer::readLinear
    std::vector<float> error;  // RGB, standard error of color; infinite with one sample
    std::vector<float> grass;  // share of the pixel's samples that meet a blade, or a tree of a forest, first
};

// A project prepared for rays, as it is at a scene time. Takes a copy (maps share their tiles); tracing is from any
// thread.
class ReferenceScene {
  public:
    // Unsound: an object's file that cannot be read. Failed: no memory; cancelled.
    static Result<ReferenceScene> make(const Project& p, const Tables& tables, double time, const JobControl& control);
    ReferenceScene(ReferenceScene&&) noexcept;
    ReferenceScene& operator=(ReferenceScene&&) noexcept;
    ~ReferenceScene();
    // Failed when cancelled. Usage error: sizes below 1 or beyond kMaxReferencePixels, samples or rows of a band out of
    // range, a shard that is not one of shards.
    Result<Truth> trace(const ViewCamera& camera, const ReferenceSettings& settings, JobControl& control) const;

    struct Impl;

  private:
    explicit ReferenceScene(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace sward
