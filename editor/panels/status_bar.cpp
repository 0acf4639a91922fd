// One line: how many blades, what a frame costs, how fine the viewport is drawn, unsaved work, the last message.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/background_work.h"
#include "app/stroke_timing.h"
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

// "40 %, 1:20 left".
std::string progressText(double share, double seconds) {
    const std::string left = timeLeft(share, seconds);
    return fmt::format("{:.0f} %{}{}", 100 * share, left.empty() ? "" : ", ", left);
}

void bakeProgress(std::optional<OcclusionBake>& bake, Stopwatch& since) {
    const double seconds = since.of(bake.has_value());
    if (!bake) return;
    const double share = bake->job.progress();
    item("Baking", progressText(share, seconds),
         "Rays are cast from the ground to see how much of the sky is open; the map comes as one undo step.");
    ImGui::ProgressBar(static_cast<float>(share), {ImGui::GetFontSize() * 8, ImGui::GetTextLineHeight()}, "");
    ImGui::SameLine(0, 5);
    if (ui::button("Cancel")) bake->job.cancel();
    ImGui::SameLine(0, 18);
}

void exportProgress(std::optional<SceneExport>& exporting, Stopwatch& since) {
    const double seconds = since.of(exporting.has_value());
    if (!exporting) return;
    item("Exporting", progressText(exporting->job.progress(), seconds),
         "The scene is written to a .glb; what is edited meanwhile does not come into it.");
    if (ui::button("Cancel Export")) exporting->job.cancel(), exporting->cancelled = true;
    ImGui::SameLine(0, 18);
}

void filmProgress(std::unique_ptr<Film>& film) {
    if (!film) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - film->begun).count();
    const std::string left = timeLeft(shareOf(*film), seconds);
    item("Filming",
         fmt::format("{} of {}{}{}", std::min(film->done + 1, film->frames), film->frames, left.empty() ? "" : ", ",
                     left),
         "Pictures are drawn of the project as it was; what is edited meanwhile does not come into them.");
    if (ui::button("Cancel Film")) film.reset();
    ImGui::SameLine(0, 18);
}

// Slices of changed blades: drafts are on the screen until they are there.
void making(const std::vector<JobNews>& jobs, Stopwatch& since) {
    const double seconds = since.of(!jobs.empty());
    for (const JobNews& j : jobs)
        item("Making", j.label + " " + progressText(j.progress, jobs.size() == 1 ? seconds : 0),
             "Shown as a draft until it is done.");
}

// "+8.1 k", "-120", or both; "+0" if nothing came or went.
std::string changeText(const BladeChange& c) {
    const auto added = static_cast<uint64_t>(std::llround(c.added)),
               removed = static_cast<uint64_t>(std::llround(c.removed));
    std::string text = added > 0 || removed == 0 ? "+" + counted(added) : "";
    if (removed > 0) text += (text.empty() ? "-" : " -") + counted(removed);
    return text;
}

// What the stroke costs, measured.
void measuredStroke(const std::string& blades, const StrokeTiming& t) {
    item("Stroke", blades + (blades.empty() ? "" : ", ") + differenceText(*t.ms, true),
         fmt::format("What the stroke added or took, and what it costs a frame of this view: the median of {} pairs of "
                     "frames with and without it at {} x {},\nand in brackets between what it lies with {:.0f} %. "
                     "Blades drawn in them: {:+.0f}. Brush > Time Strokes turns this off.",
                     t.ms->pairs, t.settings.width, t.settings.height, 100 * t.ms->confidence, t.blades->median)
             .c_str());
}

// What painting adds, while it is done.
void painting(const BrushCost& c, const StrokeTiming& timing, uint64_t bladesInView) {
    if (c.under)
        item("Under brush", counted(static_cast<uint64_t>(std::llround(*c.under))) + " blades",
             "Blades of this species that grow within the brush's ring.");
    if (timing.ms) return measuredStroke(c.stroke ? changeText(*c.stroke) + " blades" : "", timing);
    if (!c.stroke) return;
    const std::optional<double> ms = strokeMs(c, bladesInView);
    item(
        "Stroke", changeText(*c.stroke) + " blades" + (ms ? fmt::format(", about {:+.2g} ms", *ms) : ""),
        ms ? "What the stroke added or took, and about what that costs a frame: the measured grass, times the share "
             "by which its blades grow."
           : "What the stroke added or took. What it costs a frame is measured once all rests (Brush > Time Strokes).");
}

}  // namespace

