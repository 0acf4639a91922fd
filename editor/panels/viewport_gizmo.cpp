#include "panels/viewport_gizmo.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "panels/viewport_input.h"
#include "ui/widgets.h"

namespace sward {
namespace {

constexpr ImU32 kAxes[] = {IM_COL32(235, 82, 72, 255), IM_COL32(128, 205, 70, 255), IM_COL32(84, 146, 250, 255)};
constexpr ImU32 kPlain = IM_COL32(240, 240, 236, 255), kHot = IM_COL32(255, 222, 80, 255);

std::vector<Handle> handlesOf(const ObjectParts& parts) {
    const Project& p = parts.doc.project();
    return movable(p, parts.doc.ground(), parts.selection.entities, parts.seconds);
}

GizmoView viewOfGizmo(const ObjectParts& parts, const glm::dvec3& pivot) {
    const FlyCamera& c = parts.camera;
    GizmoView view;
    view.eye = c.eye;
    view.forward = forwardOf(c);
    const double depth = std::max(glm::dot(pivot - c.eye, view.forward), 0.05);
    view.metresPerPixel = 2 * depth * std::tan(glm::radians(static_cast<double>(c.fovDeg)) / 2) /
                          std::max(static_cast<double>(parts.view.h), 1.0);
    view.project = [&parts](const glm::dvec3& p) { return projectPoint(parts.camera, parts.view, p); };
    return view;
}

GizmoRay rayAt(const ObjectParts& parts, double x, double y) {
    return {parts.camera.eye, rayThrough(parts.camera, parts.view, x, y)};
}

int axisOf(const GizmoPart& part) { return part.axis.x != 0 ? 0 : part.axis.y != 0 ? 1 : 2; }

ImU32 colorOf(const ObjectParts& parts, const GizmoPart& part) {
    const GizmoPart* held = parts.tool.drag ? parts.tool.drag->grab.part : parts.tool.hover;
    if (held == &part) return kHot;
    return part.axis == glm::dvec3(0) ? kPlain : kAxes[axisOf(part)];
}

void drawLine(const std::vector<glm::dvec2>& line, ImU32 color, float width) {
    ImDrawList& d = *ImGui::GetWindowDrawList();
    std::vector<ImVec2> points;
    for (const glm::dvec2& p : line) points.push_back(vec(p));
    d.AddPolyline(points.data(), static_cast<int>(points.size()), IM_COL32(0, 0, 0, 120), 0, width + 2);
    d.AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, width);
}

void drawArrow(const ScreenPart& s, ImU32 color) {
    drawLine(s.line, color, 3);
    const glm::dvec2 way = glm::normalize(s.line[1] - s.line[0]), side{-way.y, way.x}, tip = s.line[1] + way * 7.0;
    ImGui::GetWindowDrawList()->AddTriangleFilled(vec(tip), vec(tip - way * 15.0 + side * 6.5),
                                                  vec(tip - way * 15.0 - side * 6.5), color);
}

void drawPart(const ObjectParts& parts, const ScreenPart& s) {
    ImDrawList& d = *ImGui::GetWindowDrawList();
    const ImU32 color = colorOf(parts, *s.part);
    switch (s.part->shape) {
        case GizmoShape::Axis:
            return drawArrow(s, color);
        case GizmoShape::Plane:
            d.AddQuadFilled(vec(s.line[0]), vec(s.line[1]), vec(s.line[2]), vec(s.line[3]),
                            (color & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 120));
            return d.AddQuad(vec(s.line[0]), vec(s.line[1]), vec(s.line[2]), vec(s.line[3]), color, 1.4f);
        case GizmoShape::Free:
            d.AddCircleFilled(vec(s.grip), 7, IM_COL32(0, 0, 0, 130));
            return d.AddCircleFilled(vec(s.grip), 5.5f, color);
        case GizmoShape::Ring:
            return drawLine(s.line, color, 3);
        case GizmoShape::Size:
            drawLine(s.line, color, 2.2f);
            d.AddRectFilled({vec(s.grip).x - 6, vec(s.grip).y - 6}, {vec(s.grip).x + 6, vec(s.grip).y + 6},
                            IM_COL32(0, 0, 0, 150));
            return d.AddRectFilled({vec(s.grip).x - 5, vec(s.grip).y - 5}, {vec(s.grip).x + 5, vec(s.grip).y + 5},
                                   color);
    }
}

void recordPart(const ObjectParts& parts, const ScreenPart& s) {
    const std::string value =
        s.part->shape == GizmoShape::Axis ? ui::numberText(parts.tool.pivot[axisOf(*s.part)], false, true) : "";
    const ImVec2 c = vec(s.grip);
    ui::recordAt(fmt::format("Viewport/Gizmo {}", s.part->name),
                 {ui::Kind::Area, c.x - 5, c.y - 5, c.x + 5, c.y + 5, value});
}

// What the drag does, in words at the pointer's side of the picture.
std::string told(const GizmoPart& part, const Motion& m) {
    if (part.mode == GizmoMode::Turn) return fmt::format("{:+.1f}\u00b0", glm::degrees(m.angle));
    if (part.mode == GizmoMode::Scale) return fmt::format("x {:.3g}", m.scale);
    return fmt::format("{:+.2f}  {:+.2f}  {:+.2f} m", m.move.x, m.move.y, m.move.z);
}

std::string labelOf(const GizmoPart& part, const std::vector<Handle>& handles) {
    const char* verb = part.mode == GizmoMode::Turn ? "turn" : part.mode == GizmoMode::Scale ? "scale" : "move";
    if (handles.size() == 1) return fmt::format("{} {}", verb, handles.front().entity);
    return fmt::format("{} {} entities", verb, handles.size());
}

// The middle follows the ground if what is chosen last stands there, or is to.
void takeGround(const ObjectParts& parts, GizmoDrag& drag, const glm::dvec2& pointer) {
    const EntityStart& last = drag.starts.back();
    const bool stands =
        last.handle.kind == HandleKind::Force || (last.handle.kind == HandleKind::Object && last.mesh.onGround);
    const Ground ground = parts.doc.ground();
    if (drag.grab.part->shape != GizmoShape::Free || !ground.terrain || (!stands && !parts.tool.alongGround)) return;
    const glm::dvec3 at = last.handle.at;
    const auto foot = projectPoint(parts.camera, parts.view, {at.x, groundHeight(ground, at.x, at.z), at.z});
    if (!foot) return;
    drag.overGround = true;
    drag.offset = *foot - pointer;
}

// To where the ground is under the hand; on the grid if it snaps. Nothing over the sky.
std::optional<Motion> motionOverGround(const ObjectParts& parts, const GizmoDrag& drag, double x, double y,
                                       const GizmoSteps* steps) {
    const auto ground = groundAt(parts.doc, parts.camera, parts.view, x + drag.offset.x, y + drag.offset.y);
    if (!ground) return std::nullopt;
    glm::dvec3 to = *ground;
    if (steps) to = {snapped(to.x, double(steps->grid)), to.y, snapped(to.z, double(steps->grid))};
    Motion m;
    m.pivot = drag.grab.pivot;
    m.move = {to.x - m.pivot.x, 0, to.z - m.pivot.z};
    m.alongGround = true;
    return m;
}

void apply(const ObjectParts& parts, const GizmoDrag& drag, const Motion& motion) {
    const Ground ground = parts.doc.ground();
    for (const EntityStart& start : drag.starts)
        for (const auto& [path, text] : movedFields(start, motion, ground))
            if (!accept(parts.messages, parts.doc.setField(path, text))) return;
}

// Objects may stand at the origin without a Transform; moved, they need one.
bool giveTransforms(const ObjectParts& parts, const std::vector<EntityStart>& starts) {
    const Project& p = parts.doc.project();
    for (const EntityStart& s : starts) {
        const std::string& name = s.handle.entity;
        if (!movesTransform(s.handle.kind) || p.registry.get<Transform>(findEntity(p, name))) continue;
        if (!accept(parts.messages, parts.doc.addComponent(name, "Transform"))) return false;
    }
    return true;
}

}  // namespace

