#include "panels/viewport_objects.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/numerics.h"
#include "panels/viewport_input.h"
#include "scene/ground_path.h"
#include "scene/locked.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

constexpr double kBoxFrom = 4;                           // pixels until a click is a box
constexpr double kIcon = 11;                             // radius of an icon, pixels
constexpr size_t kMostRecorded = 500;                    // objects that scripts find by their names
constexpr ImU32 kChosen = IM_COL32(255, 170, 60, 255);   // the one that the inspector shows
constexpr ImU32 kOthers = IM_COL32(255, 215, 150, 220);  // the others

glm::dvec3 middleOf(const Corners& corners) { return (corners.front() + corners.back()) / 2.0; }

bool within(const Rect& r, const glm::dvec2& p) {
    return p.x >= static_cast<double>(r.x) && p.y >= static_cast<double>(r.y) &&
           p.x <= static_cast<double>(r.x + r.w) && p.y <= static_cast<double>(r.y + r.h);
}

// The nearest icon within reach of the pointer.
std::optional<Handle> iconAt(const ObjectParts& parts, const glm::dvec2& pointer) {
    const Project& p = parts.doc.project();
    std::optional<Handle> best;
    double least = kIcon + 2;
    for (const Handle& h : icons(p, parts.doc.ground(), parts.seconds)) {
        const auto at = projectPoint(parts.camera, parts.view, h.at);
        const double pixels = at ? glm::length(*at - pointer) : least;
        if (pixels < least) least = pixels, best = h;
    }
    return best;
}

// The first object through a place on the screen, unless the ground lies before it.
std::optional<ObjectHit> objectAt(const ObjectParts& parts, double x, double y) {
    constexpr double kSlack = 0.05;  // metres: what stands on the ground touches it
    const glm::dvec3 eye = parts.camera.eye;
    const auto hit = parts.tool.objects.closest(parts.doc.standing(), parts.doc.revision(), eye,
                                                rayThrough(parts.camera, parts.view, x, y));
    const auto ground = hit ? groundAt(parts.doc, parts.camera, parts.view, x, y) : std::nullopt;
    const bool behind = ground && hit->distance > glm::length(*ground - eye) + kSlack;
    return behind ? std::nullopt : hit;
}

// A line in the scene, cut where it passes behind the eye.
void sceneLine(const ObjectParts& parts, glm::dvec3 a, glm::dvec3 b, ImU32 color, float width) {
    constexpr double kNear = 0.06;
    const glm::dvec3 forward = forwardOf(parts.camera);
    const double da = glm::dot(a - parts.camera.eye, forward), db = glm::dot(b - parts.camera.eye, forward);
    if (da < kNear && db < kNear) return;
    if (da < kNear) a = b + (a - b) * ((db - kNear) / (db - da));
    if (db < kNear) b = a + (b - a) * ((da - kNear) / (da - db));
    const auto from = projectPoint(parts.camera, parts.view, a), to = projectPoint(parts.camera, parts.view, b);
    if (from && to) ImGui::GetWindowDrawList()->AddLine(vec(*from), vec(*to), color, width);
}

void lampIcon(ImDrawList& d, ImVec2 c, float r, ImU32 ink) {
    d.AddCircle(c, r * 0.4f, ink, 0, 1.6f);
    for (int i = 0; i < 8; ++i) {
        const float a = static_cast<float>(i) * 0.785398f, x = std::cos(a), y = std::sin(a);
        d.AddLine({c.x + x * r * 0.6f, c.y + y * r * 0.6f}, {c.x + x * r * 0.88f, c.y + y * r * 0.88f}, ink, 1.6f);
    }
}

void cameraIcon(ImDrawList& d, ImVec2 c, float r, ImU32 ink) {
    d.AddRect({c.x - r * 0.7f, c.y - r * 0.4f}, {c.x + r * 0.25f, c.y + r * 0.4f}, ink, 1, 0, 1.6f);
    d.AddTriangleFilled({c.x + r * 0.3f, c.y}, {c.x + r * 0.75f, c.y - r * 0.42f}, {c.x + r * 0.75f, c.y + r * 0.42f},
                        ink);
}

