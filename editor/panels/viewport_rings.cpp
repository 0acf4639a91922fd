#include "panels/viewport_rings.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "panels/viewport_input.h"
#include "ui/theme.h"
#include "ui/widgets.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr int kPoints = 192;          // of a ring
constexpr double kTolerance = 8;      // pixels from a ring at which the pointer is on it
constexpr double kFarthest = 100000;  // metres that a hand can drag to over a plain

glm::dvec3 centreOf(const RingParts& p) { return p.tiers.pin.value_or(p.camera.eye); }

HeightAt heightsOf(const Ground& ground) {
    return [ground](double x, double z) {
        return ground.origin.y + terrainHeight(*ground.terrain, x - ground.origin.x, z - ground.origin.z);
    };
}

bool onTerrain(const Ground& ground, const glm::dvec3& p) {
    const double x = p.x - ground.origin.x, z = p.z - ground.origin.z;
    return x >= 0 && z >= 0 && x <= ground.terrain->size.x && z <= ground.terrain->size.y;
}

// Where ring i is on the screen now, and where on it nothing is in the way.
void layRing(const RingParts& p, const Ground& ground, size_t i, double distance) {
    constexpr double kSlack = 0.15;  // metres: the ground's own bumps at a grazing angle
    const HeightAt heightAt = heightsOf(ground);
    const std::vector<std::optional<glm::dvec3>> points = ringPoints(heightAt, centreOf(p), distance, kPoints);
    ScreenRing& screen = p.tiers.screen[i];
    std::vector<bool>& clear = p.tiers.clear[i];
    screen.assign(points.size(), std::nullopt);
    clear.assign(points.size(), false);
    for (size_t k = 0; k < points.size(); ++k) {
        if (!points[k]) continue;
        screen[k] = projectPoint(p.camera, p.view, *points[k] + glm::dvec3(0, 0.02, 0));
        clear[k] = screen[k] && onTerrain(ground, *points[k]) &&
                   !(ground.terrain->height.present() && hiddenByGround(heightAt, p.camera.eye, *points[k], kSlack));
    }
}

ImU32 faded(ImU32 color, float share) {
    return (color & ~IM_COL32_A_MASK) | static_cast<ImU32>(255 * share) << IM_COL32_A_SHIFT;
}

void strokeRing(const ScreenRing& ring, const std::vector<bool>& clear, ImU32 color, float width, bool shadow) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (size_t i = 0; i < ring.size(); ++i) {
        const size_t next = (i + 1) % ring.size();
        if (!ring[i] || !ring[next]) continue;
        const bool seen = clear[i] && clear[next];
        if (shadow && seen) list.AddLine(vec(*ring[i]), vec(*ring[next]), IM_COL32(0, 0, 0, 130), width + 2.5f);
        if (!shadow) list.AddLine(vec(*ring[i]), vec(*ring[next]), faded(color, seen ? 1 : 0.22f), seen ? width : 1.2f);
    }
}

std::string metres(double distance) { return std::isinf(distance) ? "never" : ui::numberText(distance) + " m"; }

// "12 m, 0.2 px wide": where blades end, and how wide one is there; "40 m, 1.3 px high" of slices.
std::string ringText(const RingParts& p, const FieldEntity& field, size_t i, double distance) {
    const BladeSize blade = bladeSize(field.grows);
    const double pixels = static_cast<double>((i < 2 ? blade.width : blade.height) * p.pixelsPerMetre) / distance;
    if (i % 2 == 0 || !std::isfinite(pixels) || !(pixels > 0)) return metres(distance);
    return fmt::format("{}, {:.2g} px {}", metres(distance), pixels, i < 2 ? "wide" : "high");
}

bool highlighted(const TierView& t, size_t i) {
    if (t.drag && t.drag->tier) return *t.drag->tier == i;
    const std::optional<RingHit>& hit = t.hover;
    return hit && std::find(hit->rings.begin(), hit->rings.end(), i) != hit->rings.end();
}

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

// Room for a text above (or else below) a grip that no other name takes.
Rect roomFor(const Rect& view, ImVec2 grip, ImVec2 size, const std::vector<Rect>& taken) {
    const float x = std::clamp(grip.x - size.x / 2, view.x + 6, std::max(view.x + 6, view.x + view.w - size.x - 6));
    for (const float step : {-1.f, 1.f, -2.f, 2.f, -3.f, 3.f}) {
        const float y = grip.y + step * (size.y + 10) - size.y / 2 - (step < 0 ? 2 : -2);
        const Rect room{x - 5, y - 2, size.x + 10, size.y + 4};
        const bool inside = room.y > view.y && room.y + room.h < view.y + view.h;
        if (inside && std::none_of(taken.begin(), taken.end(), [&](const Rect& r) { return overlap(r, room); }))
            return room;
    }
    return {x - 5, grip.y - size.y - 16, size.x + 10, size.y + 4};
}

