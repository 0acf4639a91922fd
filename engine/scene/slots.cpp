#include "scene/slots.h"

#include "core/error.h"

namespace sward {
namespace {
// In the order of Slot.
constexpr const char* kNames[] = {"SampleShift", "Sun",         "SkyLight",    "Haze",    "Air",        "Lamps",
                                  "Ground",      "GroundNodes", "Masks",       "Traced",  "Grown",      "Meshes",
                                  "Grass",       "Slices",      "FarGround",   "Blades",  "BladeCells", "ForceList",
                                  "Forces",      "Forests",     "ObjectLight", "Casters", "Shadows",    "Reflection",
                                  "SceneColor",  "SceneDepth",  "Resolved",    "Image"};
static_assert(std::size(kNames) == static_cast<size_t>(Slot::Count));
}  // namespace

const char* slotName(Slot slot) {
    CHECK(slot < Slot::Count);
    return kNames[static_cast<size_t>(slot)];
}

SlotSet handedOver(const SlotUse& a, const SlotUse& b) {
    const auto makes = [](const SlotUse& u) { return u.writes.without(u.reads); };
    const auto changes = [](const SlotUse& u) { return u.writes & u.reads; };
    const auto looks = [](const SlotUse& u) { return u.reads.without(u.writes); };
    return (makes(a) & (b.appends | b.reads)) | (a.appends & b.reads) | (changes(a) & looks(b));
}

std::string slotNames(SlotSet slots) {
    std::string out;
    for (size_t i = 0; i < static_cast<size_t>(Slot::Count); ++i)
        if (slots.has(static_cast<Slot>(i))) out += (out.empty() ? "" : ", ") + std::string(kNames[i]);
    return out;
}

}  // namespace sward
