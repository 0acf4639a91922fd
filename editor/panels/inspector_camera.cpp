#include "panels/inspector_camera.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "app/play_control.h"
#include "model/one_step.h"
#include "ui/theme.h"
#include "world/camera_path.h"
#include "world/view_camera.h"

namespace sward {
namespace {

// To a tenth of a millimetre.
std::string vectorText(const glm::dvec3& v) {
    const auto shortly = [](double at) { return ui::numberText(std::round(at * 1e4) / 1e4, false, true); };
    return "[" + shortly(v.x) + ", " + shortly(v.y) + ", " + shortly(v.z) + "]";
}

// Sets eye, target and view angle of what stands at `path` to the view's.
Status takeView(Document& doc, const FlyCamera& from, const std::string& path) {
    const ViewCamera view = viewOf(from);
    if (Status s = doc.setField(path + ".eye", vectorText(view.eye)); !s) return s;
    if (Status s = doc.setField(path + ".target", vectorText(view.target)); !s) return s;
    return doc.setField(path + ".fovDeg", fmt::format("{}", view.fovDeg));
}

void cameraTools(const FieldParts& parts, ViewState& view, const std::string& path, const Camera& camera) {
    if (ui::button(path + "/Look through it")) view.camera = flyFrom(viewOf(camera));
    ui::tooltip("Moves the view to this camera.");
    ImGui::SameLine();
    if (ui::button(path + "/Take the view"))
        deferEdit(parts, [&doc = parts.doc, &from = view.camera, path] {
            return inOneStep(doc, "camera from view", [&] { return takeView(doc, from, path); });
        });
    ui::tooltip("Puts this camera where the view is.");
}

Status addKey(Document& doc, const FlyCamera& from, const std::string& path, double seconds) {
    if (Status s = doc.addListElement(path + ".keys"); !s) return s;
    auto keys = findField(doc.project(), doc.tables().components, path + ".keys");
    if (!keys) return keys.error();
    const std::string key = path + ".keys[" + elementSelectors(*keys->row->list, keys->value).back() + "]";
    if (Status s = doc.setField(key + ".seconds", fmt::format("{}", seconds)); !s) return s;
    return takeView(doc, from, key);
}

constexpr double kSecondsBetweenKeys = 2;

void pathTools(const FieldParts& parts, ViewState& view, const std::string& path, const CameraPath& p) {
    if (ui::button(path + "/Key from view")) {
        const double seconds = p.keys.empty() ? 0 : secondsOf(p) + kSecondsBetweenKeys;
        deferEdit(parts, [&doc = parts.doc, &from = view.camera, path, seconds] {
            return inOneStep(doc, "add a key", [&] { return addKey(doc, from, path, seconds); });
        });
    }
    ui::tooltip("Adds a key where the view is, two seconds after the last.");
    if (p.keys.empty()) return;
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "look from");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    float at = view.pathSecond;
    const double end = std::max(1.0, secondsOf(p));
    const ui::NumberSpec spec{.softMax = end, .hardMin = 0, .hardMax = end, .unit = "s"};
    if (ui::slider(path + "/Second", at, spec))
        view.pathSecond = at, view.camera = flyFrom(viewOf(cameraOn(p, static_cast<double>(at))));
    ui::tooltip("Moves the view along the path.");
}

}  // namespace

void drawCameraTools(const FieldParts& parts, ViewState& view, const std::string& entity, const ComponentRow& row,
                     const void* component) {
    const std::string path = entity + "." + row.name;
    const ui::Disabled walks(playing(parts.doc));
    if (isRowOf<Camera>(row)) cameraTools(parts, view, path, *static_cast<const Camera*>(component));
    if (isRowOf<CameraPath>(row)) pathTools(parts, view, path, *static_cast<const CameraPath*>(component));
}

}  // namespace sward
