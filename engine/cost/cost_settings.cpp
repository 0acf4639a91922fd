#include "cost/cost_settings.h"

#include <algorithm>

#include "core/json.h"
#include "scene/antialias.h"
#include "scene/forest_technique.h"

namespace sward {
namespace {

// Name and number of a value that more of makes more work; nothing of another value.
std::optional<std::pair<std::string, double>> amountOf(const std::string& value) {
    const auto v = settingValue(value);
    if (!v) return {};
    for (const char* n : {"bladePixels", "slicePixels"})
        if (v->name == n) return std::pair(v->entity + "." + n, 1 / std::atof(v->value.c_str()));
    for (const char* n : {"minGeom", "maxGeom", "minBTF", "maxBTF", "detail", "msaa"})
        if (v->name == n) return std::pair(v->entity + "." + n, v->value == "inf" ? 1e30 : std::atof(v->value.c_str()));
    return {};
}

Status setField(Project& p, const Tables& tables, const std::string& path, const std::string& value) {
    auto f = findField(p, tables.components, path);
    return f ? setFieldText(*f, value) : Status(f.error());
}

// True if the value was the view's.
Result<bool> setView(ViewSettings& view, const std::string& name, const std::string& value) {
    if (name != "msaa" && name != "detail") return false;
    const double number = std::atof(value.c_str());
    const bool whole = number == std::floor(number);
    if (!(number > 0) || (name == "msaa" && (!whole || number > 64)) || (name == "detail" && number > 1))
        return usage(name + "=" + value + " is out of its range", "msaa takes 1 to 64, detail ]0,1]");
    if (name == "msaa")
        view.msaa = static_cast<int>(number);
    else
        view.detail = static_cast<float>(number);
    return true;
}

// True if the value said how pixels come to their samples.
Result<bool> setAntialiasing(Project& project, const std::string& name, const std::string& value) {
    if (name != kAntialiasSetting) return false;
    for (size_t i = 0; i < std::size(kAntialiasings); ++i)
        if (value == kAntialiasings[i]) {
            setAntialias(project, static_cast<Antialiasing>(i));
            return true;
        }
    return usage(name + "=" + value + " does not exist", "msaa or temporal");
}

// What a technique's row tries, around each field's own values: sweep(one of `each`) is a list, equally long for all.
template <class T, class F>
std::vector<SettingValues> sweptBy(const std::vector<std::pair<std::string, T>>& fields, F sweep) {
    const size_t settings = sweep(fields.front().second).size();
    std::vector<SettingValues> out;
    for (size_t i = 0; i < settings; ++i) {
        std::vector<std::pair<std::string, SettingValues>> each;
        for (const auto& [name, field] : fields) each.push_back({name, sweep(field).at(i)});
        out.push_back(mergedValues(each));
    }
    return out;
}
// A technique's sweep takes four samples a pixel beside its other values. Where the project's frames add up, its other
// values are tried in frames that add up, so that each row differs from the project as it is in those alone; four
// samples are tried once.
std::vector<SettingValues> withOwnAntialiasing(const Project& project, const std::vector<SettingValues>& swept) {
    constexpr const char* kFourSamples = "msaa=4";
    if (!temporalOf(project)) return swept;
    std::vector<SettingValues> out;
    const auto addOnce = [&](const SettingValues& v) {
        if (std::find(out.begin(), out.end(), v) == out.end()) out.push_back(v);
    };
    for (SettingValues v : swept) {
        std::replace(v.begin(), v.end(), std::string(kFourSamples), std::string(kTemporalSetting));
        addOnce(v);
    }
    addOnce({kFourSamples});
    return out;
}
void addGrass(std::vector<CostSetting>& out, const Project& project, const Tables& tables, const std::string& only) {
    const auto fields = fieldsOf(project);
    for (const TechniqueRow& row : tables.techniques) {
        if (fields.empty() || (!only.empty() && only != row.name)) continue;
        const auto sweep = [&](const FieldEntity& f) {
            return row.sweep ? row.sweep(f) : std::vector<SettingValues>{{"msaa=4"}};
        };
        for (const SettingValues& v : withOwnAntialiasing(project, sweptBy(fields, sweep)))
            out.push_back({row.name, v});
    }
}
void addForests(std::vector<CostSetting>& out, const Project& project, const std::string& only) {
    const auto forests = growingForests(project);
    for (const ForestTechniqueRow& row : forestTechniques()) {
        if (forests.empty() || (!only.empty() && only != kEveryForestTechnique && only != row.name)) continue;
        const auto sweep = [&](const Forest* f) { return row.sweep(*f); };
        for (const SettingValues& v : withOwnAntialiasing(project, sweptBy(forests, sweep)))
            out.push_back({row.name, v});
    }
}
// Of one entity.
Status applyTo(Project& project, const Tables& tables, const std::string& entity, const CostSetting& setting,
               ViewSettings& view) {
    if (!setting.technique.empty()) {
        const auto [path, value] = techniqueField(entity, setting.technique);
        if (Status s = setField(project, tables, path, value); !s) return s;
    }
    const GrassField* field = project.registry.get<GrassField>(findEntity(project, entity));
    const std::string technique = setting.technique.empty() && field ? field->technique : setting.technique;
    for (const std::string& text : setting.values) {
        const auto v = settingValue(text);
        if (!v) return v.error();
        const auto ofAll = setAntialiasing(project, v->name, v->value);
        if (!ofAll) return ofAll.error();
        if (*ofAll) continue;
        const auto ofView = setView(view, v->name, v->value);
        if (!ofView) return ofView.error();
        if (v->name == "msaa" && temporalOf(project)) setAntialias(project, Antialiasing::Msaa);
        if (*ofView || !v->isFor(entity)) continue;
        if (Status s = setField(project, tables, settingPath(tables, entity, technique, v->name), v->value); !s)
            return s;
    }
    return {};
}

}  // namespace

Result<SettingValue> settingValue(const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos) return usage("\"" + text + "\" has no '='", "write NAME=VALUE");
    const size_t dot = text.rfind('.', equals);
    const std::string entity = dot == std::string::npos ? "" : text.substr(0, dot);
    const size_t name = entity.empty() ? 0 : dot + 1;
    return SettingValue{entity, text.substr(name, equals - name), text.substr(equals + 1)};
}

