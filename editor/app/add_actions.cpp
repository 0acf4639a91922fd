#include "app/add_actions.h"

#include <fmt/format.h>

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

// The entity whose water the scene has, and its level; "": none.
std::pair<std::string, double> waterOf(const Project& p) {
    const Water* water = firstOf<Water>(p);
    return water ? std::pair(entityOf(p, *water), static_cast<double>(water->level)) : std::pair(std::string(), 0.0);
}

Status addWater(Document& doc, const std::string& name, double level) {
    if (Status s = doc.addEntity(name); !s) return s;
    if (Status s = doc.addComponent(name, "Water"); !s) return s;
    return doc.setField(name + ".Water.level", shortestText(static_cast<float>(level)));
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
    const double base = doc.ground().origin.y, here = at->y - base;
    const auto [own, level] = waterOf(doc.project());
    const double surface = own.empty() ? here - kBelowRim : level;
    const std::string name = own.empty() ? freeName(doc.project(), "pond") : own;
    Hollow hollow{{at->x, at->z}, kPondRadius, std::max(kPondDepth, here - surface + kPondDepth), surface};
    const bool fresh = own.empty();
    const auto dig = [hollow, name, fresh, surface](Document& d, JobControl&) {
        return inOneStep(d, fresh ? "add " + name : "dig into " + name, [&]() -> Status {
            if (Status s = digHollow(d, hollow); !s || !fresh) return s;
            return addWater(d, name, surface);
        });
    };
    editBeside(waiting, doc, "Digging a pond", dig, [&doc, &selection, &messages, name, fresh](const Status& done) {
        if (!accept(messages, done)) return;
        choose(selection, name);
        const std::string below = sculptsBelow(doc, heightsPath(doc.project()));
        say(messages,
            (fresh ? "new: " + name : "a hollow below the level of " + name) + (below.empty() ? "" : ", dug " + below));
    });
}

void paintNew(const Document& doc, BrushBook& brushes, const std::string& owner) {
    for (const ConstFieldRef& map : allMaps(doc.project(), doc.tables().components))
        if (map.row->map->role == MapRole::Density && map.path.starts_with(owner) && !map.row->map->onMesh)
            return selectMap(doc, brushes, map.path);
}

}  // namespace sward
