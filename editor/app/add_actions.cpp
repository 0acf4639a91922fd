#include "app/add_actions.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/json.h"
#include "model/entity_edits.h"
#include "model/hollow.h"
#include "model/layer_edits.h"
#include "model/one_step.h"
#include "model/whole_map.h"
#include "tools/appear.h"
#include "tools/brush_target.h"
#include "world/ground.h"
#include "world/height_layers.h"
#include "world/water.h"

namespace sward {
namespace {

constexpr double kPondRadius = 6, kPondDepth = 1.4, kBelowRim = 0.12;  // metres; the water stands below the rim

// An entity of a free name with these components, as they appear where one looks.
Status addWith(Document& doc, const ViewCamera& view, const std::string& name,
               std::initializer_list<const char*> components) {
    if (Status s = doc.addEntity(name); !s) return s;
    for (const char* component : components)
        if (Status s = addInView(doc, view, name, component); !s) return s;
    return {};
}

void add(Document& doc, const ViewCamera& view, Selection& selection, Messages& messages, const char* like,
         std::initializer_list<const char*> components) {
    const std::string name = freeName(doc.project(), like);
    const auto edit = [&] { return addWith(doc, view, name, components); };
    if (!accept(messages, inOneStep(doc, "add " + name, edit))) return;
    choose(selection, name);
    say(messages, "new: " + name);
}

// A pond to dig: its water's entity, which may be there already, its level and its floor in the terrain's heights.
struct Pond {
    std::string name;
    double level = 0, floor = 0;
    bool fresh = true;
};

// Where a water stands over the place, no deeper below the ground there than a pond is, or reaches its rim, a hollow
// lets it in; anywhere else the pond has a water of its own, below its rim; where the rim lies in another water, as
// high as that, so that both are one. at, here: the middle and the ground's height there, relative to the terrain's
// corner.
Pond pondAt(const Project& p, const Ground& ground, const glm::dvec2& at, double here) {
    const std::vector<WaterPlace> waters = watersOf(p, ground);
    const RimLow rim = lowestAlongRim(*ground.terrain, waters, at, kPondRadius);
    const auto fills = [&](const WaterPlace& w) {
        const double level = w.water->level;
        return within(w, at.x, at.y) && (here - level < kPondDepth || (rim.wet && level == rim.height));
    };
    if (const auto own = std::find_if(waters.rbegin(), waters.rend(), fills); own != waters.rend()) {
        const double level = own->water->level;
        return {entityOf(p, *own->water), level, std::min(level, here) - kPondDepth, false};
    }
    const double level = rim.wet ? rim.height : rim.height - kBelowRim;
    return {freeName(p, "pond"), level, level - kPondDepth, true};
}

Status addWater(Document& doc, const Pond& pond, const glm::dvec3& at) {
    if (Status s = doc.addEntity(pond.name); !s) return s;
    for (const char* component : {"Transform", "Water"})
        if (Status s = doc.addComponent(pond.name, component); !s) return s;
    const std::string place = fmt::format("[{}, {}, {}]", shortestText(at.x), shortestText(at.y), shortestText(at.z));
    if (Status s = doc.setField(pond.name + ".Transform.position", place); !s) return s;
    if (Status s = doc.setField(pond.name + ".Water.radius", shortestText(static_cast<float>(kPondRadius))); !s)
        return s;
    return doc.setField(pond.name + ".Water.level", shortestText(static_cast<float>(pond.level)));
}

// What grows where its density is painted: nothing at first.
void addPainted(Document& doc, Selection& selection, BrushBook& brushes, Messages& messages, const char* like,
                const char* component) {
    const std::string name = freeName(doc.project(), like);
    const Status done = inOneStep(doc, "add " + name, [&]() -> Status {
        if (Status s = doc.addEntity(name); !s) return s;
        return addComponentUnpainted(doc, name, component);
    });
    if (!accept(messages, done)) return;
    choose(selection, name);
    paintNew(doc, brushes, name + "." + component);
    say(messages, "new: " + name + "; paint where it grows");
}

}  // namespace

void addLamp(Document& doc, const ViewCamera& view, Selection& selection, Messages& messages) {
    add(doc, view, selection, messages, "lamp", {"Transform", "Light"});
}

void addCamera(Document& doc, const ViewCamera& view, Selection& selection, Messages& messages) {
    add(doc, view, selection, messages, "camera", {"Camera"});
}

void addFlowers(Document& doc, Selection& selection, BrushBook& brushes, Messages& messages) {
    addPainted(doc, selection, brushes, messages, "flowers", "Flowers");
}
void addForest(Document& doc, Selection& selection, BrushBook& brushes, Messages& messages) {
    addPainted(doc, selection, brushes, messages, "forest", "Forest");
}

void addPond(Document& doc, Waiting& waiting, const ViewCamera& view, Selection& selection, Messages& messages) {
    const auto at = pickGround(doc.standing(), view, 2, 2, 1, 1);
    if (!at) return showError(messages, failed("there is no ground in the middle of the view", "look at the ground"));
    const Ground ground = doc.ground();
    const double base = ground.origin.y, here = at->y - base;
    const Pond pond = pondAt(doc.project(), ground, {at->x - ground.origin.x, at->z - ground.origin.z}, here);
    const Hollow hollow{{at->x, at->z}, kPondRadius, pond.floor, pond.level};
    const glm::dvec3 place = glm::round(glm::dvec3(at->x, base + pond.level, at->z) * 1e3) / 1e3;
    const auto dig = [hollow, pond, place](Document& d, JobControl&) {
        return inOneStep(d, (pond.fresh ? "add " : "dig into ") + pond.name, [&]() -> Status {
            if (Status s = digHollow(d, hollow); !s || !pond.fresh) return s;
            return addWater(d, pond, place);
        });
    };
    editBeside(waiting, doc, "Digging a pond", dig, [&doc, &selection, &messages, pond](const Status& done) {
        if (!accept(messages, done)) return;
        choose(selection, pond.name);
        const std::string below = sculptsBelow(doc, heightsPath(doc.project()));
        say(messages, (pond.fresh ? "new: " + pond.name : "a hollow below the level of " + pond.name) +
                          (below.empty() ? "" : ", dug " + below));
    });
}

void paintNew(const Document& doc, BrushBook& brushes, const std::string& owner) {
    for (const ConstFieldRef& map : allMaps(doc.project(), doc.tables().components))
        if (map.row->map->role == MapRole::Density && map.path.starts_with(owner) && !map.row->map->onMesh)
            return selectMap(doc, brushes, map.path);
}

}  // namespace sward
