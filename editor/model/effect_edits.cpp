#include "model/effect_edits.h"

#include "cost/feature_switch.h"
#include "model/one_step.h"
#include "world/drawn_project.h"

namespace sward {
namespace {

Status take(Document& doc, const SwitchStep& step) {
    if (step.field.empty()) return doc.removeComponent(step.entity, step.component->name);
    if (!step.component->get(doc.project().registry, findEntity(doc.project(), step.entity)))
        if (Status s = doc.addComponent(step.entity, step.component->name); !s) return s;
    return doc.setField(step.path(), step.value);
}

}  // namespace

Status turnOff(Document& doc, Feature feature) {
    if (!doc.isOpen()) return failed("no project is open", "open or create one first");
    DrawnProject drawn;
    const Project& shown = drawn.of(doc.project(), doc.tables().components);
    const std::vector<SwitchStep> steps = stepsWithout(doc.project(), shown, doc.tables(), feature);
    if (steps.empty()) return failed(fmt::format("nothing in the project asks for {}", featureName(feature)));
    return inOneStep(doc, fmt::format("turn off {}", featureName(feature)), [&]() -> Status {
        for (const SwitchStep& step : steps)
            if (Status s = take(doc, step); !s) return s;
        return {};
    });
}

}  // namespace sward