std::string counted(uint64_t n) {
    const double v = static_cast<double>(n);
    if (v >= 1e9) return fmt::format("{:.3g} G", v / 1e9);
    if (v >= 1e6) return fmt::format("{:.3g} M", v / 1e6);
    if (v >= 1e4) return fmt::format("{:.3g} k", v / 1e3);
    return fmt::format("{}", n);
}

namespace {

struct Figure {
    const char* label;
    std::string text;
    const char* help;
    int rank;  // the highest goes first where all do not find room
};

float widthOf(const Figure& f) {
    return ImGui::CalcTextSize(f.label).x + 5 + ImGui::CalcTextSize(f.text.c_str()).x + 18;
}

std::vector<Figure> figuresOf(const ViewCounts& counts, double drawnScale) {
    const FrameStats& s = counts.stats;
    std::vector<Figure> out;
    const bool known = counts.populationRevision != kNeverDrawn;
    out.push_back({"Blades", known ? counted(static_cast<uint64_t>(counts.bladesVirtual)) : "...",
                   known ? "All blades of the fields: density summed over the terrain."
                         : "All blades of the fields; they are counted as soon as the picture rests.",
                   1});
    out.push_back({"Geometry", counted(s.bladesGeometry), "Blades handed to the GPU in this view.", 3});
    if (counts.bladesVisible > 0)
        out.push_back({"Visible", counted(counts.bladesVisible), "Blades of those that can be seen.", 2});
    out.push_back(
        {"Frame",
         counts.lastMs < 1000 ? fmt::format("{:.3g} ms", counts.lastMs) : fmt::format("{:.1f} s", counts.lastMs / 1000),
         "What the last drawing of the viewport took.", 0});
    out.push_back({"Resolution", fmt::format("{:.0f} %", 100 * std::min(1.0, drawnScale + 0.001)),
                   "On a slow machine the viewport is drawn coarser while something moves, and in full at rest.", 4});
    return out;
}

// What finds no room is not drawn; scripts find it all the same.
void figures(std::vector<Figure> all, float room) {
    float width = 0;
    for (const Figure& f : all) width += widthOf(f);
    int rank = 5;
    while (width > room && rank > 1) {
        --rank;
        for (const Figure& f : all)
            if (f.rank == rank) width -= widthOf(f);
    }
    for (const Figure& f : all) {
        if (f.rank < rank) {
            item(f.label, f.text, f.help);
            continue;
        }
        ui::record(f.label, ui::Kind::Label, f.text).visible = false;
    }
}

// The last message, with dots where it is cut; the tooltip has all of it.
void messageLine(const std::string& message) {
    std::string text = ui::inWords(message);
    const float room = ImGui::GetContentRegionAvail().x;
    if (ImGui::CalcTextSize(text.c_str()).x > room) {
        constexpr const char* kDots = "\xE2\x80\xA6";
        const float left = room - ImGui::CalcTextSize(kDots).x;
        const char* end = nullptr;
        ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), std::max(left, 1.0f), 0, text.c_str(), nullptr, &end);
        text = std::string(text.c_str(), end) + kDots;
    }
    ui::coloredText(ui::kDimText, text.c_str());
    ui::record("Message", ui::Kind::Label, message);
    ui::tooltip(message);
}

}  // namespace

void drawStatusBar(const Document& document, const ViewCounts& counts, double drawnScale, const BrushCost& cost,
                   const StrokeTiming& timing, BackgroundWork& work, const std::string& message) {
    ImGui::SetCursorPosY(5);
    const float least = ImGui::GetFontSize() * 19;  // for the dot and the message
    figures(figuresOf(counts, drawnScale), ImGui::GetContentRegionAvail().x - least);
    painting(cost, timing, counts.stats.bladesGeometry);
    savedDot(document);
    bakeProgress(work.occlusion, work.baking);
    exportProgress(work.exporting, work.writing);
    filmProgress(work.film);
    making(work.making, work.preparing);
    messageLine(message);
}

}  // namespace sward
