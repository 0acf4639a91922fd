// The scene: the renderer's image, the brush's ring, the red bar of the last error.
#include <imgui.h>

#include "panels/overlay_legend.h"
#include "panels/panels.h"
#include "panels/play_bar.h"
#include "panels/viewport_compare.h"
#include "panels/viewport_input.h"
#include "panels/viewport_rings.h"
#include "panels/viewport_scene.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

std::vector<std::string> cameraNames(EditorApp& app) {
    std::vector<std::string> names;
    if (!app.doc.isOpen()) return names;
    for (const auto& [name, entity] : app.doc.project().entities)
        if (app.doc.project().registry.get<Camera>(entity)) names.push_back(name);
    return names;
}

const Camera* cameraNamed(EditorApp& app, const std::string& name) {
    const Entity e = findEntity(app.doc.project(), name);
    return e == kNoEntity ? nullptr : app.doc.project().registry.get<Camera>(e);
}

// The camera whose view is on the screen, or -1.
int cameraShown(EditorApp& app, const std::vector<std::string>& names) {
    const ViewCamera now = viewOf(app.viewport.camera);
    for (size_t i = 0; i < names.size(); ++i) {
        const Camera* c = cameraNamed(app, names[i]);
        const bool same = c && glm::length(c->eye - now.eye) < 1e-4 &&
                          glm::length(glm::normalize(c->target - c->eye) - forwardOf(app.viewport.camera)) < 1e-5;
        if (same) return static_cast<int>(i);
    }
    return -1;
}

void header(EditorApp& app) {
    Viewport& v = app.viewport;
    ImGui::SetCursorPos({8, 3});
    std::vector<std::string> cameras = cameraNames(app);
    int chosen = cameraShown(app, cameras);
    const bool free = chosen < 0;  // the view is no camera's
    if (free) cameras.push_back("free view"), chosen = static_cast<int>(cameras.size()) - 1;
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "Camera");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    const bool moved = [&] {
        const ui::Disabled walks(playing(app));
        return ui::combo("Camera", cameras, chosen);
    }();
    if (moved) goToCamera(app, cameras[static_cast<size_t>(chosen)]);
    ui::tooltip("Moves the view to one of the project's cameras.");
    ImGui::SameLine(0, 18);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "Show");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    const std::vector<std::string> modes(std::begin(kViewModes), std::end(kViewModes));
    int mode = static_cast<int>(v.mode);
    if (ui::combo("Mode", modes, mode)) v.mode = static_cast<ViewMode>(mode);
    ImGui::SameLine(0, 18);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, playing(app) ? "The project stays as it is and cannot be changed until play stops."
                                  : v.gesture == Gesture::Look
                                      ? "W A S D fly, E up, Q down, wheel: speed"
                                      : "Right button: look and fly.  Alt+left: orbit.  F: focus.");
}

void ringAt(EditorApp& app, const Ground& ground, double radius, ImU32 color, float thickness) {
    constexpr int kParts = 64;
    const Viewport& v = app.viewport;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::optional<glm::dvec2> before;
    for (int i = 0; i <= kParts; ++i) {
        const double a = 2 * 3.14159265358979 * i / kParts;
        const double x = v.ground->x + radius * std::cos(a), z = v.ground->z + radius * std::sin(a);
        const double y = ground.origin.y + terrainHeight(*ground.terrain, x - ground.origin.x, z - ground.origin.z);
        const std::optional<glm::dvec2> at = projectPoint(v, {x, y + 0.02, z});
        if (at && before)
            list.AddLine({static_cast<float>(before->x), static_cast<float>(before->y)},
                         {static_cast<float>(at->x), static_cast<float>(at->y)}, color, thickness);
        before = at;
    }
}

