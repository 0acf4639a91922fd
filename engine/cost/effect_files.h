// An effect map on disk: effects.json, and a picture an effect that shows where it changes pixels; and what a reader
// of the JSON needs of it again. Names carry their units: *_share of 1, *_255 of a channel, *_ms.
// Does not: measure (effect_probe.h).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/json.h"
#include "cost/effect_probe.h"

namespace sward {

// What is told of a camera's map. `folder`: of the pictures, relative to the JSON; empty: there are none.
Json effectMapJson(const EffectMap& map, const std::string& camera, const std::string& folder);
// One PNG an effect, named after it, and the scene as it is as "scene.png". Fails if they cannot be written.
Status writeEffectPictures(const EffectMap& map, const std::filesystem::path& folder);
// As a table for people, a line an effect.
std::string effectMapText(const EffectMap& map, const std::string& camera);
// "0 pixels", "12.3 %", "< 0.1 %"
std::string shareText(uint64_t changed, double share);

// What effectMapJson told of an effect.
struct EffectLine {
    Feature feature = Feature::Count;
    uint64_t changed = 0;
    double share = 0;
    int greatest = 0;
    PairedDifference ms;
    bool costsUnseen = false;
    std::vector<std::string> off;  // SwitchStep::told
    std::string picture;           // relative to the JSON; empty: none
    std::string error;
};
// The effects of a camera, in their order; features that this program does not know are left out. Unsound: no effect
// map, or none of this camera.
Result<std::vector<EffectLine>> effectsFrom(const Json& json, const std::string& camera);

}  // namespace sward
