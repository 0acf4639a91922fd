#include "panels/inspector_camera.h"

#include <imgui.h>

#include "app/play_control.h"
#include "ui/theme.h"
#include "world/camera_path.h"
#include "world/view_camera.h"

namespace sward {
namespace {

std::string vectorText(const glm::dvec3& v) { return fmt::format("[{:.4f}, {:.4f}, {:.4f}]", v.x, v.y, v.z); }

// Sets eye, target and view angle of what stands at `path` to the view's.
Status takeView(EditorApp& app, const std::string& path) {
    const ViewCamera view = viewOf(app.viewport.camera);
    if (Status s = app.doc.setField(path + ".eye", vectorText(view.eye)); !s) return s;
    if (Status s = app.doc.setField(path + ".target", vectorText(view.target)); !s) return s;
    return app.doc.setField(path + ".fovDeg", fmt::format("{}", view.fovDeg));
}

Status inOneStep(EditorApp& app, const std::string& label, const std::function<Status()>& edit) {
    app.doc.beginGroup(label);
    Status done = edit();
    app.doc.endGroup();
    return done;
}

void cameraTools(EditorApp& app, const std::string& path, const Camera& camera) {
    if (ui::button(path + "/Look through it")) app.viewport.camera = flyFrom(viewOf(camera));
    ui::tooltip("Moves the view to this camera.");
    ImGui::SameLine();
    if (ui::button(path + "/Take the view"))
        app.deferred.push_back(
            [&app, path] { accept(app, inOneStep(app, "camera from view", [&] { return takeView(app, path); })); });
    ui::tooltip("Puts this camera where the view is.");
}

Status addKey(EditorApp& app, const std::string& path, double seconds) {
    if (Status s = app.doc.addListElement(path + ".keys"); !s) return s;
    auto keys = findField(app.doc.project(), app.doc.tables().components, path + ".keys");
    if (!keys) return keys.error();
    const std::string key = path + ".keys[" + elementSelectors(*keys->row->list, keys->value).back() + "]";
    if (Status s = app.doc.setField(key + ".seconds", fmt::format("{}", seconds)); !s) return s;
    return takeView(app, key);
}

constexpr double kSecondsBetweenKeys = 2;

void pathTools(EditorApp& app, const std::string& path, const CameraPath& p) {
    if (ui::button(path + "/Key from view")) {
        const double seconds = p.keys.empty() ? 0 : secondsOf(p) + kSecondsBetweenKeys;
        app.deferred.push_back([&app, path, seconds] {
            accept(app, inOneStep(app, "add a key", [&] { return addKey(app, path, seconds); }));
        });
    }
    ui::tooltip("Adds a key where the view is, two seconds after the last.");
    if (p.keys.empty()) return;
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "look from");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    float at = app.viewport.pathSecond;
    const double end = std::max(1.0, secondsOf(p));
    const ui::NumberSpec spec{.softMax = end, .hardMin = 0, .hardMax = end, .unit = "s"};
    if (ui::slider(path + "/Second", at, spec))
        app.viewport.pathSecond = at, app.viewport.camera = flyFrom(viewOf(cameraOn(p, static_cast<double>(at))));
    ui::tooltip("Moves the view along the path.");
}

}  // namespace

void drawCameraTools(EditorApp& app, const ComponentRow& row, const void* component) {
    const std::string path = app.selected + "." + row.name;
    const ui::Disabled walks(playing(app));
    if (isRowOf<Camera>(row)) cameraTools(app, path, *static_cast<const Camera*>(component));
    if (isRowOf<CameraPath>(row)) pathTools(app, path, *static_cast<const CameraPath*>(component));
}

}  // namespace sward