void hoverGizmo(const ObjectParts& parts, const FrameInput& in, bool free) {
    parts.tool.hover = nullptr;
    if (!free || !parts.active) return;
    if (const ScreenPart* s = partAt(parts.tool.shown, {in.x, in.y})) parts.tool.hover = s->part;
}

void drawGizmo(const ObjectParts& parts) {
    ObjectTool& t = parts.tool;
    t.shown.clear();
    if (!parts.active || t.mode == GizmoMode::Select || t.mode == GizmoMode::Path || !t.placing.empty()) return;
    const std::vector<Handle> handles = handlesOf(parts);
    if (handles.empty()) return;
    std::vector<HandleKind> kinds;
    for (const Handle& h : handles) kinds.push_back(h.kind);
    t.pivot = handles.back().at;
    if (glm::dot(t.pivot - parts.camera.eye, forwardOf(parts.camera)) < 0.05) return;
    t.shown = screenParts(t.mode, kinds, t.pivot, viewOfGizmo(parts, t.pivot));
    for (size_t i = t.shown.size(); i-- > 0;) drawPart(parts, t.shown[i]);  // the first are the first to be meant
    for (const ScreenPart& s : t.shown) recordPart(parts, s);
}

bool grabGizmo(const ObjectParts& parts, const FrameInput& in) {
    ObjectTool& t = parts.tool;
    const ScreenPart* s = parts.active ? partAt(t.shown, {in.x, in.y}) : nullptr;
    const std::vector<Handle> handles = handlesOf(parts);
    if (!s || handles.empty()) return false;
    GizmoDrag drag;
    drag.grab = grabPart(*s, t.pivot, viewOfGizmo(parts, t.pivot), {in.x, in.y}, rayAt(parts, in.x, in.y));
    for (const Handle& h : handles) drag.starts.push_back(startOf(parts.doc.project(), h));
    takeGround(parts, drag, {in.x, in.y});
    const std::string label = labelOf(*s->part, handles);
    parts.doc.beginGroup(label);
    parts.edits.holding = label;
    t.drag = std::move(drag);
    return true;
}

void dragGizmo(const ObjectParts& parts, double x, double y, bool snap) {
    ObjectTool& t = parts.tool;
    if (!t.drag) return;
    GizmoDrag& drag = *t.drag;
    if (!drag.moved && glm::length(glm::dvec2(x, y) - drag.grab.pointer) < kFirstMotion) return;
    if (!drag.moved && !giveTransforms(parts, drag.starts)) return;
    drag.moved = true;
    const GizmoSteps* steps = snap ? &t.steps : nullptr;
    std::optional<Motion> motion = drag.overGround ? motionOverGround(parts, drag, x, y, steps)
                                                   : motionOf(drag.grab, {x, y}, rayAt(parts, x, y), steps);
    if (!motion) return;
    motion->alongGround |= t.alongGround;
    apply(parts, drag, *motion);
    parts.messages.status = labelOf(*drag.grab.part, handlesOf(parts)) + "  " + told(*drag.grab.part, *motion);
}

void releaseGizmo(const ObjectParts& parts) { parts.tool.drag.reset(); }

void cancelGizmo(const ObjectParts& parts) {
    parts.tool.drag.reset();
    if (parts.edits.holding.empty()) return;
    parts.edits.holding.clear();
    parts.doc.cancelGroup();
    say(parts.messages, "everything is back where it was");
}

}  // namespace sward
