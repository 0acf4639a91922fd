#include "model/antialias_edit.h"

#include "model/entity_edits.h"
#include "model/one_step.h"

namespace sward {
namespace {

std::vector<std::string> entitiesThatSay(const Project& p) {
    std::vector<std::string> names;
    for (const auto& [name, e] : p.entities)
        if (p.registry.get<Antialias>(e)) names.push_back(name);
    return names;
}

Status addOne(Document& doc, std::vector<std::string>& names) {
    names.push_back(freeName(doc.project(), "antialias"));
    if (Status s = doc.addEntity(names.back()); !s) return s;
    return doc.addComponent(names.back(), antialiasRow().name);
}

}  // namespace

Status chooseAntialias(Document& doc, Antialiasing kind) {
    std::vector<std::string> names = entitiesThatSay(doc.project());
    return inOneStep(doc, std::string("antialias: ") + kAntialiasings[static_cast<size_t>(kind)], [&]() -> Status {
        if (names.empty() && kind == Antialiasing::Msaa) return {};
        if (names.empty())
            if (Status s = addOne(doc, names); !s) return s;
        for (const std::string& name : names)
            if (Status s = doc.setField(name + "." + antialiasRow().name + "." + kAntialiasSetting,
                                        kAntialiasings[static_cast<size_t>(kind)]);
                !s)
                return s;
        return {};
    });
}

}  // namespace sward
