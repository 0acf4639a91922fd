#include "frame/explain.h"

#include <set>

#include "core/json.h"
#include "frame/draw_context.h"
#include "scene/technique.h"
#include "world/forest_ground.h"

namespace sward {
namespace {

// What one feature makes run, in running order: effects that need it, and programs that compile its branch in.
struct Made {
    std::vector<std::string> because, systems, passes, programs;
    int64_t bytes = 0;
};

// Owners in the ledger, each with what is kept below its name: effects by name, and maps by the feature that asks for
// them ("grass-density" holds "grass/density").
int64_t bytesOf(const Gpu& gpu, const std::string& owner) {
    const std::string below = owner + "/";
    int64_t bytes = 0;
    for (const auto& [name, held] : gpu.ledger)
        if (name == owner || name.starts_with(below)) bytes += held;
    return bytes;
}
std::string ownerOf(Feature f) {
    std::string name = featureName(f);
    std::replace(name.begin(), name.end(), '-', '/');
    return name;
}

Made madeBy(Feature f, const FramePlan& plan, const Project& project, const Tables& tables, const Gpu& gpu,
            Programs& sources) {
    Made m;
    m.because = entitiesWith(project.registry, tables, f);
    m.bytes = bytesOf(gpu, ownerOf(f));
    for (const EffectRow* e : plan.effects)
        if (has(e->needs, f)) m.bytes += bytesOf(gpu, e->name);
    std::set<std::string> programs;
    for (const Step& s : plan.steps) {
        bool touched = has(s.effect->needs, f);
        if (s.system && touched) m.systems.push_back(s.name());
        if (s.system) continue;
        for (const ProgramRow& program : s.pass ? s.pass->programs : std::span<const ProgramRow>{})
            if (touched || sources.named(sourcesOf(program), featureConstant(f))) {
                programs.insert(program.name);
                touched = true;
            }
        if (touched) m.passes.push_back(s.name());
    }
    m.programs.assign(programs.begin(), programs.end());
    return m;
}

// How far what runs follows a feature; empty: nothing to say.
std::string noteOn(Feature f, const FramePlan& plan) {
    std::vector<std::string_view> said;
    for (const Step& s : plan.steps) {
        if (!s.pass) continue;  // passes run from near to far
        for (const Follows& row : s.effect->follows)
            if (row.what == f && std::find(said.begin(), said.end(), row.how) == said.end()) said.push_back(row.how);
    }
    return fmt::format("{}", fmt::join(said, ", "));
}

Json names(const std::vector<std::string>& list) {
    Json j = Json::makeArray();
    for (const std::string& n : list) j.push(n);
    return j;
}

std::string joined(const std::vector<std::string>& list) {
    std::string out;
    for (const std::string& n : list) out += (out.empty() ? "" : ", ") + n;
    return out.empty() ? "nothing of its own" : out;
}

// How each field of grass is drawn.
struct DrawnField {
    std::string name;
    const TechniqueRow* technique;
};
std::vector<DrawnField> drawnFields(const Project& project, const Tables& tables) {
    std::vector<DrawnField> out;
    for (const auto& [name, field] : fieldsOf(project))
        if (const TechniqueRow* row = findTechnique(tables.techniques, field.grows.technique);
            row && field.grows.onTerrain)
            out.push_back({name, row});
    return out;
}

// A layer over a map, and what becomes of it.
struct ShownLayer {
    std::string path, map;
    const MapLayer* layer;
    std::string note;
};
std::vector<ShownLayer> shownLayers(const Project& project, const std::vector<LayerNote>& notes) {
    std::vector<ShownLayer> out;
    for (const auto& [name, e] : project.entities) {
        const MapLayers* of = project.registry.get<MapLayers>(e);
        const std::vector<std::string> paths = of ? layerPaths(name, *of) : std::vector<std::string>();
        for (size_t i = 0; i < paths.size(); ++i) {
            const MapLayer& layer = of->layers[i];
            ShownLayer shown{paths[i], layeredPath(name, layer), &layer, layer.muted ? "muted" : ""};
            for (const LayerNote& n : notes)
                if (n.layer == paths[i]) shown.note = (n.skipped ? "skipped: " : "") + n.message;
            out.push_back(std::move(shown));
        }
    }
    return out;
}

// The array is there only where a scene has layers.
void addLayers(Json& all, const std::vector<ShownLayer>& layers) {
    for (const ShownLayer& l : layers) {
        Json j;
        j["path"] = l.path;
        j["map"] = l.map;
        j["kind"] = kLayerKinds[l.layer->kind];
        j["operation"] = kLayerOperations[l.layer->operation];
        if (!l.note.empty()) j["note"] = l.note;
        all["layers"].push(std::move(j));
    }
}

// The array is there only where a scene has forests.
void addForests(Json& all, const std::vector<ForestCount>& forests) {
    for (const ForestCount& f : forests) {
        Json j;
        j["name"] = f.entity;
        j["technique"] = f.technique;
        j["trees"] = f.trees;
        j["tiles"] = f.tiles;
        j["cliffs"] = f.cliffs;
        all["forests"].push(std::move(j));
    }
}
std::string forestsText(const std::vector<ForestCount>& forests) {
    std::string out;
    for (const ForestCount& f : forests)
        out += fmt::format(
            "{}  {} is drawn by {}: {} trees in {} tiles{}\n", out.empty() ? "\nForests\n" : "", f.entity, f.technique,
            f.trees, f.tiles,
            f.cliffs > 0 ? fmt::format(", {} of them on cliffs, where far trees are not drawn", f.cliffs) : "");
    return out;
}

std::string asJson(const std::map<Feature, Made>& made, const FramePlan& plan, const std::vector<DrawnField>& fields,
                   const std::vector<ForestCount>& forests, const std::vector<ShownLayer>& layers) {
    Json all;
    all["fields"] = Json::makeArray();
    for (const DrawnField& field : fields) {
        Json j;
        j["name"] = field.name;
        j["technique"] = field.technique->name;
        all["fields"].push(std::move(j));
    }
    addForests(all, forests);
    all["features"] = Json::makeArray();
    all["absent"] = Json::makeArray();
    for (size_t i = 0; i < plan.features.size(); ++i) {
        const Feature f = static_cast<Feature>(i);
        Json j;
        j["name"] = featureName(f);
        if (const auto it = made.find(f); it != made.end()) {
            j["because"] = names(it->second.because);
            j["systems"] = names(it->second.systems);
            j["passes"] = names(it->second.passes);
            j["programs"] = names(it->second.programs);
            j["gpu_bytes"] = it->second.bytes;
            if (const std::string note = noteOn(f, plan); !note.empty()) j["note"] = note;
            all["features"].push(std::move(j));
        } else {
            j["because"] = featureRow(f).absent;
            all["absent"].push(std::move(j));
        }
    }
    addLayers(all, layers);
    return writeJson(all);
}

std::string asText(const std::map<Feature, Made>& made, const FramePlan& plan, const std::vector<DrawnField>& fields,
                   const std::vector<ForestCount>& forests, const std::vector<ShownLayer>& layers) {
    std::string out = "What this scene makes run, and why\n";
    for (const DrawnField& field : fields)
        out += fmt::format("{}  {} is drawn by {}: {}\n", &field == &fields.front() ? "\nGrass\n" : "", field.name,
                           field.technique->name, field.technique->help);
    out += forestsText(forests);
    for (const ShownLayer& l : layers)
        out += fmt::format("{}  {} ({}, {}) over {}{}\n", &l == &layers.front() ? "\nLayers\n" : "", l.path,
                           kLayerKinds[l.layer->kind], kLayerOperations[l.layer->operation], l.map,
                           l.note.empty() ? "" : ": " + l.note);
    for (const auto& [f, m] : made) {
        out += fmt::format("\n{}  (because of {})\n", featureName(f), joined(m.because));
        out += fmt::format("  systems   {}\n  passes    {}\n  programs  {}\n", joined(m.systems), joined(m.passes),
                           joined(m.programs));
        out += fmt::format("  memory    {:.2f} MB on the GPU\n", static_cast<double>(m.bytes) / 1e6);
        if (const std::string note = noteOn(f, plan); !note.empty()) out += fmt::format("  note      {}\n", note);
    }
    for (const EffectRow* e : plan.effects)
        out += fmt::format("{}{}: {}\n", e == plan.effects.front() ? "\nEffects\n  " : "  ", e->name, e->help);
    out += "\nWhat it lacks: not run, not compiled, not in memory\n";
    for (const FeatureRow& row : featureRows())
        if (!has(plan.features, row.feature)) out += fmt::format("  {}: {}\n", row.name, row.absent);
    return out;
}

}  // namespace

std::string explainPlan(const Explained& what, const Tables& tables, const Gpu& gpu, Programs& programs, bool json) {
    const auto& [plan, project, notes] = what;
    std::map<Feature, Made> made;
    for (size_t i = 0; i < plan.features.size(); ++i)
        if (plan.features.test(i))
            made[static_cast<Feature>(i)] = madeBy(static_cast<Feature>(i), plan, project, tables, gpu, programs);
    const std::vector<DrawnField> fields = drawnFields(project, tables);
    const std::vector<ShownLayer> layers = shownLayers(project, notes);
    const std::vector<ForestCount> forests = countForests(project);
    return json ? asJson(made, plan, fields, forests, layers) : asText(made, plan, fields, forests, layers);
}

}  // namespace sward
