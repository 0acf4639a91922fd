// The accepted pictures of cameras: each one's verdict, and of the one that is looked at the picture now, the accepted
// one and where they differ.
#include <fmt/format.h>
#include <imgui.h>

#include "app/edits.h"
#include "app/picture_run.h"
#include "panels/panels.h"
#include "panels/picture_strip.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

void controls(PictureRun& run, const Document& doc, Messages& messages) {
    if (checking(run)) {
        if (ui::button("Stop")) stopPictures(run);
        ImGui::SameLine(0, 8);
        return ui::coloredText(ui::kDimText,
                               fmt::format("drawing {} of {}", run.results.size() + 1, run.asked).c_str());
    }
    const std::vector<std::string> cameras = picturesOf(doc.project());
    {
        const ui::Disabled none(cameras.empty());
        if (ui::button("Check Pictures")) startPictures(run, doc, messages);
    }
    ui::tooltip("Draws each camera's accepted picture anew and judges it by the tolerances of its AcceptedPicture.");
    ImGui::SameLine(0, 8);
    ui::coloredText(ui::kDimText, cameras.empty()
                                      ? "No camera has an accepted picture: choose one, then menu Test, Accept Picture."
                                  : run.results.empty()            ? fmt::format("{} accepted", cameras.size()).c_str()
                                  : run.revision != doc.revision() ? "the project has changed since"
                                                                   : "");
}

void resultRow(const PictureParts& p, const PictureResult& r) {
    const ui::Scope scope(r.camera);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(r.pass() ? ui::kAccent : ui::kErrorText));
    if (ui::selectable(r.camera, p.run.shown == r.camera))
        p.edits.deferred.push_back([&run = p.run, camera = r.camera] { showResult(run, camera); });
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    const std::string text = resultText(r);
    ImGui::TextUnformatted(text.c_str());
    ui::record("Verdict", ui::Kind::Label, text);
    ui::tooltip(text);
    ImGui::TableNextColumn();
    if (r.pass()) return;
    if (ui::button("Accept"))
        p.edits.deferred.push_back([run = &p.run, doc = &p.doc, gpu = &p.gpu, messages = &p.messages,
                                    camera = r.camera] { acceptNow(*run, *doc, *gpu, *messages, camera); });
    ui::tooltip("This picture, as the project is now, becomes the accepted one: one undo step.");
}

void list(const PictureParts& p) {
    if (!ImGui::BeginTable("results", 3)) return;
    const float em = ImGui::GetFontSize();
    ImGui::TableSetupColumn("camera", ImGuiTableColumnFlags_WidthFixed, em * 7);
    ImGui::TableSetupColumn("verdict");
    ImGui::TableSetupColumn("accept", ImGuiTableColumnFlags_WidthFixed, em * 4);
    for (const PictureResult& r : p.run.results) resultRow(p, r);
    ImGui::EndTable();
}

}  // namespace

void drawPictures(const PictureParts& p) {
    if (!p.doc.isOpen()) return ImGui::TextDisabled("No project is open.");
    controls(p.run, p.doc, p.messages);
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::BeginChild("list", {p.run.shown.empty() ? 0.f : width * 0.42f, 0});
    list(p);
    ImGui::EndChild();
    if (p.run.shown.empty()) return;
    ImGui::SameLine();
    ImGui::BeginChild("strip");
    drawStrip({{{"now", &p.run.now}, {"accepted", &p.run.accepted}, {"difference", &p.run.difference}}});
    ImGui::EndChild();
}

}  // namespace sward
