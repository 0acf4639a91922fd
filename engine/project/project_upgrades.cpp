// What brings project files of older forms up to today's, one step a form.
#include <cmath>

#include "project/project_json.h"
#include "scene/moved_fields.h"

namespace sward {
namespace {

// 1 to 2: how grass is drawn stands in components of its own beside the GrassField.
Status moveFields(Json& project) {
    const auto entities = project.object.find("entities");
    if (entities == project.object.end() || !entities->second.isObject()) return {};
    for (auto& [name, entity] : entities->second.object) {
        if (!entity.isObject()) continue;
        for (const MovedField& moved : movedFields()) {
            const auto from = entity.object.find(moved.component);
            if (from == entity.object.end() || !from->second.isObject()) continue;
            auto field = from->second.object.extract(moved.field);
            if (field.empty()) continue;
            Json& to = entity[moved.to];
            if (to.isNull()) to = Json::makeObject();
            if (!to.line) to.line = to.keyLine = from->second.line;
            if (to.isObject()) to.object.insert(std::move(field));
        }
    }
    return {};
}

}  // namespace

std::span<const Upgrade> projectUpgrades() {
    static constexpr Upgrade kSteps[] = {moveFields};
    return kSteps;
}

Status upgradeProject(Json& project, const std::string& file, std::span<const Upgrade> steps) {
    if (!project.isObject())
        return unsound(fmt::format("a project is an object, not {}", jsonTypeName(project.type)))
            .at(file, project.line, project.column);
    const int newest = 1 + static_cast<int>(steps.size());
    const Json* format = project.find("format");
    const auto refuseFormat = [&](std::string message, std::string remedy) {
        return unsound(std::move(message), std::move(remedy)).at(file, format->line, format->column);
    };
    const double n = format ? format->number : 1;
    if (format && (!format->isNumber() || n < 1 || n != std::floor(n)))
        return refuseFormat("format: must be a whole number from 1", fmt::format("this Sward reads up to {}", newest));
    if (n > newest)
        return refuseFormat(
            fmt::format("format {} is newer than this Sward, which reads up to {}", format->text, newest),
            "open it with the Sward that saved it, or a newer one");
    for (int i = static_cast<int>(n); i < newest; ++i)
        if (Status s = steps[size_t(i - 1)](project); !s) return s;
    project["format"] = Json(newest);
    return {};
}

}  // namespace sward
