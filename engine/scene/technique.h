// How a field of grass is drawn: one row a technique, all in one table (techniques.cpp). Command line, inspector,
// comparisons, plots, sweeps, fits, shadows, reflections and the renderer read that table: nothing else names a
// technique. Does not: draw; the effects do whose features a row asks for.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/components.h"

namespace sward {

struct Project;

// A field as its technique reads it: what grows, and the settings that stand beside it on its entity.
struct FieldEntity {
    const Registry& registry;
    Entity entity;
    const GrassField& grows;
    // The entity's component of a kind; its defaults where the entity has none.
    template <class C>
    const C& settings() const {
        static const C defaults{};
        const C* own = registry.get<C>(entity);
        return own ? *own : defaults;
    }
};

// Distances from the eye between which something fades: it is all there up to `min`, and gone from `max` on.
struct FadeRange {
    float min = 0, inv = -1, max = 0;  // metres; inv: lodInverse(min, max) of numerics/lod.h
};
FadeRange fadeRange(float min, float max);

// From where to where a field is drawn by what. All distances are metres from the eye.
struct FieldTiers {
    FadeRange blades;                     // blades one by one
    FadeRange images;                     // where images of blades take over from them: they fade in as blades fade out
    FadeRange flat;                       // where the horizontal slice takes over from the vertical ones
    float slicesFrom = -1, slicesTo = 0;  // cells of which vertical slices are drawn: beyond, and up to
    float flatFrom = -1;                  // ground over which the horizontal slice is drawn: beyond
    FadeRange soil;       // where what is drawn stops shading the soil piece by piece; the mean does beyond
    float shadowsTo = 0;  // how far the horizontal slice's shadow is drawn
};

// Values of a field's settings, or of the view (msaa, detail), each as NAME=VALUE.
using SettingValues = std::vector<std::string>;

// What `fit` turns: a number that starts at `start`, is multiplied by powers of two (or has whole steps added), and
// stays within [least, most].
struct KnobRow {
    const char* name;
    bool factor;   // it is multiplied; else it is added to
    double start;  // as the field is
    double least, most;
    bool inGrid;  // the grid that a fit is held against has three values of it; at most three knobs have some
};

// The setting of the scene's Antialias (scene/antialias.h) that sweeps try beside those.
inline constexpr const char* kTemporalSetting = "antialias=temporal";
// The knob of samples a pixel, as a factor of the view's own 4, and the value that it stands for: "msaa=1", 2 or 4.
inline constexpr KnobRow kSamplesKnob{"samples", true, 1, 0.25, 1, false};
std::string samplesTurned(double knob);

struct TechniqueRow {
    const char* name;   // in files, on the command line, in tables
    const char* label;  // as people read it
    const char* help;   // one line
    uint32_t color;     // in plots and panels: 0xRRGGBB; told apart by people who do not see red and green alike
    std::span<const char* const> settings;       // components that it reads, in the inspector's order
    FeatureSet (*features)(const FieldEntity&);  // how it is drawn, as features: what it asks of the scene
    // For a picture in which a metre, one metre away, is so many pixels wide.
    FieldTiers (*tiers)(const FieldEntity&, float pixelsPerMetre);
    // Its coarse version, such as water mirrors: what is left of a field's features, and where that draws. Null: as it
    // is.
    FeatureSet (*coarse)(FeatureSet) = nullptr;
    FieldTiers (*coarseTiers)(const FieldEntity&, float pixelsPerMetre) = nullptr;
    std::vector<SettingValues> (*sweep)(const FieldEntity&) =
        nullptr;                                  // settings that `cost` tries; null: the field's own alone
    std::span<const char* const> fewBlades = {};  // values by which it draws blades up to some metres, for `cost` to
                                                  // take the time a blade from; none: it does not draw a few
    std::span<const KnobRow> knobs = {};          // none: `fit` does not turn it
    SettingValues (*turned)(const FieldEntity&,
                            std::span<const double> knobs) = nullptr;  // values that knobs stand for
};

// The row named so, or null.
const TechniqueRow* findTechnique(std::span<const TechniqueRow> rows, std::string_view name);
// Names of all, "a, b, c".
std::string techniqueNames(std::span<const TechniqueRow> rows);
// 0xRRGGBB of a technique, of grass or of forests; nothing of names that neither table has.
std::optional<uint32_t> techniqueRgb(std::span<const TechniqueRow> rows, std::string_view name);
// The same as "#rrggbb"; a grey for names that the tables lack, such as those in files of other versions.
std::string techniqueColor(std::span<const TechniqueRow> rows, std::string_view name);

// The tiers of a field by its technique, for a picture in which a metre, one metre away, is so many pixels wide
// (`pixelsPerMetre` of frame/renderer.h); those of a technique that the table lacks are empty: nothing is drawn.
FieldTiers tiersOf(std::span<const TechniqueRow> rows, const FieldEntity& field, float pixelsPerMetre,
                   bool coarse = false);
// The project's fields in the order of their names, each with its entity's name.
std::vector<std::pair<std::string, FieldEntity>> fieldsOf(const Project& project);

}  // namespace sward