void forceIcon(ImDrawList& d, ImVec2 c, float r, ImU32 ink) {
    d.AddLine({c.x, c.y - r * 0.75f}, {c.x, c.y + r * 0.15f}, ink, 1.8f);
    d.AddTriangleFilled({c.x - r * 0.32f, c.y}, {c.x + r * 0.32f, c.y}, {c.x, c.y + r * 0.42f}, ink);
    d.AddLine({c.x - r * 0.7f, c.y + r * 0.62f}, {c.x + r * 0.7f, c.y + r * 0.62f}, ink, 1.8f);
}

void waterIcon(ImDrawList& d, ImVec2 c, float r, ImU32 ink) {
    for (const float y : {-0.3f, 0.25f})
        d.AddBezierCubic({c.x - r * 0.7f, c.y + y * r}, {c.x - r * 0.2f, c.y + (y - 0.7f) * r},
                         {c.x + r * 0.2f, c.y + (y + 0.7f) * r}, {c.x + r * 0.7f, c.y + y * r}, ink, 1.7f);
}

void drawIcon(const ObjectParts& parts, const Handle& handle, const glm::dvec2& at) {
    ImDrawList& d = *ImGui::GetWindowDrawList();
    const ImVec2 c = vec(at);
    const float r = static_cast<float>(kIcon);
    const bool chosen = isChosen(parts.selection, handle.entity);
    const ImU32 ink = chosen ? IM_COL32(30, 24, 12, 255) : IM_COL32(240, 240, 236, 255);
    d.AddCircleFilled(c, r, chosen ? kChosen : IM_COL32(20, 22, 20, 190));
    d.AddCircle(c, r, chosen ? IM_COL32(60, 40, 10, 255) : IM_COL32(240, 240, 236, 120), 0, 1.2f);
    if (handle.kind == HandleKind::Lamp) lampIcon(d, c, r, ink);
    if (handle.kind == HandleKind::Camera) cameraIcon(d, c, r, ink);
    if (handle.kind == HandleKind::Force) forceIcon(d, c, r, ink);
    if (handle.kind == HandleKind::Water || handle.kind == HandleKind::Pond) waterIcon(d, c, r, ink);
    ui::recordAt("Viewport/Icon " + handle.entity,
                 {ui::Kind::Area, c.x - r, c.y - r, c.x + r, c.y + r, chosen ? "true" : "false"});
}

void drawIcons(const ObjectParts& parts) {
    const Project& p = parts.doc.project();
    for (const Handle& handle : icons(p, parts.doc.ground(), parts.seconds)) {
        const auto at = projectPoint(parts.camera, parts.view, handle.at);
        if (at && within(parts.view, *at) && glm::length(handle.at - parts.camera.eye) > 0.3)
            drawIcon(parts, handle, *at);
    }
}

void recordObject(const ObjectParts& parts, const Ground& ground, const std::string& name) {
    const auto corners = parts.tool.objects.cornersOf(parts.doc.project(), ground, name);
    const auto at = corners ? projectPoint(parts.camera, parts.view, middleOf(*corners)) : std::nullopt;
    if (!at || !within(parts.view, *at)) return;
    const ImVec2 c = vec(*at);
    ui::recordAt("Viewport/Object " + name, {ui::Kind::Area, c.x - 4, c.y - 4, c.x + 4, c.y + 4,
                                             isChosen(parts.selection, name) ? "true" : "false"});
}

void recordObjects(const ObjectParts& parts, const Ground& ground) {
    const Project& p = parts.doc.project();
    size_t count = 0;
    p.registry.each<StaticMesh>([&](Entity, const StaticMesh&) { ++count; });
    if (count > kMostRecorded) {
        for (const std::string& name : parts.selection.entities) recordObject(parts, ground, name);
        return;
    }
    if (!parts.waits) parts.tool.objects.readAhead(p);
    p.registry.each<StaticMesh>([&](Entity e, const StaticMesh& mesh) {
        if (!parts.waits && !parts.tool.objects.hasRead(p, mesh.file)) return;
        if (const Name* name = p.registry.get<Name>(e); name && !p.registry.get<Hidden>(e))
            recordObject(parts, ground, name->value);
    });
}

