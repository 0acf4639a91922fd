// One line: how many blades, what a frame costs, how fine the viewport is drawn, unsaved work, the last message.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/background_work.h"
#include "app/viewport.h"
#include "panels/panels.h"
#include "tools/brush_cost.h"
#include "ui/theme.h"
#include "ui/widgets.h"
#include "ui/words.h"

namespace sward {
namespace {

void item(const char* label, const std::string& text, const char* help) {
    ui::coloredText(ui::kDimText, label);
    ImGui::SameLine(0, 5);
    ImGui::TextUnformatted(text.c_str());
    ui::record(label, ui::Kind::Label, text);
    ui::tooltip(help);
    ImGui::SameLine(0, 18);
}

void savedDot(const Document& doc) {
    const bool dirty = doc.isOpen() && doc.dirty();
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (dirty)
        ImGui::GetWindowDrawList()->AddCircleFilled({at.x + size / 2, at.y + size / 2}, size * 0.25f, ui::kWarningText);
    ImGui::Dummy({dirty ? size : 0, size});
    ImGui::SameLine(0, 4);
    ImGui::TextUnformatted(!doc.isOpen() ? "no project" : dirty ? "unsaved" : "saved");
    ui::record("Saved", ui::Kind::Label, dirty ? "false" : "true");
    ImGui::SameLine(0, 18);
}

void bakeProgress(std::optional<OcclusionBake>& bake) {
    if (!bake) return;
    const float share = static_cast<float>(bake->job.progress());
    item("Baking", fmt::format("{:.0f} %", 100 * share),
         "Rays are cast from the ground to see how much of the sky is open; the map comes as one undo step.");
    ImGui::ProgressBar(share, {120, ImGui::GetTextLineHeight()}, "");
    ImGui::SameLine(0, 5);
    if (ui::button("Cancel")) bake->job.cancel();
    ImGui::SameLine(0, 18);
}

void exportProgress(std::optional<SceneExport>& exporting) {
    if (!exporting) return;
    item("Exporting", fmt::format("{:.0f} %", 100 * exporting->job.progress()),
         "The scene is written to a .glb; what is edited meanwhile does not come into it.");
    if (ui::button("Cancel Export")) exporting->job.cancel();
    ImGui::SameLine(0, 18);
}

// Slices of changed blades: drafts are on the screen until they are there.
void making(const std::vector<JobNews>& jobs) {
    for (const JobNews& j : jobs)
        item("Making", fmt::format("{} {:.0f} %", j.label, 100 * j.progress), "Shown as a draft until it is done.");
}

// "+8.1 k", "-120", or both; "+0" if nothing came or went.
std::string changeText(const BladeChange& c) {
    const auto added = static_cast<uint64_t>(std::llround(c.added)),
               removed = static_cast<uint64_t>(std::llround(c.removed));
    std::string text = added > 0 || removed == 0 ? "+" + counted(added) : "";
    if (removed > 0) text += (text.empty() ? "-" : " -") + counted(removed);
    return text;
}

// What painting adds, while it is done.
void painting(const BrushCost& c, uint64_t bladesInView) {
    if (c.under)
        item("Under brush", counted(static_cast<uint64_t>(std::llround(*c.under))) + " blades",
             "Blades of this species that grow within the brush's ring.");
    if (!c.stroke) return;
    const std::optional<double> ms = strokeMs(c, bladesInView);
    item("Stroke", changeText(*c.stroke) + " blades" + (ms ? fmt::format(", about {:+.2g} ms", *ms) : ""),
         ms ? "What the stroke added or took, and about what that costs a frame: the measured grass, times the share "
              "by which its blades grow."
            : "What the stroke added or took. With Measure on (Profiler) also what it costs a frame.");
}

}  // namespace

std::string counted(uint64_t n) {
    const double v = static_cast<double>(n);
    if (v >= 1e9) return fmt::format("{:.3g} G", v / 1e9);
    if (v >= 1e6) return fmt::format("{:.3g} M", v / 1e6);
    if (v >= 1e4) return fmt::format("{:.3g} k", v / 1e3);
    return fmt::format("{}", n);
}

void drawStatusBar(const Document& doc, const ViewCounts& counts, double drawnScale, const BrushCost& cost,
                   BackgroundWork& work, const std::string& message) {
    const FrameStats& s = counts.stats;
    ImGui::SetCursorPosY(5);
    item("Blades", counted(static_cast<uint64_t>(counts.bladesVirtual)),
         "All blades of the fields: density summed over the terrain.");
    item("Geometry", counted(s.bladesGeometry), "Blades handed to the GPU in this view.");
    if (counts.bladesVisible > 0) item("Visible", counted(counts.bladesVisible), "Blades of those that can be seen.");
    item("Frame",
         counts.lastMs < 1000 ? fmt::format("{:.3g} ms", counts.lastMs) : fmt::format("{:.1f} s", counts.lastMs / 1000),
         "What the last drawing of the viewport took.");
    item("Resolution", fmt::format("{:.0f} %", 100 * std::min(1.0, drawnScale + 0.001)),
         "On a slow machine the viewport is drawn coarser while something moves, and in full at rest.");
    painting(cost, s.bladesGeometry);
    savedDot(doc);
    bakeProgress(work.occlusion);
    exportProgress(work.exporting);
    making(work.making);
    ui::coloredText(ui::kDimText, ui::inWords(message).c_str());
    ui::record("Message", ui::Kind::Label, message);
    ui::tooltip(message);
}

}  // namespace sward
