// What a row is: the tables from which everything about components and effects is derived.
// A ComponentRow's field table feeds inspector, project file, undo, scripts, range checks and documentation.
// An EffectRow says what a technique or effect needs and what it runs. techniques.cpp lists all rows.
// Does not: hold any row itself.
#pragma once
#include <cstddef>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/jobs.h"
#include "ecs/registry.h"
#include "scene/features.h"
#include "scene/map_row.h"
#include "scene/slots.h"

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
    Name,    // std::string, one of options: the name of a row of a table
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
    const MapRow* map = nullptr;                // Map
    bool allowInf = false;                      // Float: infinity is a value ("never fades")
    bool isFile = false;                        // String: a file in the project's folder, or empty: an image ...
    bool isMesh = false;                        // ... or an object (glTF)
    const char* title = nullptr;                // what an inspector calls it; null: its name, in words
    const char* group = nullptr;                // heading under which it stands there; null: as the field before it
    bool isEntity = false;                      // String: the name of another entity, or empty; it follows renaming
    // Whether it does anything beside the other values of its struct; null: always. Inspectors leave it out where not.
    bool (*acts)(const void* owner) = nullptr;
};

struct Tables;
struct Project;

// What a component's `check` finds: allowed, but surely not meant.
struct ComponentFault {
    std::string field;       // from the component on, list elements by number: "shape", "species[1].height"
    std::string message;     // names the field's PATH, says what is wrong and what to do
    bool withoutIt = false;  // the program goes on as if the component were not there
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
    // What it asks for together with what else its entity has, in a full or in a coarse view (such as a mirror's);
    // null: nothing beside `features`.
    FeatureSet (*featuresOnEntity)(const Registry&, Entity, const Tables&, bool coarse) = nullptr;
    // Pulls fields into order that must be; says what it changed. Null: no rule holds between them.
    std::vector<std::string> (*repair)(void* component) = nullptr;
    // Adds what `sward check` is to say of an entity's component, whose PATH is given. Null: nothing.
    void (*check)(const Registry&, Entity, const std::string& path, std::vector<ComponentFault>&) = nullptr;
    // Adds what `sward check` is to say of the files that the component needs, once they can be read: what drawing and
    // tracing refuse, and what is surely not meant. Null: nothing.
    void (*checkFiles)(const Project&, Entity, const std::string& path, std::vector<Error>& refused,
                       std::vector<ComponentFault>&) = nullptr;
    // The component beside which it holds settings: where it is absent, its defaults hold, and where all its fields
    // have them, it is not saved. Null: it stands for itself.
    const char* settingsOf = nullptr;
    bool readByTruth = false;  // settings that change the ray-traced truth, too
};

// The value of an Enum field, as its number. Copied byte by byte, since the member has its own enum's type.
inline int enumIndex(const void* field) {
    int index;
    std::memcpy(&index, field, sizeof index);
    return index;
}
inline void setEnumIndex(void* field, int index) { std::memcpy(field, &index, sizeof index); }

// The component of a kind, as rows hold it.
template <class C>
const void* componentIn(const Registry& r, Entity e) {
    return r.get<C>(e);
}
// Whether it is the row of components C.
template <class C>
bool isRowOf(const ComponentRow& row) {
    return row.get == &componentIn<C>;
}

template <class C>
constexpr ComponentRow componentRow(const char* name, const char* help, std::span<const FieldRow> fields,
                                    FeatureSet (*features)(const void*)) {
    return {name,
            help,
            fields,
            features,
            &componentIn<C>,
            [](Registry& r, Entity e) -> void* { return r.get<C>(e); },
            [](Registry& r, Entity e, const void* v) { r.add<C>(e, v ? *static_cast<const C*>(v) : C{}); },
            [](Registry& r, Entity e) { r.remove<C>(e); },
            [](const void* v) -> std::shared_ptr<void> { return std::make_shared<C>(*static_cast<const C*>(v)); },
            []() -> const void* {
                static const C value{};
                return &value;
            }};
}