// A grip on the ring and its name beside it; scripts find the grip as "Viewport/Ring maxGeom".
void label(const TierView& t, const Rect& r, size_t i, const std::string& distance, std::vector<Rect>& taken) {
    ScreenRing seen = t.screen[i];
    for (size_t k = 0; k < seen.size(); ++k)
        if (!t.clear[i][k]) seen[k].reset();
    const double margin = 14,
                 x = static_cast<double>(r.x) + static_cast<double>(r.w) * (0.26 + 0.14 * static_cast<double>(i));
    const auto at = ringLabel(seen, {static_cast<double>(r.x) + margin, static_cast<double>(r.y) + margin},
                              {static_cast<double>(r.x + r.w) - margin, static_cast<double>(r.y + r.h) - margin}, x);
    if (!at) return;
    const ImVec2 grip = vec(*at);
    ui::recordAt(fmt::format("Viewport/Ring {}", kTierFields[i]),
                 {ui::Kind::Area, grip.x - 6, grip.y - 6, grip.x + 6, grip.y + 6, distance});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = highlighted(t, i) ? 7.5f : 5.5f;
    list.AddCircleFilled(grip, radius + 1.5f, IM_COL32(0, 0, 0, 170));
    list.AddCircleFilled(grip, radius, kTierColors[i]);
    const std::string text = fmt::format("{} {}", kTierTitles[i], distance);
    const Rect room = roomFor(r, grip, ImGui::CalcTextSize(text.c_str()), taken);
    taken.push_back(room);
    list.AddRectFilled({room.x, room.y}, {room.x + room.w, room.y + room.h},
                       IM_COL32(18, 20, 18, highlighted(t, i) ? 245 : 190), 3);
    list.AddText({room.x + 5, room.y + 2}, kTierColors[i], text.c_str());
}

void drawPin(const RingParts& p, const Ground& ground) {
    if (!p.tiers.pin) return;
    const glm::dvec3 pin = *p.tiers.pin;
    const auto top = projectPoint(p.camera, p.view, pin);
    const auto foot = projectPoint(p.camera, p.view, {pin.x, heightsOf(ground)(pin.x, pin.z), pin.z});
    if (!top || !foot) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine(vec(*foot), vec(*top), IM_COL32(0, 0, 0, 160), 4);
    list.AddLine(vec(*foot), vec(*top), IM_COL32_WHITE, 1.8f);
    list.AddCircleFilled(vec(*top), 5, IM_COL32_WHITE);
    list.AddText({vec(*top).x + 9, vec(*top).y - 8}, IM_COL32_WHITE, "pinned eye");
}

// Under the pointer; beyond the terrain on the level where the ring was taken.
std::optional<glm::dvec3> groundTowards(const RingParts& p, double x, double y, double level) {
    if (const auto ground = groundAt(p.doc, p.camera, p.view, x, y)) return ground;
    const glm::dvec3 ray = rayThrough(p.camera, p.view, x, y), eye = p.camera.eye;
    const double far = (level - eye.y) / ray.y;
    if (!(far > 0) || !(far < kFarthest)) return std::nullopt;
    return eye + ray * far;
}

}  // namespace

std::string tierEntity(const Document& document, const std::string& chosen, const std::string& selected) {
    if (!document.isOpen()) return "";
    const Project& p = document.project();
    const auto grows = [&](const std::string& name) {
        return p.registry.get<GrassField>(findEntity(p, name)) != nullptr;
    };
    for (const std::string& name : {chosen, selected})
        if (!name.empty() && p.entities.contains(name) && grows(name)) return name;
    for (const auto& [name, entity] : p.entities)
        if (p.registry.get<GrassField>(entity)) return name;
    return "";
}

std::optional<FieldEntity> tierField(const Document& document, const std::string& entity) {
    if (entity.empty()) return std::nullopt;
    const Project& p = document.project();
    const Entity e = findEntity(p, entity);
    return FieldEntity{p.registry, e, *p.registry.get<GrassField>(e)};
}

TierDistances tiersShown(const FieldEntity& field, float pixelsPerMetre) {
    return tiersOf(tiersSeen(field, pixelsPerMetre));
}

