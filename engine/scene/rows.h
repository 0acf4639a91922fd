// What a row is: the tables from which everything about components and effects is derived.
// A ComponentRow's field table feeds inspector, project file, undo, scripts, range checks and documentation.
// An EffectRow says what a technique or effect needs and what it runs. techniques.cpp lists all rows.
// Does not: hold any row itself.
#pragma once
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/jobs.h"
#include "ecs/registry.h"
#include "maps/map.h"
#include "scene/features.h"

namespace sward {

// How a field is stored in its struct.
enum class FieldType {
    Bool,    // bool
    Int,     // int
    Float,   // float; with allowInf also "inf" in files
    Vec2,    // glm::dvec2
    Vec3,    // glm::dvec3, metres
    Color,   // glm::vec3, linear
    String,  // std::string
    Enum,    // an enum of ints, whose values count from 0 and are named by options (enumIndex, setEnumIndex)
    Map,     // MapField
    List,    // std::vector of structs, described by list
};

struct FieldRow;

// Type-erased access to a std::vector of structs whose first field is a String that names the element.
struct ListRow {
    std::span<const FieldRow> fields;
    size_t (*size)(const void* list);
    const void* (*at)(const void* list, size_t i);
    void* (*editAt)(void* list, size_t i);
    void (*resize)(void* list, size_t n);
    const void* (*defaults)();
};

struct FieldRow {
    const char* name;  // as in files and paths
    FieldType type;
    size_t offset;                              // in the struct
    const char* unit;                           // "m", "deg", "blades/m2"; "" if none
    double hardMin, hardMax;                    // outside: refused on load, clamped on edit
    double softMin, softMax;                    // the slider's range
    const char* help;                           // one line
    std::span<const char* const> options = {};  // Enum
    const ListRow* list = nullptr;              // List
    int mapChannels = 1;                        // Map: channels wanted
    PixelType mapType = PixelType::U16;         // Map: type of a new one
    bool allowInf = false;                      // Float: infinity is a value ("never fades")
    bool isHeight = false;                      // Map: heights, never 8-bit
    bool isForce = false;                       // Map: what presses on blades; four channels that are no colour
    bool isFile = false;                        // String: a file in the project's folder, or empty: an image ...
    bool isMesh = false;                        // ... or an object (glTF)
};

struct ComponentRow {
    const char* name;
    const char* help;
    std::span<const FieldRow> fields;
    FeatureSet (*features)(const void* component);         // what having it asks for
    const void* (*get)(const Registry&, Entity);           // null if absent
    void* (*edit)(Registry&, Entity);                      // the same, to be changed
    void (*assign)(Registry&, Entity, const void* value);  // adds or replaces; null value: its defaults
    void (*remove)(Registry&, Entity);
    std::shared_ptr<void> (*clone)(const void* value);  // maps share their tiles
    const void* (*defaults)();
};

// The value of an Enum field, as its number. Copied byte by byte, since the member has its own enum's type.
inline int enumIndex(const void* field) {
    int index;
    std::memcpy(&index, field, sizeof index);
    return index;
}
inline void setEnumIndex(void* field, int index) { std::memcpy(field, &index, sizeof index); }

template <class C>
constexpr ComponentRow componentRow(const char* name, const char* help, std::span<const FieldRow> fields,
                                    FeatureSet (*features)(const void*)) {
    return {name,
            help,
            fields,
            features,
            [](const Registry& r, Entity e) -> const void* { return r.get<C>(e); },
            [](Registry& r, Entity e) -> void* { return r.get<C>(e); },
            [](Registry& r, Entity e, const void* v) { r.add<C>(e, v ? *static_cast<const C*>(v) : C{}); },
            [](Registry& r, Entity e) { r.remove<C>(e); },
            [](const void* v) -> std::shared_ptr<void> { return std::make_shared<C>(*static_cast<const C*>(v)); },
            []() -> const void* {
                static const C value{};
                return &value;
            }};
}

template <class E>
constexpr ListRow listRow(std::span<const FieldRow> fields) {
    using V = std::vector<E>;
    return {fields,
            [](const void* l) { return static_cast<const V*>(l)->size(); },
            [](const void* l, size_t i) -> const void* { return &(*static_cast<const V*>(l))[i]; },
            [](void* l, size_t i) -> void* { return &(*static_cast<V*>(l))[i]; },
            [](void* l, size_t n) { static_cast<V*>(l)->resize(n); },
            []() -> const void* {
                static const E value{};
                return &value;
            }};
}

// --- effects -------------------------------------------------------------------------------------------------

// In drawing order, where no grass is blended (frame/plan.h).
enum class Stage {
    Simulate,
    Bake,
    Shadow,
    Reflect,
    Depth,
    Opaque,
    Blades,
    Slices,
    Rays,
    Ground,
    GroundShadow,
    Sky,
    Water,
    Post,
    Overlay,
    Count
};
// Which views a pass takes part in: a set of bits.
enum ViewBits : unsigned { kViewMain = 1, kViewReflection = 2, kViewShadow = 4, kViewCapture = 8, kViewCompare = 16 };
// What a pass reads and writes; within a stage the planner runs writers before readers.
enum ResourceBits : unsigned {
    kSceneColor = 1,
    kSceneDepth = 2,
    kHeights = 4,
    kGroundCover = 8,
    kSkyLight = 16,
    kImage = 32,
    kResolved = 64,
    kForces = 128
};

struct DrawContext;  // frame/draw_context.h
// What an effect keeps while its features are there. One per project; freed when they go.
struct EffectState {
    virtual ~EffectState() = default;
    // Adds what the effect is making beside the pictures (ViewSettings.background).
    virtual void jobs(std::vector<JobNews>&) const {}
};

// A program that a pass draws with. `features`: those that its sources declare, and so its key.
struct ProgramRow {
    const char* name;    // "domain/stem[/part]", as in statistics
    const char* vertex;  // path under shaders/, or null
    const char* fragment;
    const char* compute;
    FeatureSet features;
    // Sources' other constants (DrawContext::use): one text for each way to compile them that differs; null: there are
    // none.
    std::vector<std::string> (*variants)() = nullptr;
    const char* control = nullptr;  // tessellation stages; null where they are absent
    const char* evaluation = nullptr;
};

struct Pass {
    const char* name;  // "domain/stem[/part]": also its KHR_debug group and its line in the profiler
    Stage stage;
    unsigned views;
    unsigned reads, writes;
    std::span<const ProgramRow> programs;
    void (*draw)(DrawContext&);
};

// CPU work once a frame, before drawing.
struct System {
    const char* name;
    void (*run)(DrawContext&);
};

struct EffectRow {
    const char* name;  // "domain/stem"
    FeatureSet needs;  // runs if the scene has all of these
    std::span<const System> systems;
    std::span<const Pass> passes;
    std::unique_ptr<EffectState> (*makeState)(DrawContext&);
    const char* help;  // why it runs, in the user's words
};

// The tables, as low layers see them; defined in techniques.cpp.
struct Tables {
    std::span<const ComponentRow> components;
    std::span<const EffectRow> effects;
};

// How a path selects each element of a list: by its name (the first String field) where that is one and no other's,
// else by its number from 0.
std::vector<std::string> elementSelectors(const ListRow& row, const void* list);

// The row named so, or null.
const ComponentRow* findComponent(std::span<const ComponentRow> rows, std::string_view name);

}  // namespace sward
