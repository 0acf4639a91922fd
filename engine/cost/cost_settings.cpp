#include "cost/cost_settings.h"

#include "core/json.h"

namespace sward {
namespace {

std::string distance(const char* name, float own, double factor) {
    return std::string(name) + "=" + shortestText(static_cast<float>(std::round(own * factor * 1000) / 1000));
}

// Where blades give way to slices, and slices to the ground's one, as factors of the field's own distances.
std::vector<std::string> tiers(const GrassField& f, double near, double far) {
    const double least = std::isfinite(f.maxGeom) ? f.maxGeom * near / std::max(f.minBTF, 1e-3f) : 0;
    far = std::max(far, std::min(least, 1e3));
    return {distance("minGeom", f.minGeom, near), distance("maxGeom", f.maxGeom, near),
            distance("minBTF", f.minBTF, far), distance("maxBTF", f.maxBTF, far)};
}
std::vector<std::string> with(std::vector<std::string> values, std::initializer_list<const char*> more) {
    values.insert(values.end(), more.begin(), more.end());
    return values;
}

void addHybrid(const GrassField& own, std::vector<CostSetting>& out) {
    for (const double near : {0.25, 0.5, 0.7071, 1.0, 1.4142, 2.0})
        for (const double far : {0.5, 1.0, 2.0}) out.push_back({"hybrid", with(tiers(own, near, far), {"msaa=4"})});
    for (const double near : {0.5, 1.0, 2.0}) out.push_back({"hybrid", with(tiers(own, near, 1), {"msaa=1"})});
    for (const char* one : {"sharpness=0", "sharpness=1", "sharpness=2", "filtering=trilinear", "sliceCover=published",
                            "lightWeights=published", "transparency=both", "storage=compressed"})
        out.push_back({"hybrid", {one, "msaa=4"}});
}
// At less detail there are fewer and wider blades.
void addGeometry(const GrassField&, std::vector<CostSetting>& out) {
    for (const char* detail : {"detail=0.125", "detail=0.25", "detail=0.5", "detail=1"})
        for (const char* msaa : {"msaa=1", "msaa=4"}) out.push_back({"geometry", {detail, msaa}});
}
void addSlices(const GrassField& own, std::vector<CostSetting>& out) {
    for (const double far : {0.5, 1.0, 2.0})
        out.push_back({"slices", {distance("minBTF", own.minBTF, far), distance("maxBTF", own.maxBTF, far), "msaa=4"}});
    out.push_back({"slices", {"msaa=1"}});
}
void addFlat(const GrassField&, std::vector<CostSetting>& out) {
    for (const char* msaa : {"msaa=1", "msaa=4"}) out.push_back({"flat", {msaa}});
}
// Fewer blades and less far, coarser blades, and who tessellates.
void addTessellated(const GrassField& own, std::vector<CostSetting>& out) {
    for (const double far : {0.5, 1.0})
        out.push_back({"tessellated", {distance("maxDistance", own.maxDistance, far), "msaa=4"}});
    for (const char* one : {"thinning=0", "levelBy=pixels", "msaa=1"}) out.push_back({"tessellated", {one}});
}

// Name and number of a value that more of makes more work; nothing of another value.
std::optional<std::pair<std::string, double>> amountOf(const std::string& value) {
    const size_t equals = value.find('=');
    const std::string name = value.substr(0, equals);
    for (const char* n : {"minGeom", "maxGeom", "minBTF", "maxBTF", "detail", "msaa"})
        if (name == n && equals != std::string::npos)
            return std::pair(name, value.substr(equals + 1) == "inf" ? 1e30 : std::atof(value.c_str() + equals + 1));
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

}  // namespace

std::string CostSetting::text() const {
    std::string all;
    for (const std::string& v : values) all += (all.empty() ? "" : " ") + v;
    return all.empty() ? "as it is" : all;
}

std::span<const CostTechnique> costTechniques() {
    static constexpr CostTechnique kRows[] = {{"hybrid", addHybrid},
                                              {"geometry", addGeometry},
                                              {"slices", addSlices},
                                              {"flat", addFlat},
                                              {"tessellated", addTessellated}};
    return kRows;
}

Result<std::vector<CostSetting>> costSettings(const Project& project, const std::string& technique) {
    const GrassField* field = nullptr;
    for (const auto& [name, e] : project.entities)
        if (!field) field = project.registry.get<GrassField>(e);
    if (!field) return unsound("the project has no grass", "add a GrassField").at(project.dir);
    std::vector<CostSetting> out;
    std::string names;
    for (const CostTechnique& row : costTechniques()) {
        names += (names.empty() ? "" : ", ") + std::string(row.name);
        if (technique.empty() || technique == row.name) row.add(*field, out);
    }
    if (out.empty()) return usage("there is no technique \"" + technique + "\"", names);
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
        if (!project.registry.get<GrassField>(e)) continue;
        const std::string at = name + ".GrassField.";
        if (Status s = setField(project, tables, at + "technique", setting.technique); !s) return s;
        for (const std::string& value : setting.values) {
            const size_t equals = value.find('=');
            if (equals == std::string::npos) return usage("\"" + value + "\" has no '='", "write NAME=VALUE");
            const auto view_ = setView(view, value.substr(0, equals), value.substr(equals + 1));
            if (!view_) return view_.error();
            if (*view_) continue;
            if (Status s = setField(project, tables, at + value.substr(0, equals), value.substr(equals + 1)); !s)
                return s;
        }
    }
    return {};
}

}  // namespace sward
