// The effect map: for each feature that a scene asks for and that can be left out (feature_switch.h), where the
// picture of one view changes without it, and what it costs there. What costs without being seen is then known.
// A pixel counts as changed from kSeenChange of 255 in any channel. Costs: paired frames with and without it
// (paired_frames.h), by two renderers: one draws the scene as it is, the other what has an effect left out.
// Does not: judge the view, the moment or the size, of which alone it speaks; nor write files (effect_files.h).
// Cost: two frames a pair and effect, and what the programs that know the effect take to be compiled anew.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "cost/feature_switch.h"
#include "cost/paired_frames.h"
#include "gpu/gpu.h"
#include "world/view_camera.h"

namespace sward {

inline constexpr int kSeenChange = 2;    // of 255
inline constexpr int kEffectPairs = 7;   // whose least and greatest difference hold the median with 98%
inline constexpr int kMostPairs = 1000;  // of an effect

struct EffectRequest {
    ViewCamera camera;
    int width = 1024, height = 768, msaa = 4;
    double time = 0;  // scene seconds
    int pairs = kEffectPairs;
};
// One effect. What was not taken, because `error` says why, is 0.
struct EffectFound {
    Feature feature = Feature::Count;
    std::vector<SwitchStep> off;  // what to set to turn it off
    FeatureSet alsoOff;           // other features that the scene then does not ask for either
    uint64_t changed = 0;         // pixels
    double share = 0;             // of all pixels
    int greatest = 0;             // change of any channel of any pixel, of 255
    PairedDifference ms;          // the scene less the scene without it
    std::vector<uint8_t> where;   // each pixel's greatest change, of 255; first row on top
    std::string error;
    // It surely costs time and no pixel shows it.
    bool costsUnseen() const { return error.empty() && changed == 0 && ms.low > 0; }
};
struct EffectMap {
    int width = 0, height = 0;
    std::vector<uint8_t> picture;  // the scene as it is: RGB, first row on top
    uint64_t noise = 0;            // pixels that change by as much when the same scene is drawn by the other renderer
    std::vector<EffectFound> effects;  // those that cost unseen first; then those unseen, then the dearest first
};

// Features that the project asks for and that can be left out, in the order of their bits.
std::vector<Feature> effectsOf(const Project& project, const Tables& tables);
// What is being done and which share of it is done; false stops.
using EffectProgress = std::function<bool(const std::string& what, double share)>;
// Interrupted error once progress says no. Errors: as Renderer::draw of the scene as it is; what fails without an
// effect is told in that effect.
Result<EffectMap> probeEffects(const EffectRequest& request, const Project& project, const Tables& tables, Gpu& gpu,
                               const EffectProgress& progress);
// The greatest change of each pixel between two RGB pictures of one size.
std::vector<uint8_t> changesBetween(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b);
// The order of EffectMap::effects.
void sortEffects(std::vector<EffectFound>& effects);
// Where an effect changes the picture: the picture in grey and darker, and over it changed pixels from red, the least
// change that counts, to yellow, from 64 of 255 on. RGB, first row on top; empty if the effect was not drawn.
std::vector<uint8_t> changePicture(const EffectMap& map, const EffectFound& effect);

}  // namespace sward