void setTiers(Document& document, Messages& messages, const std::string& entity, float pixelsPerMetre,
              const TierDistances& wanted) {
    const std::optional<FieldEntity> field = tierField(document, entity);
    const TierDistances now = tiersShown(*field, pixelsPerMetre);
    const auto same = [](double a, double b) { return static_cast<float>(a) == static_cast<float>(b); };
    if (std::equal(now.begin(), now.end(), wanted.begin(), same)) return;
    editTiers(document, messages, entity,
              tierEdits(wanted, field->settings<HybridTiers>().tiersBy, bladeSize(field->grows), pixelsPerMetre));
}

void editTiers(Document& document, Messages& messages, const std::string& entity, std::span<const TierEdit> edits) {
    for (const TierEdit& e : edits) {
        const std::string path = fmt::format("{}.HybridTiers.{}", entity, e.field);
        const Result<ConstFieldRef> now = findField(document.project(), document.tables().components, path);
        if (now && *static_cast<const float*>(now->value) == static_cast<float>(e.value)) continue;
        accept(messages, document.setField(path, ui::numberText(e.value)));
    }
}

std::string tierPath(const std::string& entity, size_t i) { return entity + ".HybridTiers." + kTierFields[i]; }

void hoverRing(const RingParts& p, const FrameInput& in, bool free) {
    TierView& t = p.tiers;
    t.hover.reset();
    if (!free || !p.shown) return;
    std::array<ScreenRing, kTierCount> seen = t.screen;
    for (size_t i = 0; i < kTierCount; ++i)
        for (size_t k = 0; k < seen[i].size(); ++k)
            if (!t.clear[i][k]) seen[i][k].reset();
    t.hover = pickRing(seen, {in.x, in.y}, kTolerance);
}

void drawRings(const RingParts& p) {
    TierView& t = p.tiers;
    for (ScreenRing& ring : t.screen) ring.clear();
    const Ground ground = p.doc.isOpen() ? p.doc.ground() : Ground{};
    if (!ground.terrain || !p.shown) return;
    const FieldEntity field = *tierField(p.doc, p.entity);
    const TierDistances distances = tiersShown(field, p.pixelsPerMetre);
    for (size_t i = 0; i < kTierCount; ++i) layRing(p, ground, i, distances[i]);
    for (const bool shadow : {true, false})
        for (size_t i = 0; i < kTierCount; ++i)
            strokeRing(t.screen[i], t.clear[i], kTierColors[i], highlighted(t, i) ? 4.5f : 2.2f, shadow);
    drawPin(p, ground);
    std::vector<Rect> taken;
    for (size_t i = 0; i < kTierCount; ++i) label(t, p.view, i, ringText(p, field, i, distances[i]), taken);
    if (t.hover || t.drag) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
}

bool grabRing(const RingParts& p, const FrameInput& in, Edits& edits) {
    TierView& t = p.tiers;
    if (!t.hover) return false;
    RingDrag drag;
    drag.hit = *t.hover;
    drag.offset = drag.hit.at - glm::dvec2(in.x, in.y);
    const auto taken = groundAt(p.doc, p.camera, p.view, drag.hit.at.x, drag.hit.at.y);
    drag.level = taken ? taken->y : 0;
    if (drag.hit.rings.size() == 1) drag.tier = drag.hit.rings.front();
    t.drag = drag;
    const std::string path = tierPath(p.entity, drag.hit.rings.front());
    edits.holding = path;
    p.doc.beginGroup("drag ring of " + path);
    return true;
}

void dragRing(const RingParts& p, Messages& messages, double x, double y) {
    TierView& t = p.tiers;
    const std::optional<FieldEntity> field = tierField(p.doc, p.entity);
    if (!t.drag || !field) return;
    RingDrag& d = *t.drag;
    const glm::dvec2 at = glm::dvec2(x, y) + d.offset;
    if (!d.moved && glm::length(at - d.hit.at) < kFirstMotion) return;
    d.moved = true;
    const auto ground = groundTowards(p, at.x, at.y, d.level);
    if (!ground) return;
    const double wanted = roundedTier(glm::length(*ground - centreOf(p)));
    TierDistances now = tiersShown(*field, p.pixelsPerMetre);
    if (!d.tier) d.tier = ringMeant(d.hit, now[d.hit.rings.front()], wanted);
    now[*d.tier] = stoppedTier(now, *d.tier, wanted);
    setTiers(p.doc, messages, p.entity, p.pixelsPerMetre, now);
}

void releaseRing(TierView& tiers) { tiers.drag.reset(); }

void cancelRing(TierView& tiers, Document& document, Edits& edits, Messages& messages) {
    tiers.drag.reset();
    if (edits.holding.empty()) return;
    edits.holding.clear();
    document.cancelGroup();
    say(messages, "the ring is back where it was");
}

}  // namespace sward
