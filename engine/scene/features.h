// Features: the bits that a scene's components ask for, and all that runs (see frame/plan.h).
// sceneFeatures is the one pure function from components to bits. A shader sees feature F as `const bool NAME`.
// features.inc is the table: a line there is all that a feature takes here.
// Does not: decide what a feature makes run; effect rows do.
#pragma once
#include <bitset>
#include <cstdint>
#include <span>

namespace sward {

enum class Feature : uint8_t {
#define FEATURE(bit, ...) bit,
#include "scene/features.inc"
#undef FEATURE
    Count
};
using FeatureSet = std::bitset<static_cast<size_t>(Feature::Count)>;

// Who asks for a feature. What one grass field asks for holds for that field alone; the rest is of the whole scene.
enum class FeatureScope : uint8_t { OfScene, OfField };

struct FeatureRow {
    Feature feature;
    const char* name;  // "terrain-heights", for explain and statistics
    FeatureScope scope;
    const char* help;    // what is there with it
    const char* absent;  // what a scene without it lacks, in the user's words
};
// Every feature once, by its bit.
std::span<const FeatureRow> featureRows();
// Stops the program for Feature::Count.
const FeatureRow& featureRow(Feature f);

inline const char* featureName(Feature f) { return featureRow(f).name; }
// The name as shaders write it: "TERRAIN_HEIGHTS".
const char* featureConstant(Feature f);
// All features that single fields ask for.
FeatureSet fieldFeatures();

// The set of the features named.
template <class... F>
FeatureSet featureSet(F... f) {
    FeatureSet s;
    (s.set(static_cast<size_t>(f)), ...);
    return s;
}
// Whether `s` has feature `f`.
inline bool has(const FeatureSet& s, Feature f) { return s.test(static_cast<size_t>(f)); }

}  // namespace sward