// The brush's edge on the ground, and where its full strength ends. Where the scene is slow to draw it stands in for
// the decal: drawn over the image, it follows the pointer at the speed of the interface.
void brushRing(EditorApp& app) {
    const Viewport& v = app.viewport;
    if (!v.ground || app.tierView.hover || app.accuracy.comparison.gripHovered || drawsDecal(app) ||
        app.brushes.tool == kLookTool || (v.gesture != Gesture::None && v.gesture != Gesture::Paint))
        return;
    const Ground ground = findGround(app.doc.project());
    if (!ground.terrain) return;
    const BrushSettings& b = currentBrush(app.brushes);
    const double radius = static_cast<double>(b.radius), inner = radius * (1 - static_cast<double>(b.falloff));
    ringAt(app, ground, radius, IM_COL32(0, 0, 0, 120), 3.5f);
    ringAt(app, ground, radius, IM_COL32(255, 255, 255, 230), 1.6f);
    if (inner > 0 && inner < radius) ringAt(app, ground, inner, IM_COL32(255, 255, 255, 110), 1);
}

void errorBar(EditorApp& app) {
    if (app.notice.empty()) return;
    const Rect& r = app.viewport.rect;
    const float room = r.w - 24, wrap = room - ImGui::GetFontSize() * 7;
    const ImVec2 text = ImGui::CalcTextSize(app.notice.c_str(), nullptr, false, wrap);
    ImGui::SetCursorScreenPos({r.x + 12, r.y + 10});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ui::kErrorBack);
    ImGui::BeginChild("error", {room, std::max(text.y, ImGui::GetFrameHeight()) + 14});
    ImGui::SetCursorPos({10, 7});
    ImGui::PushTextWrapPos(wrap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(app.notice.c_str());
    ImGui::PopTextWrapPos();
    ui::record("Error", ui::Kind::Label, app.notice);
    ImGui::SetCursorPos({room - ImGui::GetFontSize() * 5.2f, 7});
    if (ui::button("Dismiss", ImGui::GetFontSize() * 4.6f)) app.notice.clear();
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

void emptyHint(const Rect& r) {
    const char* text = "No project is open. Ctrl+O opens one, Ctrl+N makes a new one.";
    const ImVec2 size = ImGui::CalcTextSize(text);
    ImGui::GetWindowDrawList()->AddText({r.x + (r.w - size.x) / 2, r.y + (r.h - size.y) / 2}, ui::kDimText, text);
}

}  // namespace

void drawViewport(EditorApp& app) {
    Viewport& v = app.viewport;
    {
        const ui::Disabled noProject(!app.doc.isOpen());
        header(app);
    }
    const float top = ImGui::GetFrameHeight() + 6;
    const Rect& area = app.areas.viewport;
    v.rect = {area.x, area.y + top, area.w, std::max(area.h - top, 1.f)};
    ImGui::SetCursorScreenPos({v.rect.x, v.rect.y});
    const int buttons =
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle;
    ImGui::InvisibleButton("image", {v.rect.w, v.rect.h}, buttons);
    app.book.next["Viewport"] = ui::record("Image", ui::Kind::Area);
    viewportInput(app, ImGui::IsItemHovered());
    if (app.doc.isOpen()) drawScene(app);
    if (app.doc.isOpen() && !playing(app)) followComparison(app);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect({v.rect.x, v.rect.y}, {v.rect.x + v.rect.w, v.rect.y + v.rect.h}, true);
    if (app.doc.isOpen() && v.hasImage) {
        list.AddImage(ui::textureId(v.picture), {v.rect.x, v.rect.y}, {v.rect.x + v.rect.w, v.rect.y + v.rect.h},
                      {0, 1}, {1, 0});
        if (!playing(app)) {
            drawComparison(app);
            brushRing(app);
            drawRings(app);
        }
        drawOverlayLegend(app);
        drawPlayFrame(app);
    } else {
        list.AddRectFilled({v.rect.x, v.rect.y}, {v.rect.x + v.rect.w, v.rect.y + v.rect.h}, IM_COL32(24, 25, 24, 255));
        emptyHint(v.rect);
    }
    list.PopClipRect();
    errorBar(app);
}

}  // namespace sward
