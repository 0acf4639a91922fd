#include "cost/cost_settings.h"

#include "core/json.h"

namespace sward {
namespace {

// Name and number of a value that more of makes more work; nothing of another value.
std::optional<std::pair<std::string, double>> amountOf(const std::string& value) {
    const auto v = settingValue(value);
    if (!v) return {};
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

// What a technique's row tries, around each field's own values.
std::vector<SettingValues> sweptBy(const TechniqueRow& row,
                                   const std::vector<std::pair<std::string, FieldEntity>>& fields) {
    if (!row.sweep) return {{"msaa=4"}};
    const size_t settings = row.sweep(fields.front().second).size();
    std::vector<SettingValues> out;
    for (size_t i = 0; i < settings; ++i) {
        std::vector<std::pair<std::string, SettingValues>> each;
        for (const auto& [name, field] : fields) each.push_back({name, row.sweep(field).at(i)});
        out.push_back(mergedValues(each));
    }
    return out;
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

std::string CostSetting::text() const {
    std::string all;
    for (const std::string& v : values) all += (all.empty() ? "" : " ") + v;
    return all.empty() ? kAsItIs : all;
}

std::string ownTechniques(const Project& project) {
    std::vector<std::string> names;
    for (const auto& [name, field] : fieldsOf(project))
        if (std::find(names.begin(), names.end(), field.grows.technique) == names.end())
            names.push_back(field.grows.technique);
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : "+") + name;
    return all;
}

Result<std::vector<CostSetting>> costSettings(const Project& project, const Tables& tables,
                                              const std::string& technique) {
    const auto fields = fieldsOf(project);
    if (fields.empty()) return unsound("the project has no grass", "add a GrassField").at(project.dir);
    if (!technique.empty() && !findTechnique(tables.techniques, technique))
        return usage("there is no technique \"" + technique + "\"", techniqueNames(tables.techniques));
    const std::string own = ownTechniques(project);
    std::vector<CostSetting> out{{findTechnique(tables.techniques, own) ? own : "", {}}};
    for (const TechniqueRow& row : tables.techniques) {
        if (!technique.empty() && technique != row.name) continue;
        for (const SettingValues& v : sweptBy(row, fields)) out.push_back({row.name, v});
    }
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
    for (const auto& [name, e] : project.entities) {
        const GrassField* field = project.registry.get<GrassField>(e);
        if (!field) continue;
        if (!setting.technique.empty())
            if (Status s = setField(project, tables, name + ".GrassField.technique", setting.technique); !s) return s;
        for (const std::string& text : setting.values) {
            const auto v = settingValue(text);
            if (!v) return v.error();
            const auto ofView = setView(view, v->name, v->value);
            if (!ofView) return ofView.error();
            if (*ofView || !v->isFor(name)) continue;
            const std::string path = settingPath(tables, name, field->technique, v->name);
            if (Status s = setField(project, tables, path, v->value); !s) return s;
        }
    }
    return {};
}

}  // namespace sward