void drawChoosingBox(const ChoosingBox& box) {
    ImDrawList& d = *ImGui::GetWindowDrawList();
    d.AddRectFilled(vec(glm::min(box.from, box.to)), vec(glm::max(box.from, box.to)), IM_COL32(255, 200, 110, 34));
    d.AddRect(vec(glm::min(box.from, box.to)), vec(glm::max(box.from, box.to)), IM_COL32(255, 200, 110, 230), 0, 0,
              1.4f);
}

bool isBox(const ChoosingBox& box) { return glm::length(box.to - box.from) > kBoxFrom; }

}  // namespace

void drawBox(const ObjectParts& parts, const Corners& c, ImU32 color) {
    constexpr double kBracket = 0.22;  // of an edge
    const ImU32 faint = (color & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 90);
    for (size_t i = 0; i < c.size(); ++i)
        for (const size_t bit : {1u, 2u, 4u}) {
            if (i & bit) continue;
            const glm::dvec3 a = c[i], b = c[i | bit], part = (b - a) * kBracket;
            sceneLine(parts, a, b, faint, 1);
            for (const bool shadow : {true, false}) {
                const ImU32 ink = shadow ? IM_COL32(0, 0, 0, 110) : color;
                sceneLine(parts, a, a + part, ink, shadow ? 3.6f : 1.8f);
                sceneLine(parts, b, b - part, ink, shadow ? 3.6f : 1.8f);
            }
        }
}

std::string entityAt(const ObjectParts& parts, double x, double y) {
    const std::optional<ObjectHit> hit = hitAt(parts, x, y);
    return hit ? hit->entity : "";
}

std::optional<ObjectHit> hitAt(const ObjectParts& parts, double x, double y) {
    constexpr double kNear = 5;  // pixels: thin things, and those with gaps, are hard to hit
    if (!parts.doc.isOpen()) return std::nullopt;
    std::optional<ObjectHit> hit = objectAt(parts, x, y);
    for (int i = 0; i < 8 && !hit; ++i)
        hit = objectAt(parts, x + kNear * std::cos(i * 0.7853981634), y + kNear * std::sin(i * 0.7853981634));
    const std::optional<Handle> icon = iconAt(parts, {x, y});
    if (icon && (!hit || glm::length(icon->at - parts.camera.eye) < hit->distance))
        return ObjectHit{icon->entity, glm::length(icon->at - parts.camera.eye)};
    return hit;
}

std::vector<std::string> entitiesIn(const ObjectParts& parts, const ChoosingBox& box) {
    const Project& p = parts.doc.project();
    const Ground ground = parts.doc.ground();
    const glm::dvec2 low = glm::min(box.from, box.to), high = glm::max(box.from, box.to);
    const auto inside = [&](const glm::dvec3& place) {
        const auto at = projectPoint(parts.camera, parts.view, place);
        return at && at->x >= low.x && at->y >= low.y && at->x <= high.x && at->y <= high.y;
    };
    std::vector<std::string> names;
    p.registry.each<StaticMesh>([&](Entity e, const StaticMesh&) {
        const Name* name = p.registry.get<Name>(e);
        if (!name || p.registry.get<Hidden>(e) || p.registry.get<Locked>(e)) return;
        const auto corners = parts.tool.objects.cornersOf(p, ground, name->value);
        if (corners && inside(middleOf(*corners))) names.push_back(name->value);
    });
    for (const Handle& handle : icons(p, ground, parts.seconds))
        if (inside(handle.at)) names.push_back(handle.entity);
    std::sort(names.begin(), names.end());
    return names;
}

void beginChoosing(const ObjectParts& parts, double x, double y) { parts.tool.box = ChoosingBox{{x, y}, {x, y}}; }

