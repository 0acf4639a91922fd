#include "panels/viewport_shape.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "brushes/shape.h"
#include "panels/viewport_input.h"
#include "ui/widgets.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr int kVeilParts = 24, kGridParts = 40, kLineParts = 96;
constexpr ImU32 kMirrorColor = IM_COL32(255, 190, 60, 220), kGridColor = IM_COL32(120, 220, 255, 200);

// What drapes lines over the ground.
struct Drape {
    const FlyCamera& camera;
    const Rect& view;
    Ground ground;

    double heightAt(double x, double z) const { return terrainHeight(*ground.terrain, x, z); }
    // Of a place on the terrain, `y` metres high.
    std::optional<ImVec2> project(double x, double y, double z) const {
        const auto at = projectPoint(camera, view, ground.origin + glm::dvec3(x, y + 0.02, z));
        if (!at) return {};
        return ImVec2(static_cast<float>(at->x), static_cast<float>(at->y));
    }
    // height(x, z): metres.
    template <class Height>
    void line(const glm::dvec2& from, const glm::dvec2& to, int parts, ImU32 color, float thickness,
              const Height& height) const {
        std::optional<ImVec2> before;
        for (int i = 0; i <= parts; ++i) {
            const glm::dvec2 p = from + (to - from) * (static_cast<double>(i) / parts);
            const std::optional<ImVec2> at = project(p.x, height(p.x, p.y), p.y);
            if (at && before) ImGui::GetWindowDrawList()->AddLine(*before, *at, color, thickness);
            before = at;
        }
    }
    void overGround(const glm::dvec2& from, const glm::dvec2& to, ImU32 color, float thickness) const {
        line(from, to, kLineParts, color, thickness, [&](double x, double z) { return heightAt(x, z); });
    }
};

bool brushInHand(const ViewportHand& hand, const BrushBook& brushes) {
    return brushes.tool != kViewTool && (hand.gesture == Gesture::None || hand.gesture == Gesture::Paint);
}

// Of the shape under the pointer; along the stroke while there is one.
double angleShown(const BrushSettings& b, const ViewportHand& hand) {
    const double fixed = glm::radians(static_cast<double>(b.shapeAngleDeg));
    if (b.shapeTurn != ShapeTurn::Along || hand.gesture != Gesture::Paint || !hand.strokeBegin) return fixed;
    const glm::dvec3 way = *hand.ground - *hand.strokeBegin;
    return std::hypot(way.x, way.z) > 0.01 ? fixed + std::atan2(way.x, -way.z) : fixed;
}

}  // namespace

void drawBrushShape(const Document& doc, const FlyCamera& camera, const ViewportHand& hand, BrushBook& brushes) {
    if (!hand.ground || !brushInHand(hand, brushes)) return;
    const BrushSettings& b = currentBrush(brushes);
    const Ground ground = doc.ground();
    if (!b.shape || b.mode == "ramp" || !ground.terrain) return;
    const Drape drape{camera, hand.rect, ground};
    const glm::dvec3 middle = *hand.ground - ground.origin;
    const double angle = angleShown(b, hand), c = std::cos(angle), s = std::sin(angle),
                 radius = static_cast<double>(b.radius);
    const auto corner = [&](int i, int j) {
        const double x = 2.0 * i / kVeilParts - 1, y = 2.0 * j / kVeilParts - 1;
        const double px = middle.x + radius * (c * x - s * y), pz = middle.z + radius * (s * x + c * y);
        return drape.project(px, drape.heightAt(px, pz), pz);
    };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int j = 0; j < kVeilParts; ++j)
        for (int i = 0; i < kVeilParts; ++i) {
            const float light = shapeLight(*b.shape, (2 * static_cast<float>(i) + 1) / kVeilParts - 1,
                                           (2 * static_cast<float>(j) + 1) / kVeilParts - 1);
            const auto p = corner(i, j), q = corner(i + 1, j), r = corner(i + 1, j + 1), t = corner(i, j + 1);
            if (light < 0.02f || !p || !q || !r || !t) continue;
            list.AddQuadFilled(*p, *q, *r, *t, IM_COL32(255, 255, 255, static_cast<int>(150 * light)));
        }
    ui::Widget area;
    area.kind = ui::Kind::Area;
    area.value = b.shape->name;
    ui::recordAt("Viewport/Brush shape", area);
}

void drawMirror(const Document& doc, const FlyCamera& camera, const ViewportHand& hand, const BrushBook& brushes) {
    if (!brushInHand(hand, brushes) || !(brushes.mirrorX || brushes.mirrorZ)) return;
    const Ground ground = doc.ground();
    if (!ground.terrain) return;
    const Drape drape{camera, hand.rect, ground};
    const glm::dvec2 size = ground.terrain->size, middle = size / 2.0;
    if (brushes.mirrorX) drape.overGround({middle.x, 0}, {middle.x, size.y}, kMirrorColor, 2);
    if (brushes.mirrorZ) drape.overGround({0, middle.y}, {size.x, middle.y}, kMirrorColor, 2);
    ui::Widget area;
    area.kind = ui::Kind::Area;
    ui::recordAt("Viewport/Mirror", area);
    if (!hand.ground) return;
    const glm::dvec3 at = *hand.ground - ground.origin;
    for (int image = 1; image < 4; ++image) {
        const bool x = image & 1, z = image & 2;
        if ((x && !brushes.mirrorX) || (z && !brushes.mirrorZ)) continue;
        const double px = x ? size.x - at.x : at.x, pz = z ? size.y - at.z : at.z;
        if (const auto p = drape.project(px, drape.heightAt(px, pz), pz))
            ImGui::GetWindowDrawList()->AddCircle(*p, 5, kMirrorColor, 0, 2);
    }
}

void drawPlacedHeights(const Document& doc, const FlyCamera& camera, const Rect& view, const Map& source,
                       const HeightPlace& place) {
    const Ground ground = doc.ground();
    if (!ground.terrain || source.empty() || !(place.size.x > 0 && place.size.y > 0)) return;
    const Drape drape{camera, view, ground};
    const glm::dvec2 a = place.at, b = place.at + place.size;
    const double cell = std::max(place.size.x, place.size.y) / kGridParts;
    const auto placed = [&](double x, double z) {
        return placedHeight(source, place, x, z, drape.heightAt(x, z), cell);
    };
    for (int i = 1; i < kGridParts; ++i) {
        const glm::dvec2 p = a + (b - a) * (static_cast<double>(i) / kGridParts);
        drape.line({p.x, a.y}, {p.x, b.y}, kGridParts, kGridColor, 1, placed);
        drape.line({a.x, p.y}, {b.x, p.y}, kGridParts, kGridColor, 1, placed);
    }
    const glm::dvec2 corners[] = {a, {b.x, a.y}, b, {a.x, b.y}};
    for (int i = 0; i < 4; ++i) drape.overGround(corners[i], corners[(i + 1) % 4], kMirrorColor, 2);
}

}  // namespace sward
