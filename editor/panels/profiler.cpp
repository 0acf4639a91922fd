// What a frame of the viewport is made of: one line a pass, named as its KHR_debug group.
#include <fmt/format.h>
#include <imgui.h>

#include "app/viewport.h"
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

void drawProfiler(ViewCounts& counts, bool measured, const std::string& gpuName) {
    const FrameStats& s = counts.stats;
    ui::checkbox("Measure", counts.measure);
    ui::tooltip("Times each pass and counts its work. Waits for the GPU after each, so that a frame takes longer.");
    ImGui::SameLine(0, 18);
    ui::coloredText(ui::kDimText, fmt::format("{}  |  culling {:.2f} ms  |  {} cells  |  {:.1f} MB on the GPU", gpuName,
                                              s.cpuCullMs, s.cells, static_cast<double>(s.gpuBytes) / 1e6)
                                      .c_str());
    const int flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_ScrollY |
                      ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("passes", 6, flags)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Pass", 0, 3);
    for (const char* name : {"ms", "Draws", "Instances", "Vertices", "Fragments"})
        ImGui::TableSetupColumn(name, 0, 1.2f);
    ImGui::TableHeadersRow();
    for (const PassStats& p : s.passes) row(p, measured);
    ImGui::EndTable();
}

}  // namespace sward
