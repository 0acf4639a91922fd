// The effect map of the view that is shown, measured by `sward effects` beside the editor: started, followed, and what
// is done with its lines. Does not: measure (cost/effect_probe.h), nor draw widgets (panels/effects.cpp).
#pragma once
#include <glm/glm.hpp>

#include "app/side_run.h"
#include "cost/effect_files.h"
#include "gpu/resources.h"
#include "world/drawn_project.h"

namespace sward {

struct EffectRun : SideRun {
    std::string program = "/proc/self/exe";  // that measures: this one
    std::vector<EffectLine> effects;         // of the last run that ended, the most wasteful first
    glm::ivec2 size{0};                      // pixels of the pictures that it measures by
    std::filesystem::path dir;               // of the project that was measured
    uint64_t revision = 0;                   // of the document when it began
    // What is looked at: an effect, and its picture on the GPU, which followEffects brings there.
    Feature shown = Feature::Count;
    bool showDue = false;
    Texture picture;
    // What the project asks for now.
    FeatureSet present;
    uint64_t presentRevision = ~uint64_t(0);
    DrawnProject drawn;
};
inline constexpr int kSlowEffectWidth = 320;  // pixels that a software renderer's pictures are at most wide

// The size at which a viewport of this size is measured: its own; by a software renderer halved until it is no wider
// than kSlowEffectWidth. At least 1 x 1.
glm::ivec2 effectSize(int width, int height, bool software);
// Starts on a copy of the project as it is now, from the view that is shown, at this size and scene time. Shows why if
// it cannot: no project, or it runs already. What was measured before is dropped.
void startEffects(EffectRun& run, const MeasureParts& parts, const glm::ivec2& size, double seconds);
// Once a frame, before its widgets: takes in what has ended, and says so; what another project left is dropped.
void followEffects(EffectRun& run, const Document& document, Gpu& gpu, FrameClock& clock, Messages& messages);
// Looks at another effect, from the next frame on.
void showEffect(EffectRun& run, Feature feature);
// As model/effect_edits.h, with a message.
void turnOffNow(Document& document, Messages& messages, Feature feature);

}  // namespace sward
