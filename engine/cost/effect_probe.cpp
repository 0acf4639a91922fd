#include "cost/effect_probe.h"

#include <algorithm>

#include "world/drawn_project.h"

namespace sward {
namespace {

constexpr int kFullChange = 64;  // of 255, from which the picture of changes is brightest

// The scene, what draws it, and what draws it without something.
struct Probe {
    const EffectRequest& request;
    const Project& project;
    const Tables& tables;
    Renderer whole, without;
    ViewSettings settings;
    FeatureSet features = {};  // of the project as it is drawn
    const Project* drawn = nullptr;
    EffectMap map = {};
};

ViewSettings settingsOf(const EffectRequest& r) {
    ViewSettings s;
    s.width = r.width, s.height = r.height, s.msaa = r.msaa, s.time = r.time;
    return s;
}

Result<std::vector<uint8_t>> drawn(Renderer& renderer, const Probe& p, const Project& project) {
    if (Status s = drawSettled(renderer, project, p.request.camera, p.settings); !s) return s.error();
    return renderer.readImage();
}

void countChanges(EffectFound& e, const Probe& p, const std::vector<uint8_t>& picture) {
    e.where = changesBetween(p.map.picture, picture);
    for (const uint8_t change : e.where) {
        e.changed += change >= kSeenChange;
        e.greatest = std::max<int>(e.greatest, change);
    }
    e.share = static_cast<double>(e.changed) / static_cast<double>(std::max<size_t>(e.where.size(), 1));
}

// How far one effect is.
using Told = std::function<bool(double share)>;

// False once it was stopped. The two renderers have each drawn their scene before they are timed.
Result<bool> timeEffect(EffectFound& e, Probe& p, const Project& left, const Told& told) {
    PairedFrames frames{.pairs = p.request.pairs};
    while (!allDrawn(frames)) {
        if (!told(static_cast<double>(frames.drawn + 1) / (framesOf(frames) + 1))) return false;
        if (Status s = drawNext(frames, {{{p.whole, p.project}, {p.without, left}}}, p.request.camera, p.settings); !s)
            return s.error();
    }
    e.ms = msBetween(frames);
    return true;
}

Result<bool> probeOne(EffectFound& e, Probe& p, const Told& told) {
    e.off = stepsWithout(p.project, *p.drawn, p.tables, e.feature);
    Project left = snapshot(p.project, p.tables.components);
    if (Status s = takeSteps(left, p.tables, e.off); !s) return s.error();
    DrawnProject layered;
    const FeatureSet remain = sceneFeatures(layered.of(left, p.tables.components).registry, p.tables);
    if (has(remain, e.feature)) return failed(std::string(featureName(e.feature)) + " stays whatever is set");
    e.alsoOff = (p.features & ~remain).reset(static_cast<size_t>(e.feature));
    const auto picture = drawn(p.without, p, left);
    if (!picture) return picture.error();
    countChanges(e, p, *picture);
    return timeEffect(e, p, left, told);
}

// The scene by both renderers: they agree but for what chance there is.
Status drawWhole(Probe& p) {
    auto first = drawn(p.whole, p, p.project);
    if (!first) return first.error();
    const auto second = drawn(p.without, p, p.project);
    if (!second) return second.error();
    p.map.width = p.settings.width, p.map.height = p.settings.height;
    p.map.picture = std::move(*first);
    for (const uint8_t change : changesBetween(p.map.picture, *second)) p.map.noise += change >= kSeenChange;
    return {};
}

std::vector<Feature> switchable(const FeatureSet& features) {
    std::vector<Feature> out;
    for (const FeatureRow& row : featureRows())
        if (has(features, row.feature) && canBeLeftOut(row.feature)) out.push_back(row.feature);
    return out;
}

Error stopped() { return interruption("interrupted; nothing was written"); }

}  // namespace

std::vector<Feature> effectsOf(const Project& project, const Tables& tables) {
    DrawnProject layered;
    return switchable(sceneFeatures(layered.of(project, tables.components).registry, tables));
}

Result<EffectMap> probeEffects(const EffectRequest& request, const Project& project, const Tables& tables, Gpu& gpu,
                               const EffectProgress& progress) {
    Probe p{request, project, tables, Renderer(gpu, tables), Renderer(gpu, tables), settingsOf(request)};
    DrawnProject layered;
    p.drawn = &layered.of(project, tables.components);
    p.features = sceneFeatures(p.drawn->registry, tables);
    if (!progress("the scene", 0)) return stopped();
    if (Status s = drawWhole(p); !s) return s.error();
    const std::vector<Feature> all = switchable(p.features);
    for (size_t i = 0; i < all.size(); ++i) {
        const Told told = [&](double share) {
            return progress(featureName(all[i]), (static_cast<double>(i) + share) / static_cast<double>(all.size()));
        };
        if (!told(0)) return stopped();
        EffectFound& e = p.map.effects.emplace_back();
        e.feature = all[i];
        const auto done = probeOne(e, p, told);
        if (!done) e.error = done.error().text();
        if (done && !*done) return stopped();
    }
    sortEffects(p.map.effects);
    return std::move(p.map);
}

std::vector<uint8_t> changesBetween(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
    CHECK_EQ(a.size(), b.size());
    std::vector<uint8_t> out(a.size() / 3);
    for (size_t i = 0; i < out.size(); ++i)
        for (size_t k = 3 * i; k < 3 * i + 3; ++k)
            out[i] = std::max(out[i], static_cast<uint8_t>(std::max(a[k], b[k]) - std::min(a[k], b[k])));
    return out;
}

void sortEffects(std::vector<EffectFound>& effects) {
    const auto rank = [](const EffectFound& e) {
        return !e.error.empty() ? 3 : e.costsUnseen() ? 0 : e.changed == 0 ? 1 : 2;
    };
    std::stable_sort(effects.begin(), effects.end(), [&](const EffectFound& a, const EffectFound& b) {
        return rank(a) != rank(b) ? rank(a) < rank(b) : a.ms.median > b.ms.median;
    });
}

std::vector<uint8_t> changePicture(const EffectMap& map, const EffectFound& e) {
    if (e.where.empty()) return {};
    std::vector<uint8_t> out(map.picture.size());
    for (size_t i = 0; i < e.where.size(); ++i) {
        const uint8_t* rgb = &map.picture[3 * i];
        const auto grey = static_cast<uint8_t>((54 * rgb[0] + 183 * rgb[1] + 19 * rgb[2]) / 512);
        uint8_t* to = &out[3 * i];
        to[0] = to[1] = to[2] = grey;
        if (e.where[i] < kSeenChange) continue;
        const int bright = 255 * (std::min<int>(e.where[i], kFullChange) - kSeenChange) / (kFullChange - kSeenChange);
        to[0] = 255, to[1] = static_cast<uint8_t>(bright), to[2] = 0;
    }
    return out;
}

}  // namespace sward
