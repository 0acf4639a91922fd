// The four distances of a hybrid field as rings on the ground, in the viewport: drawn, and dragged with the mouse.
// Does not: hold the maths (tools/rings.h, tools/tiers.h).
#pragma once
#include <imgui.h>

#include <optional>
#include <span>
#include <string>

#include "app/edits.h"
#include "app/layout.h"
#include "app/messages.h"
#include "model/document.h"
#include "tools/camera_control.h"
#include "tools/tier_view.h"
#include "ui/input_queue.h"

namespace sward {

inline constexpr ImU32 kTierColors[kTierCount] = {IM_COL32(255, 92, 80, 255), IM_COL32(255, 176, 60, 255),
                                                  IM_COL32(90, 170, 255, 255), IM_COL32(90, 225, 120, 255)};
inline constexpr const char* kTierTitles[kTierCount] = {"All blades up to", "Blades end at", "All slices up to",
                                                        "Slices end at"};

// The entity whose distances panel and rings show: the one chosen in the panel, the selected, or the first; "" if none
// has a GrassField.
std::string tierEntity(const Document& document, const std::string& chosen, const std::string& selected);
// The field; nothing for "".
std::optional<FieldEntity> tierField(const Document& document, const std::string& entity);
// Its distances in a picture in which a metre, one metre away, is so many pixels wide.
TierDistances tiersShown(const FieldEntity& field, float pixelsPerMetre);
// Gives it these distances there. What is refused is told.
void setTiers(Document& document, Messages& messages, const std::string& entity, float pixelsPerMetre,
              const TierDistances& wanted);
// Sets those of its fields that are other than so. What is refused is told.
void editTiers(Document& document, Messages& messages, const std::string& entity, std::span<const TierEdit> edits);
// "lawn.HybridTiers.maxGeom"; `i` below kTierCount.
std::string tierPath(const std::string& entity, size_t i);

// What the rings lie on and are seen through; all must outlive the call.
struct RingParts {
    Document& doc;
    TierView& tiers;
    const FlyCamera& camera;
    const Rect& view;      // of the image, window coordinates
    float pixelsPerMetre;  // of the picture, one metre away
    std::string entity;    // by tierEntity
    bool shown;            // there is a field, its panel is in sight, and the person wants them
};

// --- once a frame, around the drawing of the image
// What the pointer is on, of the rings as last drawn; nothing unless `free`: over the image, with no gesture and no
// modifier.
void hoverRing(const RingParts& parts, const FrameInput& in, bool free);
// Lays them anew, and draws them while the panel is in sight.
void drawRings(const RingParts& parts);

// --- in the hand: one undo step from grab to release
// True if the pointer is on one and no modifier says otherwise.
bool grabRing(const RingParts& parts, const FrameInput& in, Edits& edits);
// To a place in the window; nothing while none is in the hand. The first two pixels change nothing.
void dragRing(const RingParts& parts, Messages& messages, double x, double y);
// Lets go; the undo step ends with the frame.
void releaseRing(TierView& tiers);
// The distance is what it was.
void cancelRing(TierView& tiers, Document& document, Edits& edits, Messages& messages);

}  // namespace sward