SettingValues mergedValues(const std::vector<std::pair<std::string, SettingValues>>& byEntity) {
    SettingValues out;
    if (byEntity.empty()) return out;
    const SettingValues& first = byEntity.front().second;
    for (size_t i = 0; i < first.size(); ++i) {
        const bool common =
            std::all_of(byEntity.begin(), byEntity.end(), [&](const auto& e) { return e.second.at(i) == first[i]; });
        if (common) {
            out.push_back(first[i]);
            continue;
        }
        for (const auto& [entity, values] : byEntity) out.push_back(entity + "." + values.at(i));
    }
    return out;
}

std::string settingPath(const Tables& tables, const std::string& entity, const std::string& technique,
                        const std::string& name) {
    if (findForestTechnique(technique)) return entity + ".Forest." + name;
    const TechniqueRow* row = findTechnique(tables.techniques, technique);
    const auto has = [&](const ComponentRow& c) {
        return std::any_of(c.fields.begin(), c.fields.end(), [&](const FieldRow& f) { return name == f.name; });
    };
    if (row)
        for (const char* settings : row->settings)
            if (const ComponentRow* c = findComponent(tables.components, settings); c && has(*c))
                return entity + "." + settings + "." + name;
    return entity + ".GrassField." + name;
}

std::vector<std::string> entitiesOf(const Project& project, const std::string& technique) {
    std::vector<std::string> names;
    if (findForestTechnique(technique))
        for (const auto& [name, forest] : growingForests(project)) names.push_back(name);
    else
        for (const auto& [name, field] : fieldsOf(project)) names.push_back(name);
    return names;
}

std::pair<std::string, std::string> techniqueField(const std::string& entity, const std::string& technique) {
    if (const ForestTechniqueRow* row = findForestTechnique(technique))
        return {entity + ".Forest.technique", kForestTechniques[row->technique]};
    return {entity + ".GrassField.technique", technique};
}

std::string sweptNames(const Tables& tables) {
    std::string names = techniqueNames(tables.techniques);
    for (const ForestTechniqueRow& row : forestTechniques()) names += std::string(", ") + row.name;
    return names + ", or " + kEveryForestTechnique + " for all of forests";
}

std::string CostSetting::text() const {
    std::string all;
    for (const std::string& v : values) all += (all.empty() ? "" : " ") + v;
    return all.empty() ? kAsItIs : all;
}

std::string ownTechniques(const Project& project) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const auto& [name, field] : fieldsOf(project)) add(field.grows.technique);
    if (names.empty())
        for (const auto& [name, forest] : growingForests(project)) add(techniqueOf(*forest).name);
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : "+") + name;
    return all;
}

Result<std::vector<CostSetting>> costSettings(const Project& project, const Tables& tables,
                                              const std::string& technique) {
    const bool isForests = technique == kEveryForestTechnique || findForestTechnique(technique);
    if (!technique.empty() && !isForests && !findTechnique(tables.techniques, technique))
        return usage("there is no technique \"" + technique + "\"", sweptNames(tables));
    const bool grass = !fieldsOf(project).empty(), forests = !growingForests(project).empty();
    if (isForests && !forests) return unsound("the project has no forest", "add a Forest").at(project.dir);
    if (!grass && (!forests || (!technique.empty() && !isForests)))
        return unsound("the project has no grass", "add a GrassField").at(project.dir);
    const std::string own = ownTechniques(project);
    const bool one = findTechnique(tables.techniques, own) || findForestTechnique(own);
    std::vector<CostSetting> out{{one ? own : "", {}}};
    addGrass(out, project, tables, technique);
    addForests(out, project, technique);
    return out;
}

bool drawsNoLess(const CostSetting& a, const CostSetting& b) {
    if (a.technique != b.technique || a.values.size() != b.values.size()) return false;
    for (size_t i = 0; i < a.values.size(); ++i) {
        const auto more = amountOf(a.values[i]), less = amountOf(b.values[i]);
        const bool amounts = more && less && more->first == less->first;
        if (amounts ? more->second < less->second : a.values[i] != b.values[i]) return false;
    }
    return true;
}

Status applySetting(Project& project, const Tables& tables, const CostSetting& setting, ViewSettings& view) {
    for (const std::string& entity : entitiesOf(project, setting.technique))
        if (Status s = applyTo(project, tables, entity, setting, view); !s) return s;
    return {};
}

}  // namespace sward
