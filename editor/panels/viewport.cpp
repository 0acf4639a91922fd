#include "panels/viewport.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/play_control.h"
#include "panels/viewport_input.h"
#include "ui/theme.h"
#include "ui/widgets.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

std::vector<std::string> cameraNames(const Document& doc) {
    std::vector<std::string> names;
    if (!doc.isOpen()) return names;
    for (const auto& [name, entity] : doc.project().entities)
        if (doc.project().registry.get<Camera>(entity)) names.push_back(name);
    return names;
}

const Camera* cameraNamed(const Document& doc, const std::string& name) {
    const Entity e = findEntity(doc.project(), name);
    return e == kNoEntity ? nullptr : doc.project().registry.get<Camera>(e);
}

// The camera whose view is on the screen, or -1.
int cameraShown(const Document& doc, const FlyCamera& view, const std::vector<std::string>& names) {
    const ViewCamera now = viewOf(view);
    for (size_t i = 0; i < names.size(); ++i) {
        const Camera* c = cameraNamed(doc, names[i]);
        const bool same = c && glm::length(c->eye - now.eye) < 1e-4 &&
                          glm::length(glm::normalize(c->target - c->eye) - forwardOf(view)) < 1e-5;
        if (same) return static_cast<int>(i);
    }
    return -1;
}

void chooseCamera(const Document& doc, FlyCamera& view) {
    std::vector<std::string> cameras = cameraNames(doc);
    int chosen = cameraShown(doc, view, cameras);
    const bool free = chosen < 0;  // the view is no camera's
    if (free) cameras.push_back("free view"), chosen = static_cast<int>(cameras.size()) - 1;
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "Camera");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    const bool moved = [&] {
        const ui::Disabled walks(playing(doc));
        return ui::combo("Camera", cameras, chosen);
    }();
    if (moved) goToCamera(doc, cameras[static_cast<size_t>(chosen)], view);
    ui::tooltip("Moves the view to one of the project's cameras.");
}

// Around a point of the ground, draped over it.
void ringAt(const FlyCamera& camera, const Rect& view, const Ground& ground, const glm::dvec3& centre, double radius,
            ImU32 color, float thickness) {
    constexpr int kParts = 64;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::optional<glm::dvec2> before;
    for (int i = 0; i <= kParts; ++i) {
        const double a = 2 * 3.14159265358979 * i / kParts;
        const double x = centre.x + radius * std::cos(a), z = centre.z + radius * std::sin(a);
        const double y = ground.origin.y + terrainHeight(*ground.terrain, x - ground.origin.x, z - ground.origin.z);
        const std::optional<glm::dvec2> at = projectPoint(camera, view, {x, y + 0.02, z});
        if (at && before)
            list.AddLine({static_cast<float>(before->x), static_cast<float>(before->y)},
                         {static_cast<float>(at->x), static_cast<float>(at->y)}, color, thickness);
        before = at;
    }
}

}  // namespace

void drawViewportHeader(const Document& document, ViewState& view, Gesture gesture) {
    ImGui::SetCursorPos({8, 3});
    chooseCamera(document, view.camera);
    ImGui::SameLine(0, 18);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "Show");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    const std::vector<std::string> modes(std::begin(kViewModes), std::end(kViewModes));
    int mode = static_cast<int>(view.mode);
    if (ui::combo("Mode", modes, mode)) view.mode = static_cast<ViewMode>(mode);
    ImGui::SameLine(0, 18);
    ImGui::AlignTextToFramePadding();
    const char* hint = playing(document) ? "The project stays as it is and cannot be changed until play stops."
                       : gesture == Gesture::Look
                           ? "W A S D fly, E up, Q down, wheel: speed"
                           : "Right button: look and fly.  Alt+left: orbit.  F: focus.  V: objects or brush.";
    const bool fits = ImGui::CalcTextSize(hint).x <= ImGui::GetContentRegionAvail().x;
    ui::coloredText(ui::kDimText, fits ? hint : "");  // half a sentence helps nobody
}

Rect layImage(const Rect& area) {
    const float top = ImGui::GetFrameHeight() + 6;
    const Rect image{area.x, area.y + top, area.w, std::max(area.h - top, 1.f)};
    ImGui::SetCursorScreenPos({image.x, image.y});
    const int buttons =
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle;
    ImGui::InvisibleButton("image", {image.w, image.h}, buttons);
    ui::recordAt("Viewport", ui::record("Image", ui::Kind::Area));
    return image;
}

void drawBrushRing(const Document& document, const FlyCamera& camera, const ViewportHand& hand, BrushBook& brushes) {
    if (!hand.ground || brushes.tool == kViewTool || (hand.gesture != Gesture::None && hand.gesture != Gesture::Paint))
        return;
    const Ground ground = document.ground();
    if (!ground.terrain) return;
    const BrushSettings& b = currentBrush(brushes);
    const double radius = static_cast<double>(b.radius), inner = radius * (1 - static_cast<double>(b.falloff));
    const auto ring = [&](double at, ImU32 color, float thickness) {
        ringAt(camera, hand.rect, ground, *hand.ground, at, color, thickness);
    };
    ring(radius, IM_COL32(0, 0, 0, 120), 3.5f);
    ring(radius, IM_COL32(255, 255, 255, 230), 1.6f);
    if (!b.shape && inner > 0 && inner < radius) ring(inner, IM_COL32(255, 255, 255, 110), 1);
    const BrushRow* row = findBrush(b.mode);
    if (!row || !row->spans || hand.gesture != Gesture::Paint || !hand.strokeBegin) return;
    ringAt(camera, hand.rect, ground, *hand.strokeBegin, radius, IM_COL32(255, 255, 255, 230), 1.6f);
    const auto from = projectPoint(camera, hand.rect, *hand.strokeBegin),
               to = projectPoint(camera, hand.rect, *hand.ground);
    if (from && to)
        ImGui::GetWindowDrawList()->AddLine({static_cast<float>(from->x), static_cast<float>(from->y)},
                                            {static_cast<float>(to->x), static_cast<float>(to->y)},
                                            IM_COL32(255, 255, 255, 230), 1.6f);
}

void drawErrorBar(std::string& notice, const Rect& r) {
    if (notice.empty()) return;
    const float room = r.w - 24, wrap = room - ImGui::GetFontSize() * 7;
    const ImVec2 text = ImGui::CalcTextSize(notice.c_str(), nullptr, false, wrap);
    ImGui::SetCursorScreenPos({r.x + 12, r.y + 10});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ui::kErrorBack);
    ImGui::BeginChild("error", {room, std::max(text.y, ImGui::GetFrameHeight()) + 14});
    ImGui::SetCursorPos({10, 7});
    ImGui::PushTextWrapPos(wrap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(notice.c_str());
    ImGui::PopTextWrapPos();
    ui::record("Error", ui::Kind::Label, notice);
    ImGui::SetCursorPos({room - ImGui::GetFontSize() * 5.2f, 7});
    if (ui::button("Dismiss", ImGui::GetFontSize() * 4.6f)) notice.clear();
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

}  // namespace sward