void dragChoosing(const ObjectParts& parts, double x, double y) {
    if (parts.tool.box) parts.tool.box->to = {x, y};
}

void endChoosing(const ObjectParts& parts, const FrameInput& in) {
    const std::optional<ChoosingBox> box = std::exchange(parts.tool.box, std::nullopt);
    if (!box || !parts.doc.isOpen()) return;
    const Choose how = howChosen(in.ctrl(), in.shift());
    if (isBox(*box)) return choose(parts.selection, entitiesIn(parts, *box), how);
    parts.tool.one = hitAt(parts, box->from.x, box->from.y);
    parts.tool.oneRevision = parts.doc.revision();
    if (parts.tool.one) {
        choose(parts.selection, parts.tool.one->entity, how);
        if (parts.tool.one->which.empty())
            parts.tool.one.reset();
        else
            say(parts.messages, parts.tool.one->entity + ": " + parts.tool.one->which);
    } else if (how == Choose::Only) {
        parts.selection.entities.clear();
    }
}

void chooseForMenu(const ObjectParts& parts, double x, double y) {
    const std::string name = entityAt(parts, x, y);
    if (!name.empty() && !isChosen(parts.selection, name)) choose(parts.selection, name);
    parts.tool.menu = true;
}

std::optional<Extent> extentOf(const ObjectParts& parts) {
    const Project& p = parts.doc.project();
    const Ground ground = parts.doc.ground();
    Box all;
    for (const std::string& name : parts.selection.entities) {
        if (const auto corners = parts.tool.objects.cornersOf(p, ground, name))
            for (const glm::dvec3& corner : *corners) all.add(corner);
        else if (const Handle handle = handleOf(p, ground, name, parts.seconds); handle.kind != HandleKind::None)
            all.add(handle.at);
        if (const GroundPath* path = p.registry.get<GroundPath>(findEntity(p, name)))
            for (const PathPoint& point : path->points) {
                const double x = ground.origin.x + point.at.x, z = ground.origin.z + point.at.y;
                all.add({x, groundHeight(ground, x, z), z});
            }
    }
    if (all.low.x > all.high.x) return std::nullopt;
    return Extent{(all.low + all.high) / 2.0, glm::length(all.high - all.low) / 2};
}

// The circle within which a chosen pond's water stands.
void drawPond(const ObjectParts& parts, const Ground& ground, const std::string& name) {
    const Handle handle = handleOf(parts.doc.project(), ground, name, parts.seconds);
    if (handle.kind != HandleKind::Pond) return;
    constexpr int kSides = 72;
    const double radius =
        static_cast<double>(parts.doc.project().registry.get<Water>(findEntity(parts.doc.project(), name))->radius);
    const auto at = [&](int i) {
        const double a = 2 * f64::kPi * i / kSides;
        return handle.at + radius * glm::dvec3(std::cos(a), 0, std::sin(a));
    };
    for (const bool shadow : {true, false})
        for (int i = 0; i < kSides; ++i)
            sceneLine(parts, at(i), at(i + 1), shadow ? IM_COL32(0, 0, 0, 110) : kChosen, shadow ? 3.6f : 1.8f);
}

void drawObjects(const ObjectParts& parts) {
    if (!parts.active) return;
    const Ground ground = parts.doc.ground();
    for (const std::string& name : parts.selection.entities) drawPond(parts, ground, name);
    for (const std::string& name : parts.selection.entities)
        if (const auto corners = parts.tool.objects.cornersOf(parts.doc.project(), ground, name))
            drawBox(parts, *corners, name == shownEntity(parts.selection) ? kChosen : kOthers);
    const std::optional<ObjectHit>& one = parts.tool.one;
    if (one && parts.tool.oneRevision == parts.doc.revision() && isChosen(parts.selection, one->entity))
        drawBox(parts, one->corners, kChosen);
    drawIcons(parts);
    recordObjects(parts, ground);
    if (parts.tool.box && isBox(*parts.tool.box)) drawChoosingBox(*parts.tool.box);
}

}  // namespace sward
