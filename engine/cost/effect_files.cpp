#include "cost/effect_files.h"

#include <algorithm>

#include "core/file.h"
#include "maps/map_io.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

Json differenceJson(const PairedDifference& d) {
    Json j;
    j["median"] = d.median, j["low"] = d.low, j["high"] = d.high;
    j["confidence"] = d.confidence, j["pairs"] = d.pairs;
    return j;
}

Json stepJson(const SwitchStep& step) {
    Json j;
    j["path"] = step.path(), j["told"] = step.told();
    if (step.field.empty())
        j["removed"] = true;
    else
        j["value"] = step.value;
    return j;
}

std::string fileOf(Feature feature) { return std::string(featureName(feature)) + ".png"; }

Json effectJson(const EffectFound& e, const std::string& folder) {
    Json j;
    j["effect"] = featureName(e.feature), j["help"] = featureRow(e.feature).help;
    j["changed_pixels"] = e.changed, j["changed_share"] = e.share, j["greatest_change_255"] = e.greatest;
    j["cost_ms"] = differenceJson(e.ms), j["costs_unseen"] = e.costsUnseen();
    j["off"] = Json::makeArray(), j["also_off"] = Json::makeArray();
    for (const SwitchStep& step : e.off) j["off"].push(stepJson(step));
    for (const FeatureRow& row : featureRows())
        if (has(e.alsoOff, row.feature)) j["also_off"].push(row.name);
    if (!folder.empty() && !e.where.empty()) j["picture"] = (fs::path(folder) / fileOf(e.feature)).string();
    if (!e.error.empty()) j["error"] = e.error;
    return j;
}

double numberOf(const Json& j, const char* key) {
    const Json* v = j.find(key);
    return v && v->isNumber() ? v->number : 0;
}
std::string textOf(const Json& j, const char* key) {
    const Json* v = j.find(key);
    return v && v->isString() ? v->text : "";
}

PairedDifference differenceFrom(const Json* j) {
    if (!j) return {};
    return {numberOf(*j, "median"), numberOf(*j, "low"), numberOf(*j, "high"), numberOf(*j, "confidence"),
            static_cast<int>(numberOf(*j, "pairs"))};
}

EffectLine lineFrom(const Json& j) {
    EffectLine e;
    const std::string name = textOf(j, "effect");
    for (const FeatureRow& row : featureRows())
        if (row.name == name) e.feature = row.feature;
    e.changed = static_cast<uint64_t>(std::max(numberOf(j, "changed_pixels"), 0.0));
    e.share = numberOf(j, "changed_share"), e.greatest = static_cast<int>(numberOf(j, "greatest_change_255"));
    e.ms = differenceFrom(j.find("cost_ms"));
    const Json *unseen = j.find("costs_unseen"), *off = j.find("off");
    e.costsUnseen = unseen && unseen->boolean;
    if (off)
        for (const Json& step : off->array) e.off.push_back(textOf(step, "told"));
    e.picture = textOf(j, "picture"), e.error = textOf(j, "error");
    return e;
}

std::string joined(const std::vector<SwitchStep>& steps) {
    std::string out;
    for (const SwitchStep& s : steps) out += (out.empty() ? "" : "; ") + s.told();
    return out;
}

}  // namespace

std::string shareText(uint64_t changed, double share) {
    if (changed == 0) return "0 pixels";
    return share < 0.001 ? "< 0.1 %" : fmt::format("{:.1f} %", 100 * share);
}

Json effectMapJson(const EffectMap& map, const std::string& camera, const std::string& folder) {
    Json j;
    j["camera"] = camera;
    j["size"].push(map.width), j["size"].push(map.height);
    j["noise_pixels"] = map.noise;
    j["effects"] = Json::makeArray();
    for (const EffectFound& e : map.effects) j["effects"].push(effectJson(e, folder));
    return j;
}

Status writeEffectPictures(const EffectMap& map, const fs::path& folder) {
    if (Status s = makeFolderOf(folder / "scene.png"); !s) return s;
    if (Status s = writeImagePng(folder / "scene.png", map.width, map.height, 3, map.picture); !s) return s;
    for (const EffectFound& e : map.effects)
        if (!e.where.empty())
            if (Status s = writeImagePng(folder / fileOf(e.feature), map.width, map.height, 3, changePicture(map, e));
                !s)
                return s;
    return {};
}

std::string effectMapText(const EffectMap& map, const std::string& camera) {
    const double sure = map.effects.empty() ? 0 : map.effects.front().ms.confidence;
    std::string out = fmt::format(
        "{}, {} x {}; cost: what a frame takes less without it, with {:.0f} % sure to lie in "
        "the brackets\n",
        camera, map.width, map.height, 100 * sure);
    out += fmt::format("  {:<18} {:>10} {:>8}  {:<26} {}\n", "effect", "changed", "most/255", "cost", "to turn it off");
    for (const EffectFound& e : map.effects) {
        const std::string name = std::string(e.costsUnseen() ? "! " : "  ") + featureName(e.feature);
        if (!e.error.empty()) {
            out += fmt::format("{:<20} {}\n", name, e.error);
            continue;
        }
        out += fmt::format("{:<20} {:>10} {:>8}  {:<26} {}\n", name, shareText(e.changed, e.share), e.greatest,
                           differenceText(e.ms), joined(e.off));
    }
    if (map.noise > 0)
        out += fmt::format("  {} pixels change by as much when the same scene is drawn twice\n", map.noise);
    return out;
}

Result<std::vector<EffectLine>> effectsFrom(const Json& json, const std::string& camera) {
    const Json* cameras = json.find("cameras");
    if (!cameras || !cameras->isArray()) return unsound("this is no effect map", "measure again");
    for (const Json& one : cameras->array) {
        const Json* effects = one.find("effects");
        if (textOf(one, "camera") != camera || !effects) continue;
        std::vector<EffectLine> out;
        for (const Json& e : effects->array)
            if (EffectLine line = lineFrom(e); line.feature != Feature::Count) out.push_back(std::move(line));
        return out;
    }
    return unsound("the effect map has no camera " + camera, "measure again");
}

}  // namespace sward
