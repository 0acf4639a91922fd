// Slots: what the systems and passes of a frame make for each other, and who comes first for that.
// Does not: hold what is handed over; DrawContext and its targets do (frame/draw_context.h).
#pragma once
#include <cstdint>
#include <initializer_list>
#include <string>

namespace sward {

// What systems and passes of one frame hand to each other: pictures, and what DrawContext::shared holds. Who reads a
// slot runs after all that fill it, whatever the table's order.
enum class Slot : uint8_t {
    SampleShift,  // where in their pixels a frame takes its samples
    Sun,          // the first directional light
    SkyLight,     // light of the sky, and what is left of the sun's
    Haze,         // how far one sees
    Air,          // tables of the sky and of the air before things
    Lamps,        // other lights
    Ground,       // heights of the terrain, and what shaders know of it
    GroundNodes,  // the terrain's nodes in view
    Masks,        // how blades shade blades
    Traced,       // light from blade to blade
    Grown,        // what the fields are made of: patches, maps, textures
    Meshes,       // blades of species, for all views
    Grass,        // the fields as a view draws them
    Slices,       // images of blades
    FarGround,    // where a view draws them, and how bright
    Blades,       // those that are drawn one by one
    BladeCells,   // commands that the GPU makes of cells that it chooses
    ForceList,    // what presses on the grass
    Forces,       // the map in which that adds up
    Forests,      // which trees stand
    ObjectLight,  // what comes to objects from all around
    Casters,      // triangles that shade
    Shadows,      // where sun and lamps do not reach
    Reflection,   // what water mirrors
    SceneColor,
    SceneDepth,
    Resolved,  // the scene's colour of one sample
    Image,     // what is shown on a screen
    Count
};
const char* slotName(Slot slot);  // stops the program for Slot::Count

// A set of slots: {Slot::Sun, Slot::Ground}.
struct SlotSet {
    uint32_t bits = 0;
    constexpr SlotSet() = default;
    constexpr SlotSet(std::initializer_list<Slot> slots) {
        for (const Slot s : slots) bits |= 1u << static_cast<unsigned>(s);
    }
    constexpr bool has(Slot s) const { return bits >> static_cast<unsigned>(s) & 1; }
    constexpr bool any() const { return bits != 0; }
    constexpr SlotSet operator|(SlotSet o) const { return of(bits | o.bits); }
    constexpr SlotSet operator&(SlotSet o) const { return of(bits & o.bits); }
    constexpr SlotSet without(SlotSet o) const { return of(bits & ~o.bits); }
    static constexpr SlotSet of(uint32_t bits) {
        SlotSet s;
        s.bits = bits;
        return s;
    }
};
static_assert(static_cast<unsigned>(Slot::Count) <= 32);

// What a system or pass does to slots. Of one slot: first whoever writes it, then all that append to it, then whoever
// reads and writes it (changes what is there), and last all that only read it.
struct SlotUse {
    SlotSet reads = {}, writes = {}, appends = {};
};
// The slots for which `a` must run before `b`.
SlotSet handedOver(const SlotUse& a, const SlotUse& b);
// "Sun, Ground", in the order of Slot; empty for none.
std::string slotNames(SlotSet slots);

}  // namespace sward