// A row of settings that stand beside a component named `owner`.
template <class C>
constexpr ComponentRow settingsRow(const char* name, const char* help, std::span<const FieldRow> fields,
                                   const char* owner) {
    ComponentRow row = componentRow<C>(name, help, fields, [](const void*) { return FeatureSet{}; });
    row.settingsOf = owner;
    return row;
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

// When something runs where slots leave it open: earlier stages first, and within a stage in the order of names.
// The order in which the scene is drawn is chosen, as layers are: nothing is lit that is not seen, so the ground's
// depth comes first, then grass from near to far, and last the ground and the sky, lit where they show. What is blended
// with what lies behind it comes after all of these (Pass::blendedWith).
enum class Stage {
    Once,    // systems that are the same for all views
    Within,  // views within the view
    View,    // systems of the view
    Simulate,
    Shadow,
    Depth,
    Opaque,
    Blades,
    Flowers,
    Slices,
    Far,
    Ground,
    GroundShadow,
    FarShadow,
    Sky,
    Water,
    Canopy,
    Post,
    Overlay,
    Decal
};
// Which views a pass takes part in: a set of bits.
enum ViewBits : unsigned { kViewMain = 1, kViewReflection = 2 };

struct DrawContext;  // frame/draw_context.h
struct ViewRequest;  // frame/draw_context.h
// What an effect keeps while its features are there: for the project (EffectRow::makeState), or for one of its views
// (makeView). Freed when they go.
struct EffectState {
    virtual ~EffectState() = default;
    // Adds what the effect is making beside the pictures (ViewSettings.background).
    virtual void jobs(std::vector<JobNews>&) const {}
};

// A program that a pass draws with. It is compiled for those of the scene's features that its sources name.
struct ProgramRow {
    const char* name;    // "domain/stem[/part]", as in statistics
    const char* vertex;  // path under shaders/, or null
    const char* fragment;
    const char* compute;
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
    SlotUse uses;
    std::span<const ProgramRow> programs;
    void (*draw)(DrawContext&);
    FeatureSet blendedWith = {};  // in a scene with one of these it needs what lies behind it
    bool stencil = false;         // the view's depth has one
    bool moves = false;           // what it draws tells how far it moved (lib/motion.glsl),
    bool follows = false;         // for who asks: the view has one sample, and a target for that
};

// CPU work once a frame, before drawing.
struct System {
    const char* name;
    SlotUse uses;
    void (*run)(DrawContext&);
    bool once = false;  // what it does is the same for every view of a frame
};

// Views within the main one, such as what each water mirrors: they are drawn, in their coarse version, before anything
// of the view that shows them.
struct ViewRow {
    ViewBits view;       // the passes that take part
    const char* prefix;  // of their names in statistics
    SlotUse uses;
    void (*request)(DrawContext&, std::vector<ViewRequest>&);  // adds what to draw in this frame
    void (*drawn)(DrawContext&);                               // after that, in the view that shows it
};

// How far what an effect draws follows something in the scene, in the user's words.
struct Follows {
    Feature what;
    const char* how;
};

struct EffectRow {
    const char* name;       // "domain/stem"
    FeatureSet needs = {};  // runs if the scene has all of these
    std::span<const System> systems = {};
    std::span<const Pass> passes = {};
    std::unique_ptr<EffectState> (*makeState)(DrawContext&) = nullptr;
    const char* help = "";  // why it runs, in the user's words
    std::unique_ptr<EffectState> (*makeView)(DrawContext&) = nullptr;
    const ViewRow* within = nullptr;
    // Before anything is drawn: whether it can be. `blades`: of the whole population (virtualBlades).
    Status (*check)(const Project&, double blades) = nullptr;
    std::span<const Follows> follows = {};
};

// The tables, as low layers see them; defined in techniques.cpp.
struct TechniqueRow;  // scene/technique.h
struct Tables {
    std::span<const ComponentRow> components;
    std::span<const EffectRow> effects;
    std::span<const TechniqueRow> techniques;
};

// How a path selects each element of a list: by its name (the first String field) where that is one and no other's,
// else by its number from 0.
std::vector<std::string> elementSelectors(const ListRow& row, const void* list);
// That of one element; and the element of a selector, if there is one. Both look at names alone.
std::string elementSelector(const ListRow& row, const void* list, size_t i);
std::optional<size_t> selectedElement(const ListRow& row, const void* list, const std::string& selector);

// The row named so, or null.
const ComponentRow* findComponent(std::span<const ComponentRow> rows, std::string_view name);

}  // namespace sward
