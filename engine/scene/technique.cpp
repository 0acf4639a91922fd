#include "scene/technique.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/numerics.h"
#include "scene/forest_technique.h"
#include "scene/project.h"

namespace sward {

FadeRange fadeRange(float min, float max) { return {min, f32::lodInverse(min, max), std::max(min, max)}; }

const TechniqueRow* findTechnique(std::span<const TechniqueRow> rows, std::string_view name) {
    for (const TechniqueRow& row : rows)
        if (name == row.name) return &row;
    return nullptr;
}

std::string samplesTurned(double knob) {
    return fmt::format("msaa={}", 1 << std::clamp(static_cast<int>(std::lround(std::log2(4 * knob))), 0, 2));
}

std::string techniqueNames(std::span<const TechniqueRow> rows) {
    std::string out;
    for (const TechniqueRow& row : rows) out += (out.empty() ? "" : ", ") + std::string(row.name);
    return out;
}

std::optional<uint32_t> techniqueRgb(std::span<const TechniqueRow> rows, std::string_view name) {
    if (const TechniqueRow* row = findTechnique(rows, name)) return row->color;
    if (const ForestTechniqueRow* row = findForestTechnique(name)) return row->color;
    return std::nullopt;
}

std::string techniqueColor(std::span<const TechniqueRow> rows, std::string_view name) {
    return fmt::format("#{:06x}", techniqueRgb(rows, name).value_or(0x808080u));
}

FieldTiers tiersOf(std::span<const TechniqueRow> rows, const FieldEntity& field, float pixelsPerMetre, bool coarse) {
    const TechniqueRow* row = findTechnique(rows, field.grows.technique);
    if (!row) return {};
    return coarse && row->coarseTiers ? row->coarseTiers(field, pixelsPerMetre) : row->tiers(field, pixelsPerMetre);
}

std::vector<std::pair<std::string, FieldEntity>> fieldsOf(const Project& project) {
    std::vector<std::pair<std::string, FieldEntity>> out;
    for (const auto& [name, e] : project.entities)
        if (const GrassField* f = project.registry.get<GrassField>(e)) out.push_back({name, {project.registry, e, *f}});
    return out;
}

}  // namespace sward
