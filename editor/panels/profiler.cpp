// What a frame of the viewport is made of: one line a pass, named as its KHR_debug group.
#include <fmt/format.h>
#include <imgui.h>

#include "app/viewport.h"
#include "panels/frame_graph.h"
#include "panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

void cell(const std::string& text, bool right = true) {
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (right && room > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
    ImGui::TextUnformatted(text.c_str());
}

void row(const PassStats& p, bool measured) {
    ImGui::TableNextRow();
    cell(p.name, false);
    ui::record(p.name, ui::Kind::Label, fmt::format("{}", p.draws));
    cell(measured ? fmt::format("{:.2f}", p.ms) : "-");
    cell(fmt::format("{}", p.draws));
    cell(fmt::format("{}", p.instances));
    cell(measured ? fmt::format("{}", p.vertices) : "-");
    cell(measured ? fmt::format("{}", p.fragments) : "-");
}

}  // namespace

namespace {

void passes(const FrameStats& s, bool measured) {
    const int flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("passes", 6, flags)) return;
    ImGui::TableSetupColumn("Pass", 0, 3);
    for (const char* name : {"ms", "Draws", "Instances", "Vertices", "Fragments"})
        ImGui::TableSetupColumn(name, 0, 1.2f);
    ImGui::TableHeadersRow();
    for (const PassStats& p : s.passes) row(p, measured);
    ImGui::EndTable();
}

void speciesTable(ViewCounts& counts) {
    counts.wantsSpecies = true;
    const int flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingStretchProp;
    if (counts.species.empty()) return ImGui::TextDisabled("counted as soon as the picture rests");
    if (!ImGui::BeginTable("species", 4, flags)) return;
    ImGui::TableSetupColumn("Species", 0, 3);
    for (const char* name : {"Blades", "Drawn", "Share"}) ImGui::TableSetupColumn(name, 0, 1.2f);
    ImGui::TableHeadersRow();
    for (const SpeciesBlades& s : counts.species) {
        ImGui::TableNextRow();
        const std::string name = s.entity + " \xE2\x80\xBA " + s.species;
        cell(name, false);
        ui::record("Species " + s.entity + "/" + s.species, ui::Kind::Label, fmt::format("{}", s.drawn));
        ui::tooltip(
            "Blades: all that grow. Drawn: one by one in this view; the others are slices, farther tiers or "
            "out of sight.");
        cell(counted(static_cast<uint64_t>(s.population)));
        cell(counted(s.drawn));
        cell(s.population > 0 ? fmt::format("{:.3g} %", 100 * static_cast<double>(s.drawn) / s.population) : "-");
    }
    ImGui::EndTable();
}

}  // namespace

void drawProfiler(ViewCounts& counts, FrameTimes& times, bool measured, const std::string& gpuName) {
    const FrameStats& s = counts.stats;
    ui::checkbox("Measure", counts.measure);
    ui::tooltip("Times each pass and counts its work. Waits for the GPU after each, so that a frame takes longer.");
    ImGui::SameLine(0, 18);
    ImGui::PushTextWrapPos(0);
    ui::coloredText(ui::kDimText, fmt::format("{}  |  culling {:.0f} ms  |  {} cells  |  {:.0f} MB on the GPU", gpuName,
                                              s.cpuCullMs, s.cells, static_cast<double>(s.gpuBytes) / 1e6)
                                      .c_str());
    ImGui::PopTextWrapPos();
    ImGui::BeginChild("parts");
    const bool beside = ImGui::GetContentRegionAvail().x > 46 * ImGui::GetFontSize();
    if (ImGui::BeginTable("columns", beside ? 2 : 1, ImGuiTableFlags_SizingStretchProp)) {
        for (const float share : {1.0f, 1.6f})
            if (beside) ImGui::TableSetupColumn("", 0, share);
        ImGui::TableNextColumn();
        if (ui::section("Frames", "Frames")) drawFrameGraph(times, ImGui::GetFontSize() * 4);
        ImGui::TableNextColumn();
        if (ui::section("Passes", "Passes")) passes(s, measured);
        if (ui::section("Blades", "Blades by species")) speciesTable(counts);
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

}  // namespace sward
